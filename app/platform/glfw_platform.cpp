#include "app/platform/glfw_platform.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr WindowSize kFirstSize{1440, 900};   // at content scale 1
constexpr WindowSize kSmallestSize{640, 400}; // at content scale 1; below it the panels leave no picture
constexpr double kLongestFrame = 0.1;         // seconds that ImGui is told after a long sleep

[[noreturn]] void fail(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Failure{"window", fmt::format("{} ({})", what, reason ? reason : "no reason given"),
                  "use `eyeray snapshot` or `eyeray render`, which need no display"};
}

int scaled(int length, float scale) {
    return static_cast<int>(std::lround(static_cast<float>(length) * scale));
}

/// The remembered size or the first one, no larger than the part of the screen that windows may cover.
WindowSize fittingSize(const std::optional<WindowSize>& remembered) {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    if (!monitor) return remembered.value_or(kFirstSize);
    float scale = 1;
    glfwGetMonitorContentScale(monitor, &scale, nullptr);
    WindowSize size = remembered.value_or(
        WindowSize{scaled(kFirstSize.width, scale), scaled(kFirstSize.height, scale), false});
    int width = 0;
    int height = 0;
    glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &width, &height);
    size.width = std::clamp(size.width, std::min(scaled(kSmallestSize.width, scale), width), width);
    size.height = std::clamp(size.height, std::min(scaled(kSmallestSize.height, scale), height), height);
    return size;
}

GLFWwindow* openWindow(const std::string& title, const WindowSize& size) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_MAXIMIZED, size.maximized);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "Eyeray");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "eyeray");
    GLFWwindow* const window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (!window) fail("cannot open one with OpenGL 3.3 core");
    float scale = 1;
    glfwGetWindowContentScale(window, &scale, nullptr);
    glfwSetWindowSizeLimits(window, std::min(scaled(kSmallestSize.width, scale), size.width),
                            std::min(scaled(kSmallestSize.height, scale), size.height), GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return window;
}

void* getProc(const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }

/// The desktop's shape for each of ImGui's, where GLFW 3.3 has one; 0 stands for the arrow.
constexpr int cursorShape(ImGuiMouseCursor cursor) {
    switch (cursor) {
    case ImGuiMouseCursor_TextInput:
        return GLFW_IBEAM_CURSOR;
    case ImGuiMouseCursor_ResizeNS:
        return GLFW_VRESIZE_CURSOR;
    case ImGuiMouseCursor_ResizeEW:
        return GLFW_HRESIZE_CURSOR;
    case ImGuiMouseCursor_Hand:
        return GLFW_HAND_CURSOR;
    default:
        return 0;
    }
}

}

GlfwPlatform::Library::Library() {
    if (!glfwInit()) fail("there is no display to open one on");
}
GlfwPlatform::Library::~Library() { glfwTerminate(); }
void GlfwPlatform::DestroyWindow::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
void GlfwPlatform::DestroyCursor::operator()(GLFWcursor* cursor) const { glfwDestroyCursor(cursor); }

GlfwPlatform::GlfwPlatform(const std::string& title, std::optional<WindowSize> remembered)
    : restored_(fittingSize(remembered)), window_(openWindow(title, restored_)), gl_(getProc), ui_(gl_) {
    for (ImGuiMouseCursor cursor = 0; cursor < ImGuiMouseCursor_COUNT; ++cursor)
        if (const int shape = cursorShape(cursor))
            cursors_[static_cast<std::size_t>(cursor)].reset(glfwCreateStandardCursor(shape));
    ImGuiIO& io = ImGui::GetIO();
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ClipboardUserData = window_.get();
    io.GetClipboardTextFn = [](void* window) {
        return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
    };
    io.SetClipboardTextFn = [](void* window, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
    };
    listen();
}

WindowSize GlfwPlatform::windowSize() const {
    WindowSize size = restored_;
    size.maximized = glfwGetWindowAttrib(window_.get(), GLFW_MAXIMIZED) == GLFW_TRUE;
    return size;
}

void GlfwPlatform::beginFrame() {
    glfwPollEvents();
    input_.feed(ImGui::GetIO());
    const double now = glfwGetTime();
    const double seconds = std::clamp(now - lastFrame_, 1e-5, kLongestFrame);
    lastFrame_ = now;
    const auto [width, height] = framebufferSize();
    ui_.beginFrame(width, height, scale(), static_cast<float>(seconds));
}

void GlfwPlatform::endFrame() {
    ui_.endFrame();
    showCursor();
    gl_.bindFramebuffer(GL_FRAMEBUFFER, 0);
    ui_.draw();
    glfwSwapBuffers(window_.get());
}

bool GlfwPlatform::closing() const { return glfwWindowShouldClose(window_.get()) == GLFW_TRUE; }

void GlfwPlatform::waitEvents(double seconds) {
    if (input_.empty()) glfwWaitEventsTimeout(std::max(seconds, 0.0));
}

void GlfwPlatform::wake() { glfwPostEmptyEvent(); }

FramebufferSize GlfwPlatform::framebufferSize() const {
    FramebufferSize size;
    glfwGetFramebufferSize(window_.get(), &size.width, &size.height);
    return size;
}

float GlfwPlatform::contentScale() const {
    float scale = 1;
    glfwGetWindowContentScale(window_.get(), &scale, nullptr);
    return scale;
}

void GlfwPlatform::setTitle(const std::string& title) { glfwSetWindowTitle(window_.get(), title.c_str()); }

bool GlfwPlatform::fullscreen() const { return glfwGetWindowMonitor(window_.get()) != nullptr; }

void GlfwPlatform::setFullscreen(bool on) {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (on == fullscreen() || !mode) return;
    if (!on)
        return glfwSetWindowMonitor(window_.get(), nullptr, windowed_.x, windowed_.y, windowed_.width,
                                    windowed_.height, GLFW_DONT_CARE);
    glfwGetWindowPos(window_.get(), &windowed_.x, &windowed_.y);
    glfwGetWindowSize(window_.get(), &windowed_.width, &windowed_.height);
    glfwSetWindowMonitor(window_.get(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

std::vector<std::filesystem::path> GlfwPlatform::takeDroppedFiles() { return std::exchange(dropped_, {}); }

void GlfwPlatform::showCursor() {
    const ImGuiMouseCursor cursor = ImGui::GetMouseCursor();
    if (cursor == shownCursor_) return;
    shownCursor_ = cursor;
    const bool visible = cursor != ImGuiMouseCursor_None;
    glfwSetInputMode(window_.get(), GLFW_CURSOR, visible ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
    if (visible) glfwSetCursor(window_.get(), cursors_[static_cast<std::size_t>(cursor)].get());
}

}
