#include "app/platform/ui_context.h"

#include <cmath>

#include <imgui_internal.h> // ErrorCheckEndFrameRecover

#include "app/gl/framebuffer.h"
#include "app/platform/input.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr float kTextPixels = 17; // height of a line of text at scale 1

ImGuiContext* createContext() {
    ENSURE(ImGui::GetCurrentContext() == nullptr);
    IMGUI_CHECKVERSION();
    return ImGui::CreateContext();
}

}

UiContext::UiContext(const Gl& gl) : gl_(gl), context_(createContext()), renderer_(gl), fonts_(gl) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // the program keeps its settings itself
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    nameKeys(io);
}

void UiContext::setStyle(const ImGuiStyle& style) {
    style_ = style;
    scale_ = 0;
}

void UiContext::beginFrame(int width, int height, float scale, float seconds) {
    if (inFrame_) {
        ImGui::ErrorCheckEndFrameRecover(nullptr);
        ImGui::EndFrame();
    }
    inFrame_ = true;
    if (scale != scale_) rescale(scale);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = seconds;
    ImGui::NewFrame();
}

void UiContext::endFrame() {
    ImGui::Render();
    inFrame_ = false;
}

void UiContext::draw() const { renderer_.draw(*ImGui::GetDrawData()); }

ByteImage UiContext::screenshot() const {
    const ImDrawData* const data = ImGui::GetDrawData();
    ENSURE(data != nullptr);
    const Framebuffer framebuffer(gl_, static_cast<int>(data->DisplaySize.x),
                                  static_cast<int>(data->DisplaySize.y));
    framebuffer.bind();
    draw();
    ByteImage image = framebuffer.read();
    gl_.bindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

void UiContext::rescale(float scale) {
    fonts_.build(std::round(kTextPixels * scale));
    ImGui::GetStyle() = style_;
    ImGui::GetStyle().ScaleAllSizes(scale);
    scale_ = scale;
}

}
