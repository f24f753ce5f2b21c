#include "app/gui/film_texture.h"

namespace eyeray {

void FilmTexture::refresh(const RenderSession& session, const DisplaySettings& display) {
    std::vector<Tile> changed = session.read(picture_);
    if (picture_.radiance.empty()) return;
    const int width = picture_.radiance.width(), height = picture_.radiance.height();
    if (display_ != display || shown_.width() != width || shown_.height() != height) {
        shown_ = ByteImage(width, height);
        changed = {{0, 0, width, height}};
        display_ = display;
    }
    if (!changed.empty()) show(changed, display);
}

void FilmTexture::show(const std::vector<Tile>& tiles, const DisplaySettings& settings) {
    ++version_;
    std::size_t pixels = 0;
    for (const Tile& tile : tiles) {
        const auto columns = static_cast<std::size_t>(tile.x1 - tile.x0);
        for (int y = tile.y0; y < tile.y1; ++y)
            display({&picture_.radiance.at(tile.x0, y), columns}, settings,
                    {&shown_.at(tile.x0, y), columns});
        pixels += columns * static_cast<std::size_t>(tile.y1 - tile.y0);
    }
    const bool sameSize = texture_.width() == shown_.width() && texture_.height() == shown_.height();
    if (!sameSize || pixels * 2 > shown_.values().size()) return texture_.upload(shown_);
    for (const Tile& tile : tiles)
        texture_.upload(shown_, {tile.x0, tile.y0, tile.x1 - tile.x0, tile.y1 - tile.y0});
}

}
