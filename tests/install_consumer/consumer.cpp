#include "core/base/errors.h"
#include "core/base/sampling.h"
#include "core/scene/gltf.h"

/// Succeeds when the library answers as its headers say. The importer brings every library that the core
/// needs.
int main() {
    const eyeray::Vec2 sample = eyeray::pixelSample({.seed = 1, .x = 2, .y = 3, .pass = 0});
    if (sample != eyeray::Vec2(0.5F)) return 1;
    try {
        eyeray::ImportReport report;
        eyeray::importGltf("no such scene.glb", report);
    } catch (const eyeray::InputError&) {
        return 0;
    }
    return 1;
}
