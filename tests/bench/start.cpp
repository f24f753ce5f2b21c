// From a scene's name to its first picture, and what building its index takes.

#include "app/document/scene_files.h"
#include "app/gui/gui.h"
#include "app/platform/headless_platform.h"
#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kStarts = 10;

double openToCoarse(const std::string& scene) {
    const auto start = Clock::now();
    const Document document = openForever(scene);
    const auto world = buildWorld(document.scene, buildSettings(document));
    RenderSession session;
    session.start(world, document.camera, document.render);
    awaitCoarse(session);
    return secondsSince(start) * 1e3;
}

/// The window too: OpenGL, letters, and frames until one shows the picture.
double windowToCoarse(const std::string& scene) {
    const auto start = Clock::now();
    HeadlessPlatform platform(kWidth, kHeight);
    Viewer viewer;
    Gui gui(viewer, platform, Preferences{});
    viewer.openInBackground(scene, {});
    for (bool shown = false; !shown;) {
        shown = viewer.status().secondsToCoarse > 0;
        platform.beginFrame();
        gui.frame();
        platform.endFrame();
        gui.afterFrame();
    }
    platform.screenshot();
    return secondsSince(start) * 1e3;
}

double buildOnly(const Document& document) {
    const auto start = Clock::now();
    buildWorld(document.scene, buildSettings(document));
    return secondsSince(start) * 1e3;
}

template <class Measure>
std::vector<double> repeated(const Measure& measure) {
    std::vector<double> values;
    values.reserve(kStarts);
    for (int i = 0; i < kStarts; ++i) values.push_back(measure());
    return values;
}

}

void benchStart() {
    printHeading("Start to first coarse picture, 1280x720", "ms");
    printSeries("homage, the core alone", repeated([] { return openToCoarse(kDefaultScene); }),
                {Goal::Of::Median, 500});
    printSeries("homage, the window drawn", repeated([] { return windowToCoarse(kDefaultScene); }),
                {Goal::Of::Median, 500});
    printSeries("terrain, the core alone", repeated([] { return openToCoarse("terrain"); }));
    printHeading("Building the World", "ms");
    for (const char* scene : {"homage", "many", "terrain"}) {
        const Document document = openForever(scene);
        printSeries(scene, repeated([&] { return buildOnly(document); }));
    }
}

}
