#include <fmt/format.h>

#include <array>

#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kMethodLabels = {"local (rasteriser)"sv, "cast (Appel 1968)"sv, "whitted (1980)"sv};
constexpr std::array kFresnelLabels = {"exact equations"sv, "constant kr, kt"sv};
constexpr std::array kGlassLabels = {"do not block"sv, "tint, straight through"sv, "block"sv};

struct KindRow {
    RayKind kind;
    const char* label;
    const char* key; // of its switch; null for eye rays
    bool needed;
    bool methodHasIt;
};

/// Switch, colour and live count of one kind of ray; or the line that says why there is none.
void kindRow(const Widgets& ui, const KindRow& row, const RayCounts& counts) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_CheckMark, colorOf(row.kind, ui.dark));
    if (row.key != nullptr) {
        ui.flag(row.label, row.key);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::Indent(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
        ImGui::TextUnformatted(row.label);
        ImGui::Unindent(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    }
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (!row.methodHasIt)
        ImGui::TextDisabled("not in this method");
    else if (!row.needed)
        ImGui::TextDisabled("not needed");
    else
        ImGui::TextColored(colorOf(row.kind, ui.dark), "%s", countText(counts[row.kind]).c_str());
}

}

void raysPanel(const Widgets& ui) {
    const TraceSettings& trace = ui.viewer.document().render.trace;
    ui.choice("Method", "method", kMethodNames, kMethodLabels);
    const auto world = ui.viewer.world();
    const SceneNeeds needs = world ? world->needs : SceneNeeds{true, true, true, true, {}};
    const RayCounts counts = ui.viewer.status().counts;
    const bool casts = trace.method != Method::Local, recurses = trace.method == Method::Whitted;
    if (ImGui::BeginTable("rays", 2)) {
        kindRow(ui, {RayKind::Eye, "Eye rays", nullptr, true, true}, counts);
        kindRow(ui, {RayKind::Shadow, "Shadow rays", "shadows", needs.shadows, casts}, counts);
        kindRow(ui, {RayKind::Reflection, "Reflection rays", "reflections", needs.reflections, recurses},
                counts);
        kindRow(ui, {RayKind::Refraction, "Refraction rays", "refractions", needs.refractions, recurses},
                counts);
        ImGui::EndTable();
    }
    ui.integer("Max depth", "max-depth", 0, kMaxDepth, true);
    ui.number("Cutoff", "cutoff", 0, 0.5F, "%.4f", true);
    ui.choice("At glass", "fresnel", kFresnelModeNames, kFresnelLabels);
    ui.choice("Glass shadows", "glass-shadows", kGlassShadowNames, kGlassLabels);
    for (const std::string& reason : needs.reasons) dimmedText(reason);
    if (!recurses) dimmedText("max depth, cutoff and weights at glass act in the method whitted");
}

}
