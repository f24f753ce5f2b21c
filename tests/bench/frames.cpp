// The window while tracing goes on behind it: what one frame costs, drawn by OSMesa and read back.

#include "tests/bench/bench_window.h"

namespace eyeray::bench {
namespace {

constexpr int kFrames = 90;
constexpr double kGoal = 1e3 / 30; // ms a frame

void frames(const std::string& scene, bool orbiting) {
    BenchWindow window(scene, "set samples=1000000 error=0");
    std::vector<double> milliseconds;
    for (int i = 0; i < kFrames; ++i) {
        if (orbiting) window.execute("orbit yaw=1 pitch=0");
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
