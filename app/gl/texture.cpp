#include "app/gl/texture.h"

#include <fmt/format.h>

namespace eyeray {

GlTexture::GlTexture(const Gl& gl, Magnify magnify) : gl_(&gl), handle_(gl.genTextures, gl.deleteTextures) {
    setMagnify(magnify);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void GlTexture::upload(const ByteImage& image) {
    if (image.width() != width_ || image.height() != height_)
        allocate(image.width(), image.height(), image.values().data());
    else
        upload(image, {0, 0, width_, height_});
}

void GlTexture::upload(const ByteImage& image, const PixelRect& part) {
    ENSURE(image.width() == width_ && image.height() == height_);
    ENSURE(part.x >= 0 && part.width >= 0 && part.x <= width_ - part.width);
    ENSURE(part.y >= 0 && part.height >= 0 && part.y <= height_ - part.height);
    if (part.width == 0 || part.height == 0) return;
    gl_->bindTexture(GL_TEXTURE_2D, name());
    gl_->pixelStorei(GL_UNPACK_ROW_LENGTH, width_);
    gl_->texSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, part.width, part.height, GL_RGBA, GL_UNSIGNED_BYTE,
                       &image.at(part.x, part.y));
    gl_->pixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GlTexture::resize(int width, int height) {
    ENSURE(width >= 0 && height >= 0);
    if (width != width_ || height != height_) allocate(width, height, nullptr);
}

void GlTexture::setMagnify(Magnify magnify) {
    gl_->bindTexture(GL_TEXTURE_2D, name());
    gl_->texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                       magnify == Magnify::Smooth ? GL_LINEAR : GL_NEAREST);
}

void GlTexture::allocate(int width, int height, const void* pixels) {
    GLint most = 0;
    gl_->getIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most)
        throw Failure{"OpenGL", fmt::format("cannot show a picture of {}x{} pixels", width, height),
                      fmt::format("use at most {} pixels a side", most)};
    gl_->bindTexture(GL_TEXTURE_2D, name());
    gl_->texImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    width_ = width;
    height_ = height;
}

}
