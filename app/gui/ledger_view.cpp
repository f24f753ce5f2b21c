#include <fmt/format.h>

#include "app/gui/ledger_parts.h"
#include "app/gui/panels.h"

namespace eyeray {
namespace {

void chooseSample(const Widgets& ui) {
    const int sample = ui.viewer.picked()->sample;
    const auto go = [&](int n) { ui.execute({"sample", {{"n", fmt::format("{}", n)}}}, {}); };
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Sample");
    ImGui::SameLine();
    if (ImGui::ArrowButton("##before", ImGuiDir_Left) && sample > 0) go(sample - 1);
    ui.mark("sample before");
    ImGui::SameLine();
    ImGui::Text("%d", sample);
    ImGui::SameLine();
    if (ImGui::ArrowButton("##after", ImGuiDir_Right)) go(sample + 1);
    ui.mark("sample after");
    ui.tooltip("which sample of the pixel; 0 goes through its centre");
}

void chooseNotation(const Widgets& ui) {
    const auto now = static_cast<std::size_t>(ui.viewer.study().settings().notation);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
    const bool open = ImGui::BeginCombo("##notation", std::string(kNotationLabels[now]).c_str());
    ui.mark("notation");
    if (!open) return ui.tooltip("whose letters the sum is written in");
    for (std::size_t i = 0; i < kNotationNames.size(); ++i) {
        if (ImGui::Selectable(std::string(kNotationLabels[i]).c_str(), i == now))
            ui.execute({"notation", {{"name", std::string(kNotationNames[i])}}}, {});
        ui.mark(fmt::format("notation={}", kNotationNames[i]));
    }
    ImGui::EndCombo();
}

void chooseShape(const Widgets& ui) {
    const bool flat = ui.viewer.study().settings().flatSum;
    const auto choice = [&](const char* label, bool on) {
        ImGui::SameLine();
        if (ImGui::RadioButton(label, flat == on))
            ui.execute({"sum", {{"show", on ? "flat" : "nested"}}}, {});
        ui.mark(label);
    };
    choice("nested", false);
    ui.tooltip("each ray's sum within that of the ray before");
    choice("flat list", true);
    ui.tooltip(
        "throughput · f cos / pdf · MIS weight · radiance · visibility, for each way that light takes");
}

}

void ledgerView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture to see what a pixel's colour is the sum of");
    if (picked->trace.rays.empty()) return dimmedText("no ray was traced for this sample");
    chooseSample(ui);
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    chooseNotation(ui);
    const bool physical = picked && picked->trace.physical; // another sample may not be there yet
    if (physical) chooseShape(ui);
    if (physical && ui.viewer.study().settings().flatSum) return pathSum(ui);
    if (picked) ledgerLines(ui);
}

}
