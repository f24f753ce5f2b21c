#include <fmt/format.h>

#include "app/gui/panels.h"

namespace eyeray {
namespace {

void demoChoice(const Widgets& ui, const LabDemo* shown) {
    ImGui::SetNextItemWidth(-1);
    const std::string preview(shown != nullptr ? shown->title : "choose a demonstration");
    const bool open = ImGui::BeginCombo("##lab", preview.c_str(), ImGuiComboFlags_HeightLargest);
    ui.mark("lab");
    ui.tooltip("where textbook formulas fail: the naive side on the left, the robust one on the right");
    if (!open) return;
    for (const LabDemo& demo : labDemos()) {
        if (ImGui::Selectable(std::string(demo.title).c_str(), &demo == shown))
            ui.execute({"open", {{"scene", std::string(demo.name)}}}, {});
        ui.mark(fmt::format("lab={}", demo.name));
        ui.tooltip(demo.why);
    }
    ImGui::EndCombo();
}

const char* formatOf(const LabSlider& slider) {
    if (slider.whole) return "%.0f";
    return slider.logarithmic ? "%.4g" : "%.1f";
}

/// The faults that explain a student's picture best; a click compares with one.
void suspects(const Widgets& ui) {
    constexpr std::size_t kMost = 5;
    const auto& report = ui.viewer.naming().report();
    if (ui.viewer.naming().running()) dimmedText("tracing the scene with each fault");
    if (!report) return;
    dimmedText(fmt::format("{}, by what is left unexplained:", report->picture.filename().string()));
    for (std::size_t i = 0; i < std::min(kMost, report->bug.ranked.size()); ++i) {
        const FaultMatch& match = report->bug.ranked[i];
        const std::string name = toText(match.faults);
        if (ImGui::Selectable(fmt::format("{:.3f}  {}", match.rmse, name).c_str()))
            ui.execute({"compare", {{"with", "fault=" + name}}}, {});
        ui.mark("suspect " + name);
        if (!match.faults.empty()) ui.tooltip(describe(faultNamed(name)).wrong);
    }
}

}

void labPanel(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    demoChoice(ui, document.lab);
    if (document.lab != nullptr) {
        const LabSlider& slider = document.lab->slider;
        ui.partNumber({"lab"}, std::string(slider.label).c_str(), "value", document.labValue, slider.lowest,
                      slider.highest, formatOf(slider), slider.logarithmic);
        dimmedText(std::string(document.lab->fix));
    }
    ui.partFlag({"mark-wrong"}, "Mark wrong pixels", "on", document.comparison.marks);
    ui.button("Name that bug…", "dialog show=name-bug",
              "a student's picture of this scene: which mistake explains it?");
    suspects(ui);
}

}
