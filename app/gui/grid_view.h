#pragma once
// The coarse picture that is played pixel by pixel, so far.

#include "app/gl/texture.h"
#include "app/gui/widgets.h"

namespace eyeray {

class GridView {
public:
    explicit GridView(const Gl& gl) : texture_(gl) {}

    /// Takes over what has been traced; pixels that are still to come have a colour of the theme.
    void refresh(const Viewer&, bool dark);

    /// Draws it over the picture, with the grid and a frame around the last pixel.
    void draw(const Widgets&, ImVec2 corner, ImVec2 size) const;

    const GlTexture& texture() const { return texture_; } // one texel to a cell
    /// Changes whenever what is shown does.
    std::uint64_t version() const { return version_; }

private:
    GlTexture texture_;
    ByteImage shown_;
    std::uint64_t version_ = 0;
};

}
