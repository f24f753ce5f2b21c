#pragma once
// A scene file taken apart: its JSON as structures, its buffers and images as bytes.

#include <cstddef>
#include <list>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "core/scene/gltf_files.h"
#include "core/scene/gltf_notes.h"

namespace eyeray {

/// An entry of `images`; its bytes are read when a material asks for them.
struct GltfImageSource {
    std::string name, uri; // no uri: see bufferView
    int bufferView = -1;
};

struct GltfDocument {
    std::string where;     // the file, for messages
    tinygltf::Model model; // without buffers, images, animations and skins
    std::vector<std::span<const std::byte>> buffers;
    std::vector<GltfImageSource> images;
    std::list<std::vector<std::byte>> storage; // what `buffers` point to, unless it is the file itself

    /// "scene.gltf: accessors[3]".
    std::string at(const char* section, std::size_t index) const;
};

/// Parses a .gltf or .glb and gathers its buffers. tinygltf sees only JSON that has been checked: sections
/// are lists of objects, nesting is bounded, indices are whole and not negative; never a URI, a buffer or an
/// image. Version, required extensions, and the number and size of things are checked; indices are not yet
/// compared with what they point to. `file` must outlive the result. Throws InputError.
GltfDocument parseDocument(std::span<const std::byte> file, const std::string& where, const GltfFiles&,
                           GltfNotes&);

}
