#pragma once
// Where a person keeps things, by the XDG base directory and user directory rules.

#include <filesystem>

namespace eyeray {

/// Folder of programs' settings: $XDG_CONFIG_HOME, else ~/.config; empty if there is no home.
std::filesystem::path configFolder();

/// Folder of what programs can make again: $XDG_CACHE_HOME, else ~/.cache; empty if there is no home.
std::filesystem::path cacheFolder();

/// The user's Pictures folder as the desktop has it, else ~/Pictures, else the working folder.
std::filesystem::path picturesFolder();

}
