#pragma once
// The UI without a screen: for pictures of it, and for tests that play a person.

#include <cstdint>
#include <utility>

#include "app/platform/input.h"
#include "app/platform/platform.h"

struct osmesa_context;

namespace eyeray {

/// Draws in software with OSMesa. A frame lasts 1/60 s whatever the clock says, so the same input gives the
/// same pictures, byte for byte. A frame is drawn only when a screenshot asks for it.
class HeadlessPlatform final : public Platform {
public:
    /// Throws Failure when OSMesa gives no OpenGL 3.3 core.
    HeadlessPlatform(int width, int height, float contentScale = 1);

    // Input to come, one event a frame: a press and its release fall in different frames.
    void moveMouse(float x, float y) { input_.push(MouseMoved{x, y}); }
    void mouseButton(int button, bool down) { input_.push(MouseButton{button, down}); }
    void wheel(float x, float y) { input_.push(WheelTurned{x, y}); }
    void key(int key, bool down) { input_.push(KeyChanged{key, down}); }
    void text(std::string utf8) { input_.push(TextTyped{std::move(utf8)}); }
    void dropFile(std::filesystem::path path) { dropped_.push_back(std::move(path)); }

    /// Presses and releases a chord: its modifiers first, then its key, then all up again.
    void chord(const KeyChord& chord);

    /// Whether there are events that no frame has seen.
    bool inputPending() const { return !input_.empty(); }

    void beginFrame() override;
    void endFrame() override { ui_.endFrame(); }
    bool closing() const override { return false; }
    void waitEvents(double) override {}
    void wake() override {}
    FramebufferSize framebufferSize() const override { return size_; }
    float contentScale() const override { return contentScale_; }
    void setTitle(const std::string&) override {}
    std::vector<std::filesystem::path> takeDroppedFiles() override { return std::exchange(dropped_, {}); }
    const Gl& gl() const override { return gl_; }

private:
    UiContext& ui() override { return ui_; }

    /// OpenGL of this thread. It draws into framebuffers of its own: OSMesa's is the smallest it allows.
    class Context {
    public:
        Context();
        ~Context();
        Context(const Context&) = delete;
        Context& operator=(const Context&) = delete;

    private:
        osmesa_context* context_;
        std::uint32_t pixel_ = 0;
    };

    FramebufferSize size_;
    float contentScale_;
    Context context_;
    Gl gl_;
    UiContext ui_;
    InputQueue input_;
    std::vector<std::filesystem::path> dropped_;
};

}
