#include "app/document/user_folders.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace eyeray {
namespace {

namespace fs = std::filesystem;

fs::path environmentPath(const char* variable) {
    const char* value =
        std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
    return value != nullptr ? fs::path(value) : fs::path();
}

}

fs::path configFolder() {
    if (fs::path config = environmentPath("XDG_CONFIG_HOME"); !config.empty()) return config;
    const fs::path home = environmentPath("HOME");
    return home.empty() ? fs::path() : home / ".config";
}

fs::path cacheFolder() {
    if (fs::path cache = environmentPath("XDG_CACHE_HOME"); !cache.empty()) return cache;
    const fs::path home = environmentPath("HOME");
    return home.empty() ? fs::path() : home / ".cache";
}

fs::path picturesFolder() {
    const fs::path home = environmentPath("HOME");
    if (home.empty()) return fs::current_path();
    std::ifstream file(configFolder() / "user-dirs.dirs");
    constexpr std::string_view kKey = "XDG_PICTURES_DIR=\"", kHome = "$HOME";
    std::string folder;
    for (std::string line; std::getline(file, line);)
        if (line.rfind(kKey, 0) == 0) folder = line.substr(kKey.size(), line.rfind('"') - kKey.size());
    if (folder.rfind(kHome, 0) == 0) folder.replace(0, kHome.size(), home.string());
    std::error_code error;
    if (!folder.empty() && fs::is_directory(folder, error)) return folder;
    if (fs::is_directory(home / "Pictures", error)) return home / "Pictures";
    return fs::current_path();
}

}
