#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/document/document_commands.h"
#include "app/document/settings.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

/// What both sides of a comparison share: the index over the scene, and the number and size of samples.
constexpr std::array<std::string_view, 6> kShared = {"accel",   "threads", "aspect",
                                                     "samples", "seconds", "error"};

std::size_t indexOf(const std::vector<Layer>& layers, const std::string& name) {
    const auto found =
        std::find_if(layers.begin(), layers.end(), [&](const Layer& layer) { return layer.name == name; });
    return found == layers.end() ? 0 : static_cast<std::size_t>(found - layers.begin());
}

void layer(Document& document, const Command& command) {
    command.allowOnly({"name", "by"});
    if (const auto by = command.integer("by", -1000, 1000)) {
        const std::vector<Layer> layers = layersOf(*document.scene);
        const auto count = static_cast<int>(layers.size());
        const int next = (static_cast<int>(indexOf(layers, document.layer)) + *by) % count;
        document.layer = layers[static_cast<std::size_t>((next + count) % count)].name;
    } else {
        document.layer = layerNamed(command.required("name"), *document.scene).name;
    }
}

void compare(Document& document, const Command& command) {
    command.allowOnly({"on", "with", "equal", "split", "difference", "gain"});
    Comparison& comparison = document.comparison;
    if (const auto with = command.find("with")) {
        comparison.with = *with;
        otherSide(document);
    }
    if (const auto equal = command.choice("equal", kEqualShareNames))
        comparison.equal = static_cast<EqualShare>(*equal);
    comparison.split = command.number("split", 0, 1).value_or(comparison.split);
    comparison.gain = command.number("gain", 1, 1000).value_or(comparison.gain);
    comparison.difference = command.flag("difference").value_or(comparison.difference);
    const bool started = command.find("with") || command.flag("difference").value_or(false);
    const bool toggled = command.arguments().empty() != comparison.on;
    comparison.on = command.flag("on").value_or(started || toggled);
}

constexpr std::array kCommands = {
    DocumentCommand{"layer", "name=NAME by=±N", "Shows a layer of the picture, or the next one.", layer},
    DocumentCommand{
        "compare",
        "with=\"key=value …\"|rasterised equal=samples|seconds split=0…1 difference=on|off gain=G on=on|off",
        "Compares with the picture under other settings.", compare},
};

}

std::span<const DocumentCommand> viewCommands() { return kCommands; }

Layer shownLayer(const Document& document) {
    const std::vector<Layer> layers = layersOf(*document.scene);
    return layers[indexOf(layers, document.layer)];
}

Document otherSide(const Document& document) {
    if (document.comparison.isRasterised()) return document;
    const Command set = Command::parse("set " + document.comparison.with);
    for (const auto& [key, value] : set.arguments())
        if (std::find(kShared.begin(), kShared.end(), key) != kShared.end())
            throw InputError(fmt::format("compare with=\"{}\"", document.comparison.with),
                             fmt::format("both sides have the same {}", key),
                             "compare other settings, such as max-depth=1 or shadows=off");
    return apply(document, set);
}

}
