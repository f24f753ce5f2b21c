#include "app/gui/raster_view.h"

#include <algorithm>

namespace eyeray {

void RasterView::refresh(const Viewer& viewer) {
    const Document& document = viewer.document();
    const DrawnFor now{viewer.world(), document.camera, viewer.pictureSize(), shownDisplay(document.render)};
    if (!now.world || now == drawnFor_) return;
    if (!rasteriser_) rasteriser_.emplace(gl_);
    radiance_ = std::make_shared<const ColorImage>(
        rasteriser_->draw(now.world, now.camera, now.size.width, now.size.height).radiance);
    shown_ = display(*radiance_, now.display);
    texture_.upload(shown_);
    ++version_;
    drawnFor_ = now;
}

void RasterView::note(const Widgets& ui, ImVec2 corner) const {
    constexpr const char* kText = "rasterised by OpenGL: local illumination, z-buffer (G)";
    const float pad = 5 * ui.scale, wrap = std::max(1.0F, static_cast<float>(shown_.width()) - 4 * pad);
    const ImVec2 size = ImGui::CalcTextSize(kText, nullptr, false, wrap);
    const ImVec2 at{corner.x + 2 * pad, corner.y + 2 * pad};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad},
                        IM_COL32(0, 0, 0, 170), pad);
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, IM_COL32_WHITE, kText, nullptr, wrap);
}

}
