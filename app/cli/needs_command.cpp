#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/run.h"
#include "app/document/document_needs.h"
#include "app/document/saved_scene.h"
#include "core/base/errors.h"
#include "core/scene/gltf.h"

namespace eyeray {
namespace {

constexpr auto kInterval = std::chrono::milliseconds(20);

/// Asks for a stop when the program is interrupted, from a thread of its own.
class StopByInterrupt {
public:
    StopByInterrupt()
        : watch_([this](const std::stop_token& end) {
              while (!end.stop_requested() && !interrupted()) std::this_thread::sleep_for(kInterval);
              if (interrupted()) source_.request_stop();
          }) {
        heedInterrupts();
    }
    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread watch_;
};

nlohmann::ordered_json asJson(const ModelError& error) {
    return {{"steps", error.steps}, {"flip", error.flip}};
}

nlohmann::ordered_json asJson(const NeedItem& item) {
    nlohmann::ordered_json json{{"what", item.what},
                                {"from", item.from},
                                {"to", item.to},
                                {"how", item.proved ? "proved" : "measured"},
                                {"reason", item.reason},
                                {"saving", item.saving},
                                {"error", asJson(item.error)}};
    if (!item.takenBack.empty()) json["taken_back"] = item.takenBack;
    return json;
}

std::vector<std::string> changes(const Document& from, const MeasuredNeeds& needs) {
    std::vector<std::string> lines;
    for (const Command& command : commandsBetween(from, withNeeded(from, needs)))
        lines.push_back(command.text());
    return lines;
}

std::string jsonOf(const OpenedScene& opened, const MeasuredNeeds& needs) {
    nlohmann::ordered_json json{
        {"scene", opened.reference},
        {"tolerance", needs.tolerance},
        {"width", needs.width},
        {"height", needs.height},
        {"index", indexName(needs)},
        {"compared_samples", needs.comparedSamples},
        {"compared", needs.inBlocks ? "blocks" : "pixels"},
        {"tiles", needs.tiles},
        {"of_tiles", needs.ofTiles},
        {"items", nlohmann::ordered_json::array()},
        {"seconds", {{"as_set", needs.secondsAsSet}, {"needed", needs.secondsNeeded}}},
        {"speed_up", needs.speedUp()},
        {"error", asJson(needs.error)},
        {"commands", changes(opened.document, needs)}};
    for (const NeedItem& item : needs.items) json["items"].push_back(asJson(item));
    return json.dump(2) + "\n";
}

std::string tableOf(const OpenedScene& opened, const MeasuredNeeds& needs) {
    std::string text = fmt::format("{}, {}\n", opened.reference, measureText(needs));
    std::size_t what = 0, change = 0;
    for (const NeedItem& item : needs.items) {
        what = std::max(what, item.what.size());
        change = std::max(change, changeText(item).size());
    }
    for (const NeedItem& item : needs.items) {
        text += fmt::format("{:8}  {:{}}  {:{}}  saves {:9}  error {:19}  {}\n",
                            item.proved ? "proved" : "measured", item.what, what, changeText(item), change,
                            savingText(item), errorText(item.error), item.reason);
        if (!item.takenBack.empty()) text += fmt::format("{:10}taken back: {}\n", "", item.takenBack);
    }
    return text + summaryText(needs) + "\n";
}

void write(const std::filesystem::path& output, const Document& document, const MeasuredNeeds& needs) {
    Document smaller = withNeeded(document, needs);
    smaller.render.display = needs.display;
    Scene scene = savedScene(smaller);
    scene.settings.push_back(
        fmt::format("set samples={} error={}", needs.needed.samples, toText(document.render.stop.error)));
    exportGltf(scene, output);
}

void checkGltf(const std::filesystem::path& output) {
    const auto ending = output.extension();
    if (ending != ".gltf" && ending != ".glb")
        throw InputError(output.string(), "a scene is written as glTF", "end its name in .gltf or .glb");
    checkFolder(output);
}

}

int run(const NeedsOptions& options) {
    if (options.apply) checkGltf(options.output);
    const OpenedScene opened = openFor(options.picture);
    RenderSettings sized;
    setSize(sized, options.picture, opened.document.aspect);
    NeedsPlan plan = needsPlan(opened.document, sized.width, sized.height, opened.meterExposure);
    plan.tolerance = options.tolerance;
    const StopByInterrupt interrupt;
    const auto stepping = [&](std::size_t steps) {
        return [progress = std::make_shared<Progress>(steps, !options.quiet)](const std::string& doing) {
            progress->step(doing);
        };
    };
    auto needs = measureNeeds(plan, stepping(stepsToMeasure()), interrupt.token());
    if (needs && options.apply)
        needs = checkNeeds(plan, *needs, stepping(stepsToCheck(*needs)), interrupt.token());
    if (!needs) {
        fmt::print(stderr, "eyeray: interrupted: nothing is written\n");
        return 1;
    }
    if (options.apply) write(options.output, opened.document, *needs);
    printWhole(options.json ? jsonOf(opened, *needs) : tableOf(opened, *needs));
    return 0;
}

}
