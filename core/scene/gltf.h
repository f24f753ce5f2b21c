#pragma once
// glTF 2.0 in and out. assets/FORMAT.md says what is read, and what extras.eyeray adds.

#include <cstddef>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace eyeray {

/// What an import did that the file did not say, or left out, and what cannot look right; one line each, for
/// the user.
struct ImportReport {
    enum class Kind : std::uint8_t { Ignored, Repaired, Added, Doubtful };
    struct Line {
        Kind kind;
        std::string text; // "materials[2]: normalTexture is not shown"
    };
    std::vector<Line> lines;
};

/// Reads a .gltf or .glb file. Every index, range and number of the file is checked; external files must lie
/// in the file's own folder. Throws InputError naming the file and the part; never crashes, hangs or takes
/// unbounded memory. Stops with an empty Scene when `stop` is requested.
Scene importGltf(const std::filesystem::path&, ImportReport&, const std::stop_token& stop = {});

/// The same from memory (.glb or JSON without external files); `where` names it in messages.
Scene importGltf(std::span<const std::byte>, const std::string& where, ImportReport&,
                 const std::stop_token& stop = {});

/// Writes the scene as .glb or .gltf with embedded buffers, by the name's ending; whole or not at all.
/// Reading it back gives the same picture. Throws InputError for another ending, Failure if it cannot be
/// written.
void exportGltf(const Scene&, const std::filesystem::path&);

}
