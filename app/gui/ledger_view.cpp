#include <fmt/format.h>

#include "app/gui/ledger_parts.h"
#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

/// A colour, as displayed and in numbers, after a word.
void colorLine(const Widgets& ui, const char* word, const Color& radiance, const char* name) {
    ImGui::TextUnformatted(word);
    ImGui::SameLine();
    swatch(ui, radiance);
    ui.mark(name);
    ImGui::SameLine();
    ImGui::TextUnformatted(colorText(radiance).c_str());
}

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
    const bool open = ImGui::BeginCombo("##notation", kNotationLabels[now].data());
    ui.mark("notation");
    if (!open) return ui.tooltip("whose letters the sum is written in");
    for (std::size_t i = 0; i < kNotationNames.size(); ++i) {
        if (ImGui::Selectable(kNotationLabels[i].data(), i == now))
            ui.execute({"notation", {{"name", std::string(kNotationNames[i])}}}, {});
        ui.mark(fmt::format("notation={}", kNotationNames[i]));
    }
    ImGui::EndCombo();
}

void heading(const Widgets& ui) {
    const PixelStudy& study = ui.viewer.study();
    chooseSample(ui);
    ImGui::SameLine();
    chooseNotation(ui);
    const Color sum = evaluate(study.ledger());
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    colorLine(ui, "=", sum, "ledger total");
    if (!study.strikes().empty()) {
        ImGui::SameLine(0, 2 * ImGui::GetFontSize());
        colorLine(ui, "without what is struck out", evaluate(study.ledger(), study.strikes()),
                  "ledger struck");
        ImGui::SameLine();
        ui.button("Bring all back", "strike", "undoes what was struck out");
    }
    if (sum == ui.viewer.picked()->trace.radiance)
        ImGui::TextColored(doneColor(ui.dark), "the sum is the film's value, bit for bit");
    else
        ImGui::TextColored(errorColor(ui.dark), "the sum differs from the film's value");
}

void meanLine(const Widgets& ui) {
    const PixelStudy& study = ui.viewer.study();
    const int samples = study.mean().samples(), passes = study.film().passes;
    if (samples == 0) return;
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    colorLine(ui, fmt::format("mean of {} sample{}", samples, samples == 1 ? "" : "s").c_str(),
              study.mean().value(), "ledger mean");
    ImGui::SameLine();
    if (samples < passes)
        ImGui::TextDisabled("of %d", passes);
    else if (study.mean().value() == study.film().mean)
        ImGui::TextColored(doneColor(ui.dark), "= film, bit for bit");
}

}

void ledgerView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture to see what a pixel's colour is the sum of");
    if (picked->trace.rays.empty()) return dimmedText("no ray was traced for this sample");
    heading(ui);
    meanLine(ui);
    ledgerLines(ui);
}

}
