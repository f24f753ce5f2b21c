#pragma once
// What a RenderSession has traced, on the graphics card as displayed.

#include <cstdint>
#include <optional>

#include "app/gl/texture.h"
#include "core/render/render_session.h"

namespace eyeray {

class FilmTexture {
public:
    explicit FilmTexture(const Gl& gl) : texture_(gl) {}

    /// Takes over the tiles that have changed since the last time.
    void refresh(const RenderSession&, const DisplaySettings&);

    const ByteImage& shown() const { return shown_; }
    const GlTexture& texture() const { return texture_; }
    /// Changes whenever what is shown does.
    std::uint64_t version() const { return version_; }

private:
    void show(const std::vector<Tile>&, const DisplaySettings&);

    GlTexture texture_;
    Picture picture_;
    ByteImage shown_;
    std::uint64_t version_ = 0;
    std::optional<DisplaySettings> display_; // that `shown_` was made with
};

}
