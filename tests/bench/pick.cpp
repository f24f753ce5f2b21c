// A pixel is picked while it is explained: until tree, sum, facts and the rays in space are on the screen.

#include <fmt/format.h>

#include <random>

#include "tests/bench/bench_window.h"

namespace eyeray::bench {
namespace {

constexpr int kPicks = 100;
constexpr double kGoal = 50; // ms

/// Milliseconds from each command to the end of the frame that shows what it did.
std::vector<double> picks(BenchWindow& window) {
    std::mt19937 random(1);
    std::vector<double> milliseconds;
    std::size_t mostRays = 0;
    for (int i = 0; i < kPicks; ++i) {
        const PictureSize size = window.viewer().pictureSize();
        const auto x = random() % static_cast<unsigned>(size.width);
        const auto y = random() % static_cast<unsigned>(size.height);
        const auto start = Clock::now();
        window.execute(fmt::format("pick x={} y={}", x, y));
        window.draw();
        milliseconds.push_back(secondsSince(start) * 1e3);
        if (const auto& picked = window.viewer().picked())
            mostRays = std::max(mostRays, picked->trace.rays.size());
    }
    fmt::print("up to {} rays:\n", mostRays);
    return milliseconds;
}

}

void benchPick() {
    printHeading("Pick to all views, 1280x720", "ms");
    for (const auto& [name, scene, settings] :
         {std::tuple{"homage", "homage", "set samples=1"},
          std::tuple{"mirrors, depth 16", "mirrors", "set samples=1 max-depth=16 cutoff=0"}}) {
        BenchWindow window(scene, settings);
        window.execute("explain on=on");
        while (window.viewer().status().active()) window.draw();
        for (const char* tab : {"tree", "sum"}) {
            window.execute(fmt::format("tab name={}", tab));
            window.draw();
            printSeries(fmt::format("{}, {}", name, tab), picks(window), {Goal::Of::Percentile95, kGoal});
        }
    }
}

}
