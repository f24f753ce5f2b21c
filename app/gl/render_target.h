#pragma once
// Something to draw three-dimensional things into: colours, numbers and depth of each pixel.

#include <vector>

#include "app/gl/framebuffer.h"

namespace eyeray {

/// Renderbuffers of the given formats and a 32-bit float depth buffer.
class RenderTarget {
public:
    /// `samples` for each pixel, as many as the card has at most. Throws Failure when the graphics card
    /// refuses this size.
    RenderTarget(const Gl& gl, int width, int height, const std::vector<GLenum>& formats, int samples = 1);

    /// Directs drawing into all of it until another framebuffer is bound.
    void bind() const;

    /// Copies the first colour, and depth where the other has it, into a framebuffer of the same size;
    /// samples become their mean, depths the first of theirs.
    void copyTo(const Framebuffer&) const;

    /// One value of type T for each pixel of a colour, top row first; the target has one sample. The format
    /// and type are glReadPixels'.
    template <class T>
    Pixels<T> read(int color, GLenum format, GLenum type) const {
        Pixels<T> image(width_, height_);
        readBytes(color, format, type, image.values().data());
        flipRows(image);
        return image;
    }

    /// Depth of each pixel, 0 near to 1 far, top row first; the target has one sample.
    Pixels<float> readDepth() const { return read<float>(0, GL_DEPTH_COMPONENT, GL_FLOAT); }

    int width() const { return width_; }
    int height() const { return height_; }

private:
    void attach(GLenum attachment, const Handle& buffer, GLenum format, int samples) const;
    void readBytes(int color, GLenum format, GLenum type, void* values) const;

    const Gl* gl_;
    int width_, height_;
    Handle handle_;
    std::vector<Handle> colors_;
    Handle depth_;
};

}
