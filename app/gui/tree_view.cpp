#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "app/gui/tree_parts.h"
#include "core/study/ray_row.h"
#include "core/study/ray_traversal.h"

namespace eyeray {
namespace {

constexpr float kDetailsWidth = 19, kLeastDiagram = 26; // in heights of a letter

/// A checkbox that says `tree kind=… on=…`.
void kindSwitch(const Widgets& ui, const char* kind, bool shown, const ImVec4& color) {
    flow(ImGui::CalcTextSize(kind).x + 2 * ImGui::GetFrameHeight());
    ImGui::PushStyleColor(ImGuiCol_CheckMark, color);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    const bool changed = ImGui::Checkbox(kind, &shown);
    ImGui::PopStyleColor(2);
    ui.mark(std::string("tree ") + kind);
    if (changed) ui.execute({"tree", {{"kind", kind}, {"on", toText(shown)}}}, {});
}

void formButton(const Widgets& ui, const char* label, const char* name, bool current) {
    if (current) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_ButtonActive]);
    const bool pressed = ImGui::Button(label);
    if (current) ImGui::PopStyleColor();
    ui.mark(std::string("tree=") + name);
    if (pressed) ui.execute({"tree", {{"show", name}}}, {});
}

void controls(const Widgets& ui) {
    const StudySettings& settings = ui.viewer.study().settings();
    formButton(ui, "Diagram", "diagram", !settings.table);
    ImGui::SameLine();
    formButton(ui, "Table", "table", settings.table);
    for (const RayKind kind : {RayKind::Shadow, RayKind::Reflection, RayKind::Refraction})
        kindSwitch(ui, std::string(name(kind)).c_str(), settings.filter.kinds[static_cast<std::size_t>(kind)],
                   colorOf(kind, ui.dark));
    kindSwitch(ui, "untraced", settings.filter.untraced, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ui.tooltip("rays that were not traced, and why");
    float least = settings.filter.leastWeight;
    const float width = ImGui::GetFontSize() * 9;
    flow(width);
    ImGui::SetNextItemWidth(width);
    const bool changed = ImGui::SliderFloat("##least weight", &least, 0, 1, "weight ≥ %.3f",
                                            ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    ui.mark("tree least-weight");
    ui.tooltip("hides rays of a smaller weight, and all that hangs on them");
    if (changed) ui.execute({"tree", {{"least-weight", toText(static_cast<double>(least))}}}, {});
}

}

void selectRay(const Widgets& ui, int ray) {
    ui.execute({"select-ray", {{"index", std::to_string(ray)}}}, {});
}

void rayDetails(const Widgets& ui) {
    const PickedSample& picked = *ui.viewer.picked();
    const auto world = ui.viewer.world();
    const RayRow row = rayRow(picked.trace, ui.viewer.study().family(), *ui.viewer.document().scene,
                              world ? world->origin : DVec3(0), ui.viewer.selectedRay());
    const RayKind kind = picked.trace.rays[static_cast<std::size_t>(ui.viewer.selectedRay())].kind;
    ImGui::TextColored(colorOf(kind, ui.dark), "%s", row[0].c_str());
    if (!ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    const auto line = [](const std::string& heading, const std::string& value) {
        if (value.empty()) return;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", heading.c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", value.c_str());
    };
    for (std::size_t i = 1; i < row.size(); ++i) {
        line(std::string(kRayHeadings[i]), row[i]);
        if (kRayHeadings[i] == "t") line("index", indexWork(ui, ui.viewer.selectedRay()));
    }
    ImGui::EndTable();
}

std::string indexWork(const Widgets& ui, int ray) {
    const auto world = ui.viewer.shownWorld();
    if (!world) return {};
    const TraceSettings& settings = ui.viewer.document().render.trace;
    return traversalText(traversalOf(*world, settings, ui.viewer.picked()->trace, ray), *world);
}

void treeView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture to see the rays of a pixel");
    if (picked->trace.rays.empty()) return dimmedText("no ray was traced for this sample");
    controls(ui);
    const float letter = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const bool table = ui.viewer.study().settings().table; // which has the details in its columns
    const bool details = !table && width > (kDetailsWidth + kLeastDiagram) * letter;
    ImGui::BeginChild("tree", {details ? width - kDetailsWidth * letter : 0, 0}, false,
                      ImGuiWindowFlags_HorizontalScrollbar);
    table ? treeTable(ui) : treeDiagram(ui);
    ImGui::EndChild();
    if (!details) return;
    ImGui::SameLine();
    ImGui::BeginChild("details", {0, 0}, false);
    rayDetails(ui);
    ImGui::EndChild();
}

}
