// From an edit to a whole coarse picture, while the picture before is still being traced.

#include <fmt/format.h>

#include <random>

#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kEdits = 200, kShadingEdits = 24;

/// What a person does at the mouse and the panels, at random.
class Editor {
public:
    Command next(const Document& document) {
        switch (std::uniform_int_distribution(0, 7)(random_)) {
        case 0:
            return line("orbit yaw={} pitch={}", between(-20, 20), between(-3, 3));
        case 1:
            return line("dolly factor={}", between(0.95, 1.05));
        case 2:
            return line("set fov={}", between(25, 60));
        case 3:
            return line("set max-depth={}", std::uniform_int_distribution(0, 8)(random_));
        case 4:
            return line("toggle key={}", either("shadows", "reflections"));
        case 5:
            return line("step n=4");
        case 6:
            return line("material material=0 diffuse={},0.5,0.5", between(0.2, 0.9));
        default:
            return line("move object={} by={},0,{}", object(document), between(-0.1, 0.1),
                        between(-0.1, 0.1));
        }
    }

    std::chrono::microseconds pause() {
        return std::chrono::microseconds(std::uniform_int_distribution(0, 60'000)(random_));
    }

private:
    template <class... Args>
    static Command line(fmt::format_string<Args...> format, Args&&... args) {
        return Command::parse(fmt::format(format, std::forward<Args>(args)...));
    }
    double between(double lowest, double highest) {
        return std::uniform_real_distribution(lowest, highest)(random_);
    }
    const char* either(const char* a, const char* b) {
        return std::uniform_int_distribution(0, 1)(random_) == 0 ? a : b;
    }
    std::size_t object(const Document& document) {
        return std::uniform_int_distribution<std::size_t>(0, document.scene->objects.size() - 1)(random_);
    }

    std::mt19937 random_{1};
};

void edit(const std::string& scene) {
    Document document = openForever(scene);
    auto world = buildWorld(document.scene, buildSettings(document));
    RenderSession session;
    session.start(world, document.camera, document.render);
    awaitCoarse(session);
    std::vector<double> coarse, rebuilt;
    Editor editor;
    for (int i = 0; i < kEdits; ++i) {
        std::this_thread::sleep_for(editor.pause());
        const Document changed = apply(document, editor.next(document));
        const auto start = Clock::now();
        const bool rebuild = changed.scene != document.scene;
        if (rebuild) {
            session.giveWay();
            world = buildWorld(changed.scene, buildSettings(changed), world.get());
        }
        const double build = secondsSince(start);
        session.start(world, changed.camera, changed.render);
        const double seconds = awaitCoarse(session).secondsToCoarse;
        coarse.push_back(seconds * 1e3);
        if (rebuild) rebuilt.push_back((build + seconds) * 1e3);
        document = changed;
    }
    printSeries(scene, coarse, {Goal::Of::Percentile95, 16});
    printSeries("  of the scene, with its rebuilding", rebuilt);
}

/// What changes no eye ray and nothing that it meets.
Command shadingEdit(int number) {
    switch (number % 4) {
    case 0:
        return Command::parse(
            fmt::format("material material=0 diffuse={},0.5,0.5", 0.2 + 0.7 * number / kShadingEdits));
    case 1:
        return Command::parse(fmt::format("set max-depth={}", 4 + number / 4 % 2));
    default: // off, then on
        return Command::parse("toggle key=shadows");
    }
}

/// Edits of shading alone, each after a whole sample. `known`: seen from the same place, so that the eye hits
/// are known; else from one that is hardly another.
void shade(const std::string& scene, bool known) {
    Document document = openForever(scene);
    auto world = buildWorld(document.scene, buildSettings(document));
    RenderSession session;
    const auto sample = [&] {
        session.start(world, document.camera, document.render);
        RenderStatus status = awaitCoarse(session);
        while (status.samples < 1) status = session.wait(std::chrono::milliseconds(1));
        return status;
    };
    sample();
    std::vector<double> coarse, first;
    for (int i = 0; i < kShadingEdits; ++i) {
        document = apply(document, shadingEdit(i));
        if (!known) document = apply(document, Command::parse("orbit yaw=0.001 pitch=0"));
        world = buildWorld(document.scene, buildSettings(document), world.get());
        const RenderStatus status = sample();
        coarse.push_back(status.secondsToCoarse * 1e3);
        first.push_back(status.secondsToFirstPass * 1e3);
    }
    const char* const how = known ? "" : ", hits not known";
    printSeries(fmt::format("{}, coarse{}", scene, how), coarse);
    printSeries(fmt::format("{}, sample{}", scene, how), first);
}

}

void benchCoarse() {
    printHeading("Edit to whole coarse picture, 1280x720", "ms");
    for (const char* scene : {"homage", "many", "terrain"}) edit(scene);
    printHeading("Edit of shading alone to coarse picture and to first sample", "ms");
    for (const char* scene : {"homage", "knot", "many", "terrain"})
        for (const bool known : {false, true}) shade(scene, known);
}

}
