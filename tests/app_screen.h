#pragma once
// The whole program but for its window, for tests that play a person.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/gui/gui.h"
#include "app/platform/headless_platform.h"

namespace eyeray {

inline constexpr int kSamples = 2;
inline constexpr int kMirrorBall = 3; // object of the scene homage

struct Point {
    float x, y;
};

/// The whole program but for its window, played by injected input. Pictures end at kSamples samples.
class Screen {
public:
    explicit Screen(const std::string& scene = "homage", int width = 760, int height = 900)
        : platform(width, height), gui(viewer, platform, Preferences{}) {
        viewer.openInBackground(scene, {Command::parse(fmt::format("set samples={} error=0", kSamples))});
        settle();
    }

    /// Frames until all input has been seen.
    void play() {
        do {
            platform.beginFrame();
            gui.frame();
            platform.endFrame();
            gui.afterFrame();
        } while (platform.inputPending());
    }

    /// Frames until the picture is finished and ImGui has come to rest.
    void settle() {
        play();
        viewer.finishJobs();
        play();
        viewer.finishRendering(kSamples);
        for (int i = 0; i < 3; ++i) play();
    }

    WidgetRect rect(const std::string& name) const {
        const auto found = gui.widgets().find(name);
        if (found == gui.widgets().end()) throw std::runtime_error("no widget " + name);
        return found->second;
    }
    Point middle(const std::string& name) const {
        const WidgetRect r = rect(name);
        return {std::floor((r.x0 + r.x1) / 2), std::floor((r.y0 + r.y1) / 2)};
    }
    /// Where a pixel of the picture stands in the window.
    Point place(PixelPosition pixel) const {
        const WidgetRect r = rect("picture");
        return {r.x0 + static_cast<float>(pixel.x) + 0.5F, r.y0 + static_cast<float>(pixel.y) + 0.5F};
    }

    void click(Point at) {
        platform.moveMouse(at.x, at.y);
        platform.mouseButton(0, true);
        platform.mouseButton(0, false);
        play();
    }
    void click(const std::string& name) { click(middle(name)); }

    void drag(int button, Point from, Point to) {
        platform.moveMouse(from.x, from.y);
        platform.mouseButton(button, true);
        for (int i = 1; i <= 4; ++i)
            platform.moveMouse(from.x + (to.x - from.x) * static_cast<float>(i) / 4,
                               from.y + (to.y - from.y) * static_cast<float>(i) / 4);
        platform.mouseButton(button, false);
        play();
    }

    void press(const char* chord) {
        platform.chord(parseKeyChord(chord));
        play();
    }

    ByteImage picture() {
        platform.moveMouse(1, static_cast<float>(platform.framebufferSize().height) - 1); // hovers nothing
        settle();
        return platform.screenshot();
    }

    const Document& document() const { return viewer.document(); }

    std::vector<RayRecord> raysOf(int x, int y, int pass) {
        const auto trace = viewer.session().retrace(x, y, pass);
        return trace ? trace->rays : throw std::runtime_error("no picture");
    }

    /// A pixel whose eye ray meets this object first.
    PixelPosition pixelOf(int object) {
        const PictureSize size = viewer.pictureSize();
        for (int y = 2; y < size.height; y += 4)
            for (int x = 2; x < size.width; x += 4)
                if (raysOf(x, y, 0).front().object == object) return {x, y};
        throw std::runtime_error("the object is nowhere in the picture");
    }

    HeadlessPlatform platform;
    Viewer viewer{1};
    Gui gui;
};

}
