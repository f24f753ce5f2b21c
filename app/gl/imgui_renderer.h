#pragma once
// Draws what Dear ImGui has laid out.

#include <imgui.h>

#include "app/gl/handle.h"
#include "app/gl/program.h"
#include "app/gl/texture.h"

namespace eyeray {

/// How a texture is named in ImGui::Image and draw lists; it must live until the frame is drawn.
ImTextureID textureId(const GlTexture& texture);

/// Draws ImGui's lists of triangles into the bound framebuffer. Sets all OpenGL state it depends on, each
/// time, and does not restore any.
class ImGuiRenderer {
public:
    explicit ImGuiRenderer(const Gl& gl);

    /// `data` is in pixels of the framebuffer, whose height is data.DisplaySize.y.
    void draw(const ImDrawData& data) const;

private:
    void setState(const ImDrawData& data) const;
    void draw(const ImDrawData& data, const ImDrawList& list) const;

    const Gl& gl_;
    Program program_;
    Handle vertexArray_, vertices_, indices_;
};

}
