#include "app/gl/imgui_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace eyeray {
namespace {

// Positions arrive in pixels from the top left; OpenGL's clip space has y up.
constexpr const char* kVertexShader = R"(#version 330 core
uniform vec2 origin;
uniform vec2 size;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texturePosition;
layout(location = 2) in vec4 color;
out vec2 uv;
out vec4 tint;
void main() {
    uv = texturePosition;
    tint = color;
    vec2 p = 2.0 * (position - origin) / size - 1.0;
    gl_Position = vec4(p.x, -p.y, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D picture;
in vec2 uv;
in vec4 tint;
out vec4 color;
void main() { color = tint * texture(picture, uv); }
)";

/// Nothing of it is wanted in a flat picture whose colours are sRGB already.
constexpr std::array<GLenum, 5> kOff = {GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST,
                                        GL_FRAMEBUFFER_SRGB};

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

const void* bufferOffset(std::size_t bytes) { return std::bit_cast<const void*>(bytes); }

template <class T>
void stream(const Gl& gl, GLenum target, const ImVector<T>& values) {
    gl.bufferData(target, values.size_in_bytes(), values.Data, GL_STREAM_DRAW);
}

}

ImTextureID textureId(const GlTexture& texture) {
    return std::bit_cast<ImTextureID>(std::uintptr_t{texture.name()});
}

ImGuiRenderer::ImGuiRenderer(const Gl& gl)
    : gl_(gl), program_(gl, kVertexShader, kFragmentShader),
      vertexArray_(gl.genVertexArrays, gl.deleteVertexArrays), vertices_(gl.genBuffers, gl.deleteBuffers),
      indices_(gl.genBuffers, gl.deleteBuffers) {
    gl.bindVertexArray(vertexArray_.name());
    gl.bindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    const auto attribute = [&](GLuint location, GLint count, GLenum type, GLboolean normalized,
                               std::size_t offset) {
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, count, type, normalized, sizeof(ImDrawVert), bufferOffset(offset));
    };
    attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
    attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
    attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
}

void ImGuiRenderer::draw(const ImDrawData& data) const {
    if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return; // a window made an icon
    setState(data);
    for (int i = 0; i < data.CmdListsCount; ++i) draw(data, *data.CmdLists[i]);
}

void ImGuiRenderer::setState(const ImDrawData& data) const {
    for (const GLenum off : kOff) gl_.disable(off);
    gl_.colorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.clearColor(0, 0, 0, 1);
    gl_.clear(GL_COLOR_BUFFER_BIT);
    gl_.enable(GL_SCISSOR_TEST);
    gl_.enable(GL_BLEND);
    gl_.blendEquation(GL_FUNC_ADD);
    // The framebuffer's own alpha stays 1: a screenshot has no holes.
    gl_.blendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.polygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.viewport(0, 0, static_cast<GLsizei>(data.DisplaySize.x), static_cast<GLsizei>(data.DisplaySize.y));
    gl_.activeTexture(GL_TEXTURE0);
    gl_.bindSampler(0, 0);
    program_.use();
    gl_.uniform1i(program_.uniform("picture"), 0);
    gl_.uniform2f(program_.uniform("origin"), data.DisplayPos.x, data.DisplayPos.y);
    gl_.uniform2f(program_.uniform("size"), data.DisplaySize.x, data.DisplaySize.y);
    gl_.bindVertexArray(vertexArray_.name());
    gl_.bindBuffer(GL_ARRAY_BUFFER, vertices_.name());
}

void ImGuiRenderer::draw(const ImDrawData& data, const ImDrawList& list) const {
    stream(gl_, GL_ARRAY_BUFFER, list.VtxBuffer);
    stream(gl_, GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const float left = std::max(command.ClipRect.x - data.DisplayPos.x, 0.0F);
        const float top = std::max(command.ClipRect.y - data.DisplayPos.y, 0.0F);
        const float right = std::min(command.ClipRect.z - data.DisplayPos.x, data.DisplaySize.x);
        const float bottom = std::min(command.ClipRect.w - data.DisplayPos.y, data.DisplaySize.y);
        if (right <= left || bottom <= top) continue;
        gl_.scissor(static_cast<GLint>(left), static_cast<GLint>(data.DisplaySize.y - bottom),
                    static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
        gl_.bindTexture(GL_TEXTURE_2D,
                        static_cast<GLuint>(std::bit_cast<std::uintptr_t>(command.GetTexID())));
        gl_.drawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                                   bufferOffset(command.IdxOffset * sizeof(ImDrawIdx)),
                                   static_cast<GLint>(command.VtxOffset));
    }
}

}
