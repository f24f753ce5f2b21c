#include <fmt/format.h>

#include "app/gui/panels.h"
#include "app/gui/theme.h"

namespace eyeray {
namespace {

constexpr int kMostRows = 64;

/// The record may be of the scene before an edit, until the picture of the new one is there.
template <class Items>
std::string nameOf(const Items& items, int index) {
    const auto i = static_cast<std::size_t>(index);
    return index >= 0 && i < items.size() ? items[i].name : std::string("a lamp");
}

std::string endOf(const RayRecord& ray, const Scene& scene) {
    const auto objectName = [&] { return nameOf(scene.objects, ray.object); };
    const auto lampName = [&] { return nameOf(scene.lights, ray.light); };
    switch (ray.end) {
    case RayEnd::Hit:
        return ray.totalReflection ? objectName() + " (total reflection)" : objectName();
    case RayEnd::Background:
        return "background";
    case RayEnd::Unblocked:
        return "reaches " + lampName();
    case RayEnd::Blocked:
        return "blocked before " + lampName();
    }
    return {};
}

void rayRow(const Widgets& ui, const RayRecord& ray, const Scene& scene) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const float indent =
        ImGui::GetFontSize() * 0.6F * static_cast<float>(ray.depth + (ray.kind == RayKind::Shadow ? 1 : 0));
    if (indent > 0) ImGui::Indent(indent);
    ImGui::TextColored(colorOf(ray.kind, ui.dark), "%s", std::string(name(ray.kind)).c_str());
    if (indent > 0) ImGui::Unindent(indent);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(endOf(ray, scene).c_str());
    ImGui::TableNextColumn();
    if (std::isfinite(ray.t)) ImGui::Text("%.4g", static_cast<double>(ray.t));
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", static_cast<double>(maxComponent(ray.weight)));
}

}

void treeView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture to see the rays of a pixel");
    const auto& rays = picked->trace.rays;
    if (!ImGui::BeginTable("rays of the pixel", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
        return;
    ImGui::TableSetupColumn("ray", 0, 3);
    ImGui::TableSetupColumn("meets", 0, 4);
    ImGui::TableSetupColumn("t (m)", 0, 1.6F);
    ImGui::TableSetupColumn("weight", 0, 1.6F);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < rays.size() && i < kMostRows; ++i)
        rayRow(ui, rays[i], *ui.viewer.document().scene);
    ImGui::EndTable();
    if (rays.size() > kMostRows) dimmedText(fmt::format("and {} more", rays.size() - kMostRows));
}

}
