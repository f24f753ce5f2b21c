#include "app/gui/theme.h"
#include "app/gui/tree_parts.h"
#include "core/study/ray_row.h"

namespace eyeray {
namespace {

/// Nodes from the eye ray to this one.
int levelOf(const TreeDiagram& diagram, const DiagramNode& node) {
    int level = 0;
    for (int parent = node.parent; parent >= 0; ++level)
        parent = diagram.nodes[static_cast<std::size_t>(parent)].parent;
    return level;
}

void firstCell(const Widgets& ui, const TreeDiagram& diagram, const DiagramNode& node,
               const std::string& label) {
    const bool selected = node.traced && node.ray == ui.viewer.selectedRay();
    const float indent = 0.8F * ImGui::GetFontSize() * static_cast<float>(levelOf(diagram, node));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(node.kind, ui.dark));
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyle().Colors[ImGuiCol_FrameBgActive]);
    const bool clicked = ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_SpanAllColumns);
    ImGui::PopStyleColor(2);
    if (node.traced) ui.mark("row " + std::to_string(node.ray));
    if (clicked) selectRay(ui, node.ray);
}

void tableRow(const Widgets& ui, const TreeDiagram& diagram, const DiagramNode& node) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (!node.traced) {
        firstCell(ui, diagram, node, node.title + " " + node.detail);
        return;
    }
    const auto world = ui.viewer.world();
    const RayRow row = rayRow(ui.viewer.picked()->trace, ui.viewer.study().family(),
                              *ui.viewer.document().scene, world ? world->origin : DVec3(0), node.ray);
    firstCell(ui, diagram, node, row[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row[i].c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(indexWork(ui, node.ray).c_str());
}

}

void treeTable(const Widgets& ui) {
    const TreeDiagram& diagram = ui.viewer.study().diagram();
    constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                            ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit |
                            ImGuiTableFlags_Resizable;
    if (!ImGui::BeginTable("rays", static_cast<int>(kRayHeadings.size()) + 1, kFlags)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const std::string_view heading : kRayHeadings) ImGui::TableSetupColumn(std::string(heading).c_str());
    ImGui::TableSetupColumn("index");
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(diagram.nodes.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            tableRow(ui, diagram, diagram.nodes[static_cast<std::size_t>(i)]);
            ImGui::PopID();
        }
    ImGui::EndTable();
}

}
