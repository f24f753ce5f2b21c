#include <fmt/format.h>

#include <array>

#include "app/gui/panels.h"
#include "core/scene/choose_index.h"
#include "core/study/layer_picture.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kToneMapLabels = {"none (linear)"sv, "clamp"sv, "Reinhard 2002"sv,
                                       "ACES (Narkowicz 2015)"sv};
constexpr std::array kAccelLabels = {"auto"sv, "brute force"sv, "BVH of two"sv, "BVH of eight (SIMD)"sv};

/// Which layer of the picture is shown.
void layerChoice(const Widgets& ui) {
    const Layer shown = shownLayer(ui.viewer.document());
    labelled("Layer");
    const bool open = ImGui::BeginCombo("##layer", shown.name.c_str());
    ui.mark("layer");
    ui.tooltip(aboutLayer(shown));
    if (!open) return;
    for (const Layer& layer : layersOf(*ui.viewer.document().scene)) {
        if (ImGui::Selectable(layer.name.c_str(), layer == shown))
            ui.execute({"layer", {{"name", layer.name}}}, {});
        ui.mark("layer=" + layer.name);
        ui.tooltip(aboutLayer(layer));
    }
    ImGui::EndCombo();
}

/// Which index finds hits; of `auto` also what it becomes.
void indexChoice(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    const auto index = static_cast<std::size_t>(chooseIndex(*document.scene, buildSettings(document)));
    const std::string automatic = fmt::format("auto: {}", kAccelLabels[index]);
    auto labels = kAccelLabels;
    if (document.accel == AccelKind::Auto) labels[0] = automatic;
    ui.choice("Accelerator", "accel", kAccelNames, labels);
}

}

void displayPanel(const Widgets& ui) {
    layerChoice(ui);
    ui.number("Exposure", "exposure", -8, 8, "%+.1f EV");
    ui.choice("Tone mapping", "tonemap", kToneMapNames, kToneMapLabels);
    ui.integer("Samples", "samples", 1, 4096, true);
    ui.number("Error", "error", 0, 0.1F, "%.4f", true);
    ui.flag("Adaptive: samples where the noise is", "adaptive");
    indexChoice(ui);
}

}
