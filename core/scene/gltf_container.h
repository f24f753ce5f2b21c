#pragma once
// The outermost layer of a scene file: is it what it claims to be, before any parser sees it.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace eyeray {

struct GltfContainer {
    std::string_view json;
    std::span<const std::byte> binary; // the BIN chunk of a .glb; empty where there is none
};

/// The parts of a .glb, or a .gltf as it is; both point into `file`. The lengths, order and kinds of the
/// chunks are checked, and the brackets of the JSON counted, so that a recursive parser cannot run out of
/// stack. Throws InputError.
GltfContainer openContainer(std::span<const std::byte> file, const std::string& where);

}
