#pragma once
// Pictures on the graphics card.

#include <cstdint>

#include "app/gl/handle.h"
#include "core/image/pixels.h"

namespace eyeray {

/// How a picture looks when it is drawn larger than it is. Drawn smaller, it is always smoothed.
enum class Magnify : std::uint8_t { Pixels, Smooth };

/// A part of a picture; (x, y) is its top left pixel.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// An RGBA8 texture; texture coordinate (0, 0) is the top left corner of the picture.
class GlTexture {
public:
    explicit GlTexture(const Gl& gl, Magnify magnify = Magnify::Pixels);

    /// Makes the texture a copy of the whole image, in the image's size. Throws Failure when the graphics
    /// card takes none so large.
    void upload(const ByteImage& image);

    /// Copies only this part of an image that has the texture's size; throws InternalError when the sizes
    /// differ or the part reaches outside.
    void upload(const ByteImage& image, const PixelRect& part);

    /// Gives the texture a size; its pixels are undefined until something writes or draws them.
    /// Throws Failure as upload does.
    void resize(int width, int height);

    void setMagnify(Magnify magnify);

    int width() const { return width_; }
    int height() const { return height_; }
    GLuint name() const { return handle_.name(); }

private:
    void allocate(int width, int height, const void* pixels);

    const Gl* gl_;
    Handle handle_;
    int width_ = 0, height_ = 0;
};

}
