#pragma once
// From a scene's name or path to a document.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/scene/gltf.h"

namespace eyeray {

inline constexpr const char* kDefaultScene = "homage";

/// Folder of the program's assets: beside the installed program, else the source tree that it was built from.
std::filesystem::path assetsFolder();

struct BuiltinScene {
    std::string name, whatToLookAt;
    std::filesystem::path path;
};

/// The built-in scenes by name; empty if the assets are missing.
std::vector<BuiltinScene> builtinScenes();

/// A scene as it came from its file, and how pictures refer to it.
struct OpenedScene {
    Document document;
    ImportReport report;
    std::filesystem::path path;
    std::string reference;      // a built-in scene's name, else its path
    bool meterExposure = false; // from the first picture, for nothing has stated one
    std::string sha256;         // of the file
    double loadSeconds = 0;
};

/// Opens a built-in scene or a demonstration of the failure lab by name, a glTF file, or a picture that
/// Eyeray made: then the picture's scene in the picture's state, with a line in the report if the scene has
/// changed since. Throws InputError. Without a document if `stop` was requested.
OpenedScene openScene(const std::string& nameOrPath, const std::stop_token& stop = {});

/// What openScene opens this scene by from any working folder.
std::string lastingReference(const OpenedScene&);

/// Applies commands as if the scene itself had asked for them.
void applyTo(OpenedScene&, const std::vector<Command>&);

}
