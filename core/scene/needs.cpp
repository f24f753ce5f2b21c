#include "core/scene/needs.h"

#include <algorithm>
#include <type_traits>

namespace eyeray {
namespace {

struct MaterialNeeds {
    bool reflects, transmits, textured;
};

MaterialNeeds needsOf(const TaughtMaterial& m) {
    return {!isBlack(m.reflectivity) || !isBlack(m.transmission), !isBlack(m.transmission),
            m.diffuseTexture.used()};
}

MaterialNeeds needsOf(const GltfMaterial& m) {
    const TaughtMaterial taught = asTaught(m);
    const bool textured = m.baseColorTexture.used() || m.metallicRoughnessTexture.used() ||
                          m.emissiveTexture.used() || m.transmissionTexture.used();
    // a texture only multiplies its factor, so a factor of 0 stays 0; roughness may become 0 anywhere under a
    // texture
    const bool mirrors = m.metallicRoughnessTexture.used() || !isBlack(taught.reflectivity);
    return {mirrors || m.transmission > 0, m.transmission > 0, textured};
}

bool hasVertexColors(const Scene& scene, const Object& object) {
    const auto* mesh = std::get_if<MeshId>(&object.geometry);
    return mesh != nullptr && !scene.meshes[static_cast<std::size_t>(mesh->index)].triangles->colors.empty();
}

}

SceneNeeds analyseNeeds(const Scene& scene) {
    SceneNeeds needs;
    bool anyObject = false;
    for (const Object& object : scene.objects) {
        if (!object.visible) continue;
        anyObject = true;
        const auto& model = scene.materials[static_cast<std::size_t>(object.material)].model;
        const MaterialNeeds m = std::visit([](const auto& material) { return needsOf(material); }, model);
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
