#pragma once
// Materials with textures, read at a point.

#include "core/scene/texture.h"
#include "core/scene/world.h"

namespace eyeray {

namespace detail {

template <class Uv>
Color read(const Scene& scene, const TextureRef& ref, const Uv& uv, TextureCoding coding) {
    if (!ref.used()) return Color(1);
    const Texture& texture = scene.textures[static_cast<std::size_t>(ref.texture)];
    return textureValue(scene, texture, ref.transformed(uv(ref.uvSet)), coding);
}

/// What a taught material's ka and kd are multiplied by at a point; nothing else of it varies.
template <class Uv>
Color diffuseFactor(const Scene& scene, const TaughtMaterial& material, const Uv& uv,
                    const Color& vertexColor) {
    return vertexColor * read(scene, material.diffuseTexture, uv, TextureCoding::Srgb);
}

/// The material with its textures read, for this point alone.
template <class Uv>
TaughtMaterial readMaterial(const Scene& scene, TaughtMaterial material, const Uv& uv,
                            const Color& vertexColor) {
    const Color factor = diffuseFactor(scene, material, uv, vertexColor);
    material.ambient *= factor;
    material.diffuse *= factor;
    return material;
}

template <class Uv>
GltfMaterial readMaterial(const Scene& scene, GltfMaterial material, const Uv& uv, const Color& vertexColor) {
    material.baseColor *= vertexColor * read(scene, material.baseColorTexture, uv, TextureCoding::Srgb);
    const Color metallicRoughness = read(scene, material.metallicRoughnessTexture, uv, TextureCoding::Linear);
    material.metallic *= metallicRoughness.b;
    material.roughness *= metallicRoughness.g;
    material.emissive *= read(scene, material.emissiveTexture, uv, TextureCoding::Srgb);
    material.transmission *= read(scene, material.transmissionTexture, uv, TextureCoding::Linear).r;
    return material;
}

}

template <class Uv>
Surface surfaceAt(const World& world, const WorldMaterial& material, const Uv& uv, const Color& vertexColor) {
    return std::visit(
        [&](const auto& model) {
            return surfaceOf(detail::readMaterial(*world.scene, model, uv, vertexColor));
        },
        material.model);
}

template <class Uv>
PhysicalSurface physicalAt(const World& world, const WorldMaterial& material, const Uv& uv,
                           const Color& vertexColor) {
    return std::visit(
        [&](const auto& model) {
            return physicalOf(detail::readMaterial(*world.scene, model, uv, vertexColor));
        },
        material.model);
}

}
