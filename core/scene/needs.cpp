#include "core/scene/needs.h"

#include <algorithm>

#include "core/scene/surface.h"

namespace eyeray {
namespace {

MaterialNeeds needsOfModel(const TaughtMaterial& m) {
    const Surface surface = surfaceOf(m);
    return {.reflects = surface.reflects() || surface.transmits(),
            .transmits = surface.transmits(),
            .textured = m.diffuseTexture.used()};
}

// A texture only multiplies its factor, so a factor of 0 stays 0; but less metal or roughness is more glass
// or gloss.
MaterialNeeds needsOfModel(const GltfMaterial& m) {
    const Surface surface = surfaceOf(m);
    const bool variesInGloss = m.metallicRoughnessTexture.used();
    const bool transmits = surface.transmits() || (variesInGloss && m.transmission > 0);
    return {.reflects = surface.reflects() || transmits || variesInGloss,
            .transmits = transmits,
            .textured = m.baseColorTexture.used() || variesInGloss || m.emissiveTexture.used() ||
                        m.transmissionTexture.used()};
}

bool hasVertexColors(const Scene& scene, const Object& object) {
    const auto* mesh = std::get_if<MeshId>(&object.geometry);
    return mesh != nullptr && !scene.meshes[static_cast<std::size_t>(mesh->index)].triangles->colors.empty();
}

}

MaterialNeeds needsOf(const MaterialModel& model) {
    return std::visit([](const auto& m) { return needsOfModel(m); }, model);
}

SceneNeeds analyseNeeds(const Scene& scene) {
    SceneNeeds needs;
    bool anyObject = false;
    for (const Object& object : scene.objects) {
        if (!object.visible) continue;
        anyObject = true;
        const MaterialNeeds m = needsOf(scene.materials[static_cast<std::size_t>(object.material)].model);
        needs.reflections |= m.reflects;
        needs.refractions |= m.transmits;
        needs.textures |= m.textured || hasVertexColors(scene, object);
    }
    const bool lit = std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
        return light.enabled && light.intensity > 0 && !isBlack(light.color);
    });
    needs.shadows = lit && anyObject;

    const auto leaveOut = [&](bool needed, const char* reason) {
        if (!needed) needs.reasons.emplace_back(reason);
    };
    leaveOut(needs.shadows, lit ? "no shadow rays: there is no object" : "no shadow rays: no lamp shines");
    leaveOut(needs.reflections, "no reflection rays: no material is a mirror or a dielectric");
    leaveOut(needs.refractions, "no refraction rays: no material transmits light");
    leaveOut(needs.textures, "no texture reads: no material has a texture");
    return needs;
}

}
