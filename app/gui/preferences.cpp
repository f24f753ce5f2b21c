#include "app/gui/preferences.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/command.h"
#include "app/document/user_folders.h"
#include "core/image/atomic_file.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;
constexpr std::size_t kMostBytes = 1U << 16U;
constexpr int kSmallestWindow = 320, kLargestWindow = 16384;

void read(Preferences& preferences, const Command& line) {
    if (line.name() == "recent") preferences.recentScenes.push_back(line.required("scene"));
    if (line.name() != "window") return;
    preferences.dark = line.flag("dark").value_or(preferences.dark);
    preferences.presenter = line.flag("presenter").value_or(preferences.presenter);
    preferences.panels = line.flag("panels").value_or(preferences.panels);
    preferences.explain = line.flag("explain").value_or(preferences.explain);
    preferences.hover = line.flag("hover").value_or(preferences.hover);
    preferences.maximized = line.flag("maximized").value_or(preferences.maximized);
    preferences.windowWidth =
        line.integer("width", kSmallestWindow, kLargestWindow).value_or(preferences.windowWidth);
    preferences.windowHeight =
        line.integer("height", kSmallestWindow, kLargestWindow).value_or(preferences.windowHeight);
}

}

void Preferences::remember(const std::string& scene) {
    std::erase(recentScenes, scene);
    recentScenes.insert(recentScenes.begin(), scene);
    if (recentScenes.size() > kMostRecent) recentScenes.resize(kMostRecent);
}

fs::path preferencesFile() {
    const fs::path folder = configFolder();
    return folder.empty() ? folder : folder / "eyeray" / "preferences";
}

Preferences loadPreferences(const fs::path& file) {
    Preferences preferences;
    try {
        const auto bytes = readFile(file, kMostBytes);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        for (const Command& line : parseCommands(text, file.string())) read(preferences, line);
    } catch (const std::exception&) {
        return preferences;
    }
    return preferences;
}

void savePreferences(const Preferences& preferences, const fs::path& file) noexcept {
    try {
        if (file.empty()) return;
        fs::create_directories(file.parent_path());
        std::string text = Command("window", {{"dark", toText(preferences.dark)},
                                              {"presenter", toText(preferences.presenter)},
                                              {"panels", toText(preferences.panels)},
                                              {"explain", toText(preferences.explain)},
                                              {"hover", toText(preferences.hover)},
                                              {"maximized", toText(preferences.maximized)},
                                              {"width", fmt::format("{}", preferences.windowWidth)},
                                              {"height", fmt::format("{}", preferences.windowHeight)}})
                               .text() +
                           "\n";
        for (const std::string& scene : preferences.recentScenes)
            text += Command("recent", {{"scene", scene}}).text() + "\n";
        writeFileAtomically(file, std::as_bytes(std::span(text)));
    } catch (const std::exception&) {
        return;
    }
}

}
