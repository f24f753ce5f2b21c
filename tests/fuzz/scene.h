#pragma once
// Any bytes as a scene file: imported, indexed and looked at.

#include <cmath>
#include <span>

#include "core/scene/gltf.h"
#include "tests/fuzz/accepted.h"
#include "tests/scenes.h"

namespace eyeray::fuzz {

inline std::size_t trianglesOf(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects)
        if (const auto* mesh = std::get_if<MeshId>(&object.geometry))
            count += scene.meshes[static_cast<std::size_t>(mesh->index)].triangles->triangles.size();
    return count;
}

/// The file is refused with an InputError, or what it holds is whole and can be rendered.
inline void scene(std::span<const std::byte> bytes) {
    constexpr std::size_t kMostTriangles = 20'000; // more would only take time
    constexpr int kSide = 8;
    Scene scene;
    ImportReport report;
    if (!accepted([&] { scene = importGltf(bytes, "fuzzed", report); })) return;
    validate(scene);
    if (trianglesOf(scene) > kMostTriangles || scene.objects.size() > kMostTriangles) return;
    const TileResult tile = scenes::Tracing(scene, scenes::toDepth(3), kSide, kSide).tile();
    for (const Color& c : tile.radiance) ENSURE(isFinite(c));
}

}
