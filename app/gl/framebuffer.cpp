#include "app/gl/framebuffer.h"

#include <algorithm>

#include <fmt/format.h>

namespace eyeray {

Framebuffer::Framebuffer(const Gl& gl, int width, int height)
    : gl_(&gl), handle_(gl.genFramebuffers, gl.deleteFramebuffers), color_(gl) {
    color_.resize(width, height);
    gl.bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    gl.framebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    if (gl.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Failure{"OpenGL", fmt::format("cannot draw into a picture of {}x{} pixels", width, height),
                      "use a smaller size"};
}

void Framebuffer::bind() const {
    gl_->bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    gl_->viewport(0, 0, color_.width(), color_.height());
}

ByteImage Framebuffer::read() const {
    ByteImage image(color_.width(), color_.height());
    bind();
    gl_->readPixels(0, 0, image.width(), image.height(), GL_RGBA, GL_UNSIGNED_BYTE, image.values().data());
    for (int y = 0; y < image.height() / 2; ++y)
        std::swap_ranges(&image.at(0, y), &image.at(0, y) + image.width(),
                         &image.at(0, image.height() - 1 - y));
    return image;
}

}
