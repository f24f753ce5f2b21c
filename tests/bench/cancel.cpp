// From a stop to idle threads, in the scenes that are slowest to trace.

#include <fmt/format.h>

#include <random>

#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kStops = 50;

void cancel(const std::string& scene, const std::vector<std::string>& commands) {
    Document document = openForever(scene);
    std::string name = scene;
    for (const std::string& command : commands) {
        document = apply(document, Command::parse(command));
        name += command.substr(command.find(' '));
    }
    const auto world = buildWorld(document.scene, buildSettings(document));
    RenderSession session;
    std::mt19937 random(2);
    std::uniform_int_distribution microseconds(1'000, 80'000); // in the coarse picture as well as after it
    std::vector<double> milliseconds;
    for (int i = 0; i < kStops; ++i) {
        session.start(world, document.camera, document.render);
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
        const auto start = Clock::now();
        session.stop();
        milliseconds.push_back(secondsSince(start) * 1e3);
    }
    printSeries(name, milliseconds, {Goal::Of::Percentile95, 5});
}

}

void benchCancel() {
    printHeading("Cancel to idle, 1280x720", "ms");
    cancel("flake", {"set max-depth=64"});
    cancel("terrain", {});
    cancel("bubble", {"set max-depth=64 cutoff=0"});
    cancel("mirrors", {"set max-depth=64 cutoff=0"});
    cancel("many", {"set accel=brute"});
}

}
