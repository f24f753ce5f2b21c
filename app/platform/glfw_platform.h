#pragma once
// The UI in a window of the desktop.

#include <array>
#include <memory>
#include <optional>

#include "app/platform/input.h"
#include "app/platform/platform.h"

struct GLFWcursor;
struct GLFWwindow;

namespace eyeray {

/// What the program remembers of its window, in the desktop's own units.
struct WindowSize {
    int width = 0, height = 0;
    bool maximized = false;
    friend bool operator==(const WindowSize&, const WindowSize&) = default;
};

/// A window with OpenGL 3.3 core, drawn at most as often as the screen shows it.
class GlfwPlatform final : public Platform {
public:
    /// Opens the window in the size of last time, or else in one that suits the screen. Throws Failure
    /// without a display or without OpenGL 3.3 core; it names the commands that need neither.
    GlfwPlatform(const std::string& title, std::optional<WindowSize> remembered);

    /// The size to remember: that of the window when it is not maximized.
    WindowSize windowSize() const;

    void beginFrame() override;
    void endFrame() override;
    bool closing() const override;
    void waitEvents(double seconds) override;
    void wake() override;
    FramebufferSize framebufferSize() const override;
    float contentScale() const override;
    void setTitle(const std::string& title) override;
    void setFullscreen(bool) override;
    bool fullscreen() const override;
    std::vector<std::filesystem::path> takeDroppedFiles() override;
    const Gl& gl() const override { return gl_; }

private:
    UiContext& ui() override { return ui_; }
    void listen(); // glfw_input.cpp
    void showCursor();

    struct Library {
        Library();
        ~Library();
        Library(const Library&) = delete;
        Library& operator=(const Library&) = delete;
    };
    struct DestroyWindow {
        void operator()(GLFWwindow* window) const;
    };
    struct DestroyCursor {
        void operator()(GLFWcursor* cursor) const;
    };

    Library library_;
    struct Place {
        int x = 0, y = 0, width = 0, height = 0;
    };
    Place windowed_;      // where the window was before it filled the screen
    WindowSize restored_; // what the window has, or had before it was maximized
    std::unique_ptr<GLFWwindow, DestroyWindow> window_;
    Gl gl_;
    UiContext ui_;
    std::array<std::unique_ptr<GLFWcursor, DestroyCursor>, ImGuiMouseCursor_COUNT> cursors_;
    InputQueue input_;
    std::vector<std::filesystem::path> dropped_;
    ImGuiMouseCursor shownCursor_ = ImGuiMouseCursor_Arrow;
    double lastFrame_ = 0; // seconds since the library was opened
};

}
