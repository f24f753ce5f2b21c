#pragma once
// What the program remembers of a person between two starts.

#include <filesystem>
#include <string>
#include <vector>

namespace eyeray {

struct Preferences {
    bool dark = true;
    bool presenter = false; // large text
    bool panels = true;     // shown
    bool explain = false;   // rays in space, tree and sum beside the picture
    bool hover = true;      // what is under the pointer is told
    int windowWidth = 1440, windowHeight = 860;
    bool maximized = false;
    std::vector<std::string> recentScenes; // newest first

    /// Puts a scene at the front of the recent ones.
    void remember(const std::string& scene);
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Where they are kept: below the user's XDG configuration folder.
std::filesystem::path preferencesFile();

/// The preferences of a file; defaults for what it does not say or says wrongly.
Preferences loadPreferences(const std::filesystem::path&);

/// Writes them; nothing happens if that cannot be done: a program should not complain of it.
void savePreferences(const Preferences&, const std::filesystem::path&) noexcept;

}
