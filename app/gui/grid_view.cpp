#include "app/gui/grid_view.h"

#include <algorithm>

#include "app/gl/imgui_renderer.h"

namespace eyeray {
namespace {

constexpr Rgba8 kEmptyDark{38, 43, 54}, kEmptyLight{214, 220, 230};

}

void GridView::refresh(const Viewer& viewer, bool dark) {
    const GridPlayer& player = viewer.gridPlayer();
    std::vector<Color> radiance;
    for (const GridPixel& pixel : player.traced()) radiance.push_back(pixel.radiance);
    ByteImage image(player.grid().columns, player.grid().rows, dark ? kEmptyDark : kEmptyLight);
    display(radiance, shownDisplay(viewer.document().render),
            std::span(image.values()).first(radiance.size()));
    if (image == shown_) return;
    shown_ = std::move(image);
    texture_.upload(shown_);
    ++version_;
}

void GridView::draw(const Widgets& ui, ImVec2 corner, ImVec2 size) const {
    const GridPlayer& player = ui.viewer.gridPlayer();
    const PixelGrid& grid = player.grid();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 opposite{corner.x + size.x, corner.y + size.y};
    list.AddImage(textureId(texture_), corner, opposite);
    const auto column = [&](int i) {
        return std::round(corner.x + size.x * static_cast<float>(i) / static_cast<float>(grid.columns));
    };
    const auto row = [&](int i) {
        return std::round(corner.y + size.y * static_cast<float>(i) / static_cast<float>(grid.rows));
    };
    const ImU32 line = ui.dark ? IM_COL32(255, 255, 255, 34) : IM_COL32(0, 0, 0, 44);
    for (int i = 1; i < grid.columns; ++i)
        list.AddLine({column(i), corner.y}, {column(i), opposite.y}, line, ui.scale);
    for (int i = 1; i < grid.rows; ++i)
        list.AddLine({corner.x, row(i)}, {opposite.x, row(i)}, line, ui.scale);
    const auto cell = player.current();
    if (!cell) return;
    const ImVec2 lo{column(grid.column(*cell)), row(grid.row(*cell))};
    const ImVec2 hi{column(grid.column(*cell) + 1), row(grid.row(*cell) + 1)};
    list.AddRect(lo, hi, IM_COL32(0, 0, 0, 255), 0, 0, 4.5F * ui.scale);
    list.AddRect(lo, hi, IM_COL32(255, 255, 255, 255), 0, 0, 2 * ui.scale);
}

}
