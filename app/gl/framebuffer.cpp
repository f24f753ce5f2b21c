#include "app/gl/framebuffer.h"

#include <fmt/format.h>

namespace eyeray {

void requireComplete(const Gl& gl, int width, int height) {
    if (gl.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Failure{"OpenGL", fmt::format("cannot draw into a picture of {}x{} pixels", width, height),
                      "use a smaller size"};
}

Framebuffer::Framebuffer(const Gl& gl, int width, int height, Depth depth)
    : gl_(&gl), handle_(gl.genFramebuffers, gl.deleteFramebuffers), color_(gl) {
    color_.resize(width, height);
    gl.bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    gl.framebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    if (depth == Depth::With) {
        depth_.emplace(gl.genRenderbuffers, gl.deleteRenderbuffers);
        gl.bindRenderbuffer(GL_RENDERBUFFER, depth_->name());
        gl.renderbufferStorageMultisample(GL_RENDERBUFFER, 0, kDepthFormat, width, height);
        gl.framebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
    }
    requireComplete(gl, width, height);
}

void Framebuffer::bind() const {
    gl_->bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    gl_->viewport(0, 0, color_.width(), color_.height());
}

ByteImage Framebuffer::read() const {
    ByteImage image(color_.width(), color_.height());
    bind();
    gl_->readPixels(0, 0, image.width(), image.height(), GL_RGBA, GL_UNSIGNED_BYTE, image.values().data());
    flipRows(image);
    return image;
}

Pixels<float> Framebuffer::readDepth() const {
    Pixels<float> depth(color_.width(), color_.height());
    bind();
    gl_->readPixels(0, 0, depth.width(), depth.height(), GL_DEPTH_COMPONENT, GL_FLOAT, depth.values().data());
    flipRows(depth);
    return depth;
}

}
