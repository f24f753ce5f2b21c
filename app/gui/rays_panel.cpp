#include <fmt/format.h>

#include <array>

#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kMethodLabels = {"local (rasteriser)"sv, "cast (Appel 1968)"sv, "whitted (1980)"sv,
                                      "distributed (Cook 1984)"sv, "path (Kajiya 1986)"sv};
constexpr std::array kMethodLines = {
    "local models alone: no shadow, mirror or glass", "and shadow rays; a lamp is one point",
    "and mirrors and glass, all sharp; ambient stands for the other light",
    "soft shadows, rough mirrors and glass; the sky is a lamp; no ambient. Noise fades with samples",
    "and light from one matte surface to another, in place of ambient. Noise fades with samples"};
constexpr std::array kSamplerLabels = {"independent"sv, "stratified 4 x 4"sv, "Sobol', scrambled"sv};
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
    dimmedText(kMethodLines[static_cast<std::size_t>(trace.method)]);
    const auto world = ui.viewer.world();
    const SceneNeeds needs =
        world ? world->needs : SceneNeeds{true, true, true, true, {}, {true, true, true, {}}};
    const RayCounts counts = ui.viewer.status().counts;
    const bool physical = isPhysical(trace.method), path = trace.method == Method::Path;
    const bool casts = trace.method != Method::Local, recurses = trace.method == Method::Whitted || physical;
    if (ImGui::BeginTable("rays", 2)) {
        kindRow(ui, {RayKind::Eye, "Eye rays", nullptr, true, true}, counts);
        const bool shadows = physical ? needs.physical.shadows : needs.shadows;
        const bool reflects = physical ? needs.physical.reflections : needs.reflections;
        kindRow(ui, {RayKind::Shadow, "Shadow rays", "shadows", shadows, casts}, counts);
        kindRow(ui, {RayKind::Reflection, "Reflection rays", "reflections", reflects, recurses}, counts);
        kindRow(ui, {RayKind::Refraction, "Refraction rays", "refractions", needs.refractions, recurses},
                counts);
        kindRow(ui, {RayKind::Diffuse, "Diffuse rays", "diffuse", needs.physical.diffuse, path}, counts);
        ImGui::EndTable();
    }
    ui.integer("Max depth", "max-depth", 0, kMaxDepth, true);
    if (path)
        dimmedText("no cutoff: roulette ends faint paths from depth 3 on; glass blocks shadow rays");
    else
        ui.number("Cutoff", "cutoff", 0, 0.5F, "%.4f", true);
    if (!physical) ui.choice("At glass", "fresnel", kFresnelModeNames, kFresnelLabels);
    if (!path) ui.choice("Glass shadows", "glass-shadows", kGlassShadowNames, kGlassLabels);
    if (physical) ui.choice("Sampler", "sampler", kSamplerNames, kSamplerLabels);
    for (const std::string& reason : physical ? needs.physical.reasons : needs.reasons) dimmedText(reason);
    if (!recurses) dimmedText("max depth, cutoff and weights at glass act from the method whitted on");
}

}
