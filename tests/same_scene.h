#pragma once
// Whether two scenes show the same and can be edited in the same way; their indices may differ.

#include <gtest/gtest.h>

#include "core/scene/scene.h"

namespace eyeray::test {

inline constexpr double kUnitError = 1e-14; // candela and back

inline void expectSame(const DVec3& a, const DVec3& b, double tolerance = 1e-12) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

inline void expectSame(const TriangleMesh& a, const TriangleMesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.uvs, b.uvs);
    EXPECT_EQ(a.colors, b.colors);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.doubleSided, b.doubleSided);
}

inline void expectSame(const Shape& a, const Shape& b) {
    ASSERT_EQ(a.index(), b.index());
    if (const auto* const s = std::get_if<Sphere>(&a)) {
        EXPECT_EQ(s->radius, std::get<Sphere>(b).radius);
    }
    if (const auto* const s = std::get_if<Box>(&a)) {
        EXPECT_EQ(s->size, std::get<Box>(b).size);
    }
    if (const auto* const s = std::get_if<Plane>(&a)) {
        const auto& other = std::get<Plane>(b);
        EXPECT_TRUE(s->sizeX == other.sizeX && s->sizeZ == other.sizeZ &&
                    s->doubleSided == other.doubleSided);
    }
    if (const auto* const s = std::get_if<Cylinder>(&a)) {
        const auto& other = std::get<Cylinder>(b);
        EXPECT_TRUE(s->height == other.height && s->radiusTop == other.radiusTop &&
                    s->radiusBottom == other.radiusBottom);
    }
}

inline void expectSame(const Scene& sa, const TextureRef& a, const Scene& sb, const TextureRef& b) {
    ASSERT_EQ(a.used(), b.used());
    if (!a.used()) return;
    EXPECT_EQ(a.uvSet, b.uvSet);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.rotation, b.rotation);
    const Texture& ta = sa.textures.at(static_cast<std::size_t>(a.texture));
    const Texture& tb = sb.textures.at(static_cast<std::size_t>(b.texture));
    ASSERT_EQ(ta.source.index(), tb.source.index());
    if (const auto* const checker = std::get_if<CheckerTexture>(&ta.source)) {
        EXPECT_EQ(checker->even, std::get<CheckerTexture>(tb.source).even);
        EXPECT_EQ(checker->odd, std::get<CheckerTexture>(tb.source).odd);
        return;
    }
    const auto &ia = std::get<ImageTexture>(ta.source), &ib = std::get<ImageTexture>(tb.source);
    EXPECT_EQ(ta.name, tb.name);
    EXPECT_TRUE(ia.wrapU == ib.wrapU && ia.wrapV == ib.wrapV && ia.nearest == ib.nearest);
    EXPECT_EQ(*sa.images.at(static_cast<std::size_t>(ia.image)).pixels,
              *sb.images.at(static_cast<std::size_t>(ib.image)).pixels);
}

inline void expectSame(const Scene& sa, const TaughtMaterial& a, const Scene& sb, const TaughtMaterial& b) {
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.diffuse, b.diffuse);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.shininess, b.shininess);
    EXPECT_EQ(a.specularModel, b.specularModel);
    EXPECT_EQ(a.reflectivity, b.reflectivity);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.attenuation, b.attenuation);
    EXPECT_EQ(a.emission, b.emission);
    expectSame(sa, a.diffuseTexture, sb, b.diffuseTexture);
}

inline void expectSame(const Scene& sa, const GltfMaterial& a, const Scene& sb, const GltfMaterial& b) {
    EXPECT_EQ(a.baseColor, b.baseColor);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.emissiveStrength, b.emissiveStrength);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.specularColor, b.specularColor);
    EXPECT_EQ(a.thickness, b.thickness);
    EXPECT_EQ(a.attenuationDistance, b.attenuationDistance);
    EXPECT_EQ(a.attenuationColor, b.attenuationColor);
    expectSame(sa, a.baseColorTexture, sb, b.baseColorTexture);
    expectSame(sa, a.metallicRoughnessTexture, sb, b.metallicRoughnessTexture);
    expectSame(sa, a.emissiveTexture, sb, b.emissiveTexture);
    expectSame(sa, a.transmissionTexture, sb, b.transmissionTexture);
}

