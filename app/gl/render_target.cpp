#include "app/gl/render_target.h"

#include <algorithm>

#include <fmt/format.h>

namespace eyeray {

RenderTarget::RenderTarget(const Gl& gl, int width, int height, const std::vector<GLenum>& formats,
                           int samples)
    : gl_(&gl), width_(width), height_(height), handle_(gl.genFramebuffers, gl.deleteFramebuffers),
      depth_(gl.genRenderbuffers, gl.deleteRenderbuffers) {
    GLint most = 1;
    gl.getIntegerv(GL_MAX_SAMPLES, &most);
    const int taken = samples > 1 ? std::min(samples, most) : 0;
    gl.bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    std::vector<GLenum> attachments;
    for (const GLenum format : formats) {
        colors_.emplace_back(gl.genRenderbuffers, gl.deleteRenderbuffers);
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
        attach(attachments.back(), colors_.back(), format, taken);
    }
    attach(GL_DEPTH_ATTACHMENT, depth_, kDepthFormat, taken);
    gl.drawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    requireComplete(gl, width, height);
}

void RenderTarget::attach(GLenum attachment, const Handle& buffer, GLenum format, int samples) const {
    gl_->bindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    gl_->renderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
    gl_->framebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void RenderTarget::bind() const {
    gl_->bindFramebuffer(GL_FRAMEBUFFER, handle_.name());
    gl_->viewport(0, 0, width_, height_);
}

void RenderTarget::copyTo(const Framebuffer& target) const {
    target.bind();
    gl_->bindFramebuffer(GL_READ_FRAMEBUFFER, handle_.name());
    gl_->blitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_,
                         GL_COLOR_BUFFER_BIT | (target.hasDepth() ? GL_DEPTH_BUFFER_BIT : 0U), GL_NEAREST);
}

void RenderTarget::readBytes(int color, GLenum format, GLenum type, void* values) const {
    bind();
    gl_->readBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(color));
    gl_->readPixels(0, 0, width_, height_, format, type, values);
}

}
