#pragma once
// The whole window of the viewer, drawn by OSMesa and read back.

#include "app/gui/gui.h"
#include "app/platform/headless_platform.h"
#include "tests/bench/bench.h"

namespace eyeray::bench {

class BenchWindow {
public:
    /// A built-in scene with these settings; returns when the window has settled.
    BenchWindow(const std::string& scene, const std::string& settings)
        : gui_(viewer_, platform_, Preferences{}) {
        constexpr int kSettlingFrames = 3;
        viewer_.openInBackground(scene, {Command::parse(settings)});
        viewer_.finishJobs();
        for (int i = 0; i < kSettlingFrames; ++i) draw();
    }

    /// Milliseconds of one frame.
    double draw() {
        const auto start = Clock::now();
        platform_.beginFrame();
        gui_.frame();
        platform_.endFrame();
        gui_.afterFrame();
        platform_.screenshot();
        return secondsSince(start) * 1e3;
    }

    void execute(const std::string& command) { gui_.execute(Command::parse(command)); }
    const Viewer& viewer() const { return viewer_; }

private:
    HeadlessPlatform platform_{kWidth, kHeight};
    Viewer viewer_;
    Gui gui_;
};

}
