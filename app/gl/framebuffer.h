#pragma once
// A picture to draw into that is no window.

#include <algorithm>
#include <optional>

#include "app/gl/texture.h"

namespace eyeray {

inline constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT32F;

/// Throws Failure unless the bound framebuffer, of this size, can be drawn into.
void requireComplete(const Gl& gl, int width, int height);

/// OpenGL's row 0, the lowest on a screen, becomes the last row.
template <class T>
void flipRows(Pixels<T>& image) {
    for (int y = 0; y < image.height() / 2; ++y)
        std::swap_ranges(&image.at(0, y), &image.at(0, y) + image.width(),
                         &image.at(0, image.height() - 1 - y));
}

/// An RGBA8 colour texture with the framebuffer that draws into it, with a depth buffer if asked.
class Framebuffer {
public:
    enum class Depth : std::uint8_t { Without, With };

    /// Throws Failure when the graphics card refuses this size.
    Framebuffer(const Gl& gl, int width, int height, Depth depth = Depth::Without);

    /// Directs drawing into it, over its whole area, until another framebuffer is bound.
    void bind() const;

    /// What has been drawn, top row first.
    ByteImage read() const;

    /// Depth of each pixel, 0 near to 1 far, top row first.
    Pixels<float> readDepth() const;

    const GlTexture& color() const { return color_; }
    bool hasDepth() const { return depth_.has_value(); }

private:
    const Gl* gl_;
    Handle handle_;
    GlTexture color_;
    std::optional<Handle> depth_;
};

}
