#include "core/scene/needs.h"

#include <algorithm>

#include "core/scene/physical_surface.h"
#include "core/scene/surface.h"

namespace eyeray {
namespace {

MaterialNeeds needsOfModel(const TaughtMaterial& m) {
    const Surface surface = surfaceOf(m);
    const PhysicalSurface physical = physicalOf(m);
    return {.reflects = surface.reflects() || surface.transmits(),
            .transmits = surface.transmits(),
            .textured = m.diffuseTexture.used(),
            .reflectsPhysically = !physical.opaque.black() || surface.transmits(),
            .diffuses = !isBlack(physical.diffuse),
            .glows = !isBlack(m.emission)};
}

// A texture only multiplies its factor, so a factor of 0 stays 0; but less metal or roughness is more glass
// or gloss, and less metal or glass is more of a matte body.
MaterialNeeds needsOfModel(const GltfMaterial& m) {
    const Surface surface = surfaceOf(m);
    const bool variesInGloss = m.metallicRoughnessTexture.used();
    const bool transmits = surface.transmits() || (variesInGloss && m.transmission > 0);
    const bool variesInBody = variesInGloss || m.transmissionTexture.used();
    const PhysicalSurface physical = physicalOf(m);
    return {.reflects = surface.reflects() || transmits || variesInGloss,
            .transmits = transmits,
            .textured = m.baseColorTexture.used() || variesInGloss || m.emissiveTexture.used() ||
                        m.transmissionTexture.used(),
            .reflectsPhysically = !physical.opaque.black() || transmits,
            .diffuses = !isBlack(physical.diffuse) || (variesInBody && !isBlack(m.baseColor)),
            .glows = !isBlack(physical.emission)};
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
    std::vector<MaterialNeeds> ofMaterial;
    ofMaterial.reserve(scene.materials.size());
    for (const Material& material : scene.materials) ofMaterial.push_back(needsOf(material.model));

    SceneNeeds needs;
    bool anyObject = false;
    bool shines = !scene.environment.black();
    for (const Object& object : scene.objects) {
        if (!object.visible) continue;
        anyObject = true;
        const MaterialNeeds& m = ofMaterial[static_cast<std::size_t>(object.material)];
        needs.reflections |= m.reflects;
        needs.refractions |= m.transmits;
        needs.textures |= m.textured || hasVertexColors(scene, object);
        needs.physical.reflections |= m.reflectsPhysically;
        needs.physical.diffuse |= m.diffuses;
        shines |= m.glows;
    }
    const bool lit = std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
        return light.enabled && light.intensity > 0 && !isBlack(light.color);
    });
    needs.shadows = lit && anyObject;
    needs.physical.shadows = (lit || shines) && anyObject;

    const auto leaveOut = [](std::vector<std::string>& reasons, bool needed, const char* reason) {
        if (!needed) reasons.emplace_back(reason);
    };
    const auto leaveOutOfAll = [&](bool needed, const char* reason) {
        leaveOut(needs.reasons, needed, reason);
        leaveOut(needs.physical.reasons, needed, reason);
    };
    constexpr const char* kNoObject = "no shadow rays: there is no object";
    leaveOut(needs.reasons, needs.shadows, lit ? kNoObject : "no shadow rays: no lamp shines");
    leaveOut(needs.physical.reasons, needs.physical.shadows,
             lit || shines ? kNoObject : "no shadow rays: no lamp, sky or object shines");
    leaveOut(needs.reasons, needs.reflections, "no reflection rays: no material is a mirror or a dielectric");
    leaveOut(needs.physical.reasons, needs.physical.reflections,
             "no reflection rays: every material is matte");
    leaveOutOfAll(needs.refractions, "no refraction rays: no material transmits light");
    leaveOut(needs.physical.reasons, needs.physical.diffuse, "no diffuse rays: no material is matte");
    leaveOutOfAll(needs.textures, "no texture reads: no material has a texture");
    return needs;
}

}
