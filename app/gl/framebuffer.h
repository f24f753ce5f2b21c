#pragma once
// A picture to draw into that is no window.

#include "app/gl/texture.h"

namespace eyeray {

/// An RGBA8 colour texture with the framebuffer that draws into it.
class Framebuffer {
public:
    /// Throws Failure when the graphics card refuses this size.
    Framebuffer(const Gl& gl, int width, int height);

    /// Directs drawing into it, over its whole area, until another framebuffer is bound.
    void bind() const;

    /// What has been drawn, top row first. OpenGL's row 0, the lowest on a screen, becomes the last row.
    ByteImage read() const;

    const GlTexture& color() const { return color_; }

private:
    const Gl* gl_;
    Handle handle_;
    GlTexture color_;
};

}
