#include <fmt/format.h>

#include "app/gui/panels.h"

namespace eyeray {

void pixelPanel(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked)
        return dimmedText("click the picture to see which rays a pixel is made of; arrows move the pixel");
    const Color& c = picked->trace.radiance;
    ImGui::Text("pixel (%d, %d)", picked->pixel.x, picked->pixel.y);
    ImGui::SameLine();
    ImGui::ColorButton("##radiance", ImVec4(c.r, c.g, c.b, 1),
                       ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float);
    ImGui::SameLine();
    ImGui::Text("%.3f %.3f %.3f", static_cast<double>(c.r), static_cast<double>(c.g),
                static_cast<double>(c.b));
    const auto& rays = picked->trace.rays;
    dimmedText(fmt::format("{} rays of its sample {}", rays.size(), picked->sample));
    ui.button("Rays in space, tree and sum", "explain", "shows or hides what explains this pixel; key E");
}

}