inline void expectSameMaterial(const Scene& sa, int a, const Scene& sb, int b) {
    const Material &ma = sa.materials.at(static_cast<std::size_t>(a)),
                   &mb = sb.materials.at(static_cast<std::size_t>(b));
    EXPECT_EQ(ma.name, mb.name);
    ASSERT_EQ(ma.model.index(), mb.model.index());
    std::visit(
        [&](const auto& model) {
            expectSame(sa, model, sb, std::get<std::decay_t<decltype(model)>>(mb.model));
        },
        ma.model);
}

inline void expectSame(const Scene& sa, const Object& a, const Scene& sb, const Object& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.transform, b.transform);
    EXPECT_EQ(a.visible, b.visible);
    expectSameMaterial(sa, a.material, sb, b.material);
    ASSERT_EQ(a.geometry.index(), b.geometry.index());
    if (const auto* const mesh = std::get_if<MeshId>(&a.geometry)) {
        const Mesh &ma = sa.meshes.at(static_cast<std::size_t>(mesh->index)),
                   &mb = sb.meshes.at(static_cast<std::size_t>(std::get<MeshId>(b.geometry).index));
        EXPECT_EQ(ma.name, mb.name);
        expectSame(*ma.triangles, *mb.triangles);
    } else {
        expectSame(sa.shapes.at(static_cast<std::size_t>(std::get<ShapeId>(a.geometry).index)),
                   sb.shapes.at(static_cast<std::size_t>(std::get<ShapeId>(b.geometry).index)));
    }
}

inline void expectSame(const Light& a, const Light& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.color, b.color);
    EXPECT_NEAR(a.intensity, b.intensity, kUnitError * a.intensity);
    EXPECT_TRUE(a.falloff == b.falloff && a.enabled == b.enabled && a.followsCamera == b.followsCamera);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(a.transform, b.transform);
    ASSERT_EQ(a.shape.index(), b.shape.index());
    if (const auto* const s = std::get_if<SpotLamp>(&a.shape)) {
        EXPECT_EQ(s->innerCone, std::get<SpotLamp>(b.shape).innerCone);
        EXPECT_EQ(s->outerCone, std::get<SpotLamp>(b.shape).outerCone);
    }
    if (const auto* const s = std::get_if<RectangleLamp>(&a.shape)) {
        EXPECT_EQ(s->width, std::get<RectangleLamp>(b.shape).width);
        EXPECT_EQ(s->height, std::get<RectangleLamp>(b.shape).height);
    }
    if (const auto* const s = std::get_if<DiscLamp>(&a.shape)) {
        EXPECT_EQ(s->radius, std::get<DiscLamp>(b.shape).radius);
    }
    if (const auto* const s = std::get_if<SphereLamp>(&a.shape)) {
        EXPECT_EQ(s->radius, std::get<SphereLamp>(b.shape).radius);
    }
}

inline void expectSame(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.verticalFov, b.verticalFov);
    EXPECT_EQ(a.aspect, b.aspect);
    expectSame(a.eye, b.eye);
    expectSame(a.target, b.target);
    expectSame(axesOf(a).right, axesOf(b).right);
    expectSame(axesOf(a).up, axesOf(b).up);
    EXPECT_DOUBLE_EQ(a.lensRadius, b.lensRadius);
    EXPECT_DOUBLE_EQ(a.focusDistance, b.focusDistance);
}

/// Two scenes that show the same and can be edited in the same way.
inline void expectSame(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.whatToLookAt, b.whatToLookAt);
    EXPECT_EQ(a.settings, b.settings);
    EXPECT_EQ(a.statesExposure, b.statesExposure);
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.environment.zenith, b.environment.zenith);
    EXPECT_EQ(a.environment.horizon, b.environment.horizon);
    EXPECT_EQ(a.environment.nadir, b.environment.nadir);
    ASSERT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < a.objects.size(); ++i) expectSame(a, a.objects[i], b, b.objects[i]);
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) expectSame(a.lights[i], b.lights[i]);
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (std::size_t i = 0; i < a.cameras.size(); ++i) expectSame(a.cameras[i], b.cameras[i]);
}

}
