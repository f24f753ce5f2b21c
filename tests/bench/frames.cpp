// The window while tracing goes on behind it: what one frame costs, drawn by OSMesa and read back.

#include "app/gui/gui.h"
#include "app/platform/headless_platform.h"
#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kFrames = 90, kSettlingFrames = 3;
constexpr double kGoal = 1e3 / 30; // ms a frame

class Window {
public:
    explicit Window(const std::string& scene) : gui_(viewer_, platform_, Preferences{}) {
        viewer_.openInBackground(scene, {Command::parse("set samples=1000000 error=0")});
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

    void execute(const Command& command) { gui_.execute(command); }

private:
    HeadlessPlatform platform_{kWidth, kHeight};
    Viewer viewer_;
    Gui gui_;
};

void frames(const std::string& scene, bool orbiting) {
    Window window(scene);
    std::vector<double> milliseconds;
    for (int i = 0; i < kFrames; ++i) {
        if (orbiting) window.execute(Command::parse("orbit yaw=1 pitch=0"));
        milliseconds.push_back(window.draw());
    }
    printSeries(scene + (orbiting ? ", orbiting" : ", refining"), milliseconds, {Goal::Of::Median, kGoal});
}

}

void benchFrames() {
    printHeading("UI frame, 1280x720, while tracing", "ms");
    for (const char* scene : {"homage", "terrain"})
        for (const bool orbiting : {false, true}) frames(scene, orbiting);
}

}
