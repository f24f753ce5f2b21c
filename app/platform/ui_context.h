#pragma once
// Dear ImGui's context with its letters, its measures and the way to the screen: what window and headless
// share.

#include <memory>

#include <imgui.h>

#include "app/gl/imgui_renderer.h"
#include "app/platform/fonts.h"

namespace eyeray {

/// Owns the one ImGui context of the program. All lengths of ImGui are pixels of the framebuffer.
class UiContext {
public:
    /// Throws InternalError when there is already an ImGui context.
    explicit UiContext(const Gl& gl);

    /// Colours and measures, in pixels at scale 1; in force from the next frame on.
    void setStyle(const ImGuiStyle& style);

    /// Begins a frame of this size, `seconds` after the last, with letters and measures enlarged by `scale`.
    /// A frame that an exception left unfinished is closed first and never shown.
    void beginFrame(int width, int height, float scale, float seconds);

    /// Ends the frame; what it shows can be drawn until the next begins.
    void endFrame();

    /// Draws the last frame into the bound framebuffer.
    void draw() const;

    /// A picture of the last frame, top row first. Works for hidden windows too.
    ByteImage screenshot() const;

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }
    };
    void rescale(float scale);

    const Gl& gl_;
    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    ImGuiRenderer renderer_;
    Fonts fonts_;
    ImGuiStyle style_;
    float scale_ = 0;
    bool inFrame_ = false;
};

}
