#pragma once
// Where the UI lives: a window on a screen, or nowhere at all.

#include <filesystem>
#include <string>
#include <vector>

#include "app/gl/functions.h"
#include "app/platform/ui_context.h"

namespace eyeray {

struct FramebufferSize {
    int width = 0, height = 0; // pixels
    friend bool operator==(const FramebufferSize&, const FramebufferSize&) = default;
};

/// A place that shows the UI and gives it input. Of one thread, but for wake(). One exists at a time.
class Platform {
public:
    Platform() = default;
    virtual ~Platform() = default;
    Platform(const Platform&) = delete;
    Platform& operator=(const Platform&) = delete;

    /// Takes the input of one frame and begins ImGui's frame.
    virtual void beginFrame() = 0;

    /// Ends ImGui's frame and shows it.
    virtual void endFrame() = 0;

    /// Whether the person has asked to close the window.
    virtual bool closing() const = 0;

    /// Sleeps until there is input, wake() is called or this time has passed. Returns at once while input of
    /// earlier still waits for its frame.
    virtual void waitEvents(double seconds) = 0;

    /// Ends waitEvents(). From any thread.
    virtual void wake() = 0;

    virtual FramebufferSize framebufferSize() const = 0;

    /// How many pixels a length of one stands for on this screen: 1, or 2 on a screen of fine pixels.
    virtual float contentScale() const = 0;

    virtual void setTitle(const std::string& title) = 0;

    /// Fills the screen, where there is one.
    virtual void setFullscreen(bool) {}
    virtual bool fullscreen() const { return false; }

    /// The files dropped on the window since the last call.
    virtual std::vector<std::filesystem::path> takeDroppedFiles() = 0;

    virtual const Gl& gl() const = 0;

    /// Colours and measures, in pixels at scale 1; in force from the next frame on.
    void setStyle(const ImGuiStyle& style) { ui().setStyle(style); }

    /// Enlarges letters and measures beyond what the screen needs, for people in the last row.
    void setTextScale(float scale) { textScale_ = scale; }

    /// By how much letters and measures are enlarged in all.
    float scale() const { return contentScale() * textScale_; }

    /// A picture of the last frame, top row first; between endFrame() and the next beginFrame().
    ByteImage screenshot() { return ui().screenshot(); }

protected:
    virtual UiContext& ui() = 0;

private:
    float textScale_ = 1;
};

}
