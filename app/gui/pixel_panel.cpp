#include <fmt/format.h>

#include "app/gui/ledger_parts.h"
#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {

void pixelPanel(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked)
        return dimmedText("click the picture to see which rays a pixel is made of; arrows move the pixel");
    ImGui::Text("pixel (%d, %d), sample %d", picked->pixel.x, picked->pixel.y, picked->sample);
    swatch(ui, picked->trace.radiance);
    ImGui::SameLine();
    ImGui::TextUnformatted(colorText(picked->trace.radiance).c_str());
    RayCounts counts;
    for (const RayRecord& ray : picked->trace.rays) ++counts[ray.kind];
    for (const RayKind kind :
         {RayKind::Eye, RayKind::Shadow, RayKind::Reflection, RayKind::Refraction, RayKind::Diffuse}) {
        if (counts[kind] == 0) continue;
        ImGui::TextColored(colorOf(kind, ui.dark), "%s",
                           fmt::format("{} {}", counts[kind], name(kind)).c_str());
        ImGui::SameLine(0, ImGui::GetFontSize());
    }
    ImGui::NewLine();
    ui.button("Rays in space, tree and sum", "explain", "shows or hides what explains this pixel; key E");
}

}
