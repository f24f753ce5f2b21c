#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/gui/compare_view.h"
#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

struct Preset {
    const char* label;
    const char* with;
};
constexpr std::array kPresets = {Preset{"rasterised by OpenGL", Comparison::kRasterised},
                                 Preset{"depth 1", "max-depth=1"},
                                 Preset{"depth 0: eye rays alone", "max-depth=0"},
                                 Preset{"no shadow rays", "shadows=off"},
                                 Preset{"no reflection rays", "reflections=off"},
                                 Preset{"no refraction rays", "refractions=off"},
                                 Preset{"local: as a rasteriser", "method=local"},
                                 Preset{"cast: Appel 1968", "method=cast"},
                                 Preset{"constant weights at glass", "fresnel=constant"},
                                 Preset{"glass blocks light", "glass-shadows=all"},
                                 Preset{"cutoff 0.05", "cutoff=0.05"}};

void presets(const Widgets& ui, const Comparison& comparison) {
    const auto* const chosen = std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& preset) {
        return comparison.with == preset.with;
    });
    labelled("Left side");
    const bool open = ImGui::BeginCombo("##with", chosen != kPresets.end() ? chosen->label : "as below");
    ui.mark("compare with");
    ui.tooltip("settings of the other side, which stands on the left");
    if (!open) return;
    for (const Preset& preset : kPresets) {
        if (ImGui::Selectable(preset.label, comparison.with == preset.with))
            ui.execute({"compare", {{"with", preset.with}}}, {});
        ui.mark(std::string("compare ") + preset.with);
    }
    ImGui::EndCombo();
}

void anySettings(const Widgets& ui, const Comparison& comparison) {
    std::array<char, 200> text{};
    comparison.with.copy(text.data(), text.size() - 1);
    labelled("Its settings");
    if (ImGui::InputText("##settings", text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue))
        ui.execute({"compare", {{"with", text.data()}}}, {});
    ui.mark("compare settings");
    ui.tooltip("any settings, such as max-depth=2 cutoff=0; Enter compares with them");
}

void equalShare(const Widgets& ui, const Comparison& comparison) {
    labelled("Equal");
    const auto choice = [&](EqualShare share, const char* tooltip) {
        const std::string name(kEqualShareNames[static_cast<std::size_t>(share)]);
        if (ImGui::RadioButton(name.c_str(), comparison.equal == share))
            ui.part({"compare"}, "equal", name, false);
        ui.mark("compare equal=" + name);
        ui.tooltip(tooltip);
    };
    choice(EqualShare::Samples, "both sides have the same number of samples, of the same random numbers");
    ImGui::SameLine();
    choice(EqualShare::Seconds, "both sides are traced for the same time: the faster one has more samples");
}

void countCell(std::uint64_t count, const ImVec4& color) {
    ImGui::TableNextColumn();
    ImGui::TextColored(color, "%s", countText(count).c_str());
}

void counts(const Widgets& ui, const PictureChange& change) {
    if (!ImGui::BeginTable("compared rays", 3, ImGuiTableFlags_RowBg)) return;
    for (const char* const heading : {"rays", "left", "right"}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    for (int i = 0; i < kRayKinds; ++i) {
        const auto kind = static_cast<RayKind>(i);
        if (change.here[kind] == 0 && change.there[kind] == 0) continue;
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(std::string(name(kind)).c_str());
        countCell(change.there[kind], colorOf(kind, ui.dark));
        countCell(change.here[kind], colorOf(kind, ui.dark));
    }
    ImGui::EndTable();
}

}

void comparePanel(const Widgets& ui) {
    const Comparison& comparison = ui.viewer.document().comparison;
    ui.partFlag({"compare"}, "Split view", "on", comparison.on);
    ImGui::SameLine();
    ui.partFlag({"compare"}, "Difference", "difference", comparison.on && comparison.difference);
    presets(ui, comparison);
    anySettings(ui, comparison);
    if (!comparison.isRasterised()) equalShare(ui, comparison);
    ui.partNumber({"compare"}, "Gain", "gain", comparison.gain, 1, 100, "%.0f x", true);
    if (!comparison.on) return;
    const auto& change = ui.viewer.comparison().change();
    if (!change) return dimmedText("tracing both sides");
    dimmedText(changeText(*change));
    counts(ui, *change);
}

}
