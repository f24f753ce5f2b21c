// Whole pictures of one sample per pixel: seconds, and rays per second by accelerator.

#include <fmt/format.h>

#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kRepetitions = 5;

struct Case {
    std::string scene;
    AccelKind accel;
    int threads;
    int width = kWidth, height = kHeight;
};

/// Status of each repetition, after one that warms up.
std::vector<RenderStatus> render(const Case& wanted) {
    Document document = openForever(wanted.scene);
    document.render.width = wanted.width;
    document.render.height = wanted.height;
    document.render.stop.samples = 1;
    document.render.coarse = false;
    const auto world = buildWorld(document.scene, {wanted.accel});
    RenderSession session(wanted.threads);
    std::vector<RenderStatus> all;
    for (int i = 0; i <= kRepetitions; ++i) {
        session.start(world, document.camera, document.render);
        RenderStatus status = session.status();
        while (status.active()) status = session.wait(std::chrono::milliseconds(100));
        if (i > 0) all.push_back(status);
    }
    return all;
}

template <class Value>
std::vector<double> values(const std::vector<RenderStatus>& all, const Value& value) {
    std::vector<double> result;
    result.reserve(all.size());
    for (const RenderStatus& status : all) result.push_back(value(status));
    return result;
}

std::string nameOf(const Case& c) {
    return fmt::format("{}, {}, {} thread{}{}", c.scene, kAccelNames[static_cast<std::size_t>(c.accel)],
                       c.threads, c.threads == 1 ? "" : "s",
                       c.width == kWidth ? "" : fmt::format(", {}x{}", c.width, c.height));
}

}

void benchPictures() {
    printHeading("Homage, 1280x720, depth 5, one sample", "ms");
    for (const int threads : {1, 2}) {
        const Case homage{"homage", AccelKind::Brute, threads};
        printSeries(nameOf(homage),
                    values(render(homage), [](const RenderStatus& s) { return s.secondsToFirstPass * 1e3; }));
    }
    printHeading("Rays, one sample at 1280x720 unless said", "Mrays/s");
    std::vector<Case> cases = {{"homage", AccelKind::Brute, 1},
                               {"homage", AccelKind::Brute, 2},
                               {"cornell", AccelKind::Brute, 2},
                               {"many", AccelKind::Brute, 2, 160, 90}}; // 1280x720 would take a minute
    for (const char* scene : {"homage", "cornell", "many", "terrain"})
        for (const AccelKind accel : {AccelKind::Bvh2, AccelKind::Bvh8}) cases.push_back({scene, accel, 2});
    for (const Case& c : cases)
        printSeries(nameOf(c), values(render(c), [](const RenderStatus& s) { return s.mraysPerSecond(); }));
}

}
