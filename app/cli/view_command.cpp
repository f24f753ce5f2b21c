#include <algorithm>
#include <chrono>
#include <fstream>

#include <fmt/format.h>

#include "app/cli/run.h"
#include "app/gui/gui.h"
#include "app/platform/glfw_platform.h"

namespace eyeray {
namespace {

constexpr double kFrame = 1.0 / 30; // seconds; while something moves
constexpr double kIdle = 1.0;       // between looks at the scene file
constexpr int kSettlingFrames = 3;  // after input: ImGui needs some to come to rest

/// For scripts that play a person: name and rectangle of each widget, one a line.
void logWidgets(const Gui& gui, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::trunc);
    for (const auto& [name, r] : gui.widgets())
        out << fmt::format("{:.0f} {:.0f} {:.0f} {:.0f} {}\n", r.x0, r.y0, r.x1, r.y1, name);
}

std::string title(const Viewer& viewer) {
    return viewer.hasScene() ? fmt::format("{} – Eyeray", viewer.opened().reference) : std::string("Eyeray");
}

}

int run(const ViewOptions& options) {
    Preferences preferences = loadPreferences(preferencesFile());
    GlfwPlatform platform(
        "Eyeray", WindowSize{preferences.windowWidth, preferences.windowHeight, preferences.maximized});
    Viewer viewer;
    Gui gui(viewer, platform, preferences);
    viewer.openInBackground(options.picture.scene, options.picture.commands);

    std::string shownTitle;
    int settling = kSettlingFrames;
    while (!platform.closing() && !gui.quitAsked()) {
        const auto start = std::chrono::steady_clock::now();
        platform.beginFrame();
        gui.frame();
        platform.endFrame();
        gui.afterFrame();
        if (options.widgets) logWidgets(gui, *options.widgets);
        if (title(viewer) != shownTitle) platform.setTitle(shownTitle = title(viewer));

        settling = gui.animating() ? kSettlingFrames : settling - 1;
        const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (settling > 0) {
            platform.waitEvents(std::max(0.0, kFrame - spent));
        } else {
            platform.waitEvents(kIdle);
            settling = kSettlingFrames;
        }
    }
    preferences = gui.preferences();
    const WindowSize window = platform.windowSize();
    preferences.windowWidth = window.width;
    preferences.windowHeight = window.height;
    preferences.maximized = window.maximized;
    savePreferences(preferences, preferencesFile());
    return 0;
}

}
