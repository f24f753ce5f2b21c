#pragma once
// What tests of the UI share: frames played headless, and clicks.

#include <functional>

#include "app/platform/headless_platform.h"

namespace eyeray {

/// Frames until all injected input has been seen, at least one.
inline void play(HeadlessPlatform& platform, const std::function<void()>& ui) {
    do {
        platform.beginFrame();
        ui();
        platform.endFrame();
    } while (platform.inputPending());
}

inline void click(HeadlessPlatform& platform, float x, float y) {
    platform.moveMouse(x, y);
    platform.mouseButton(0, true);
    platform.mouseButton(0, false);
}

/// A window without border that fills the framebuffer, so that positions are pixels.
inline void fullWindow(const std::function<void()>& content) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin("full", nullptr, ImGuiWindowFlags_NoDecoration);
    content();
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}
