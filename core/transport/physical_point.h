#pragma once
// A ray of the physical methods and the point that it hits.

#include "core/transport/bsdf.h"
#include "core/transport/direct_light.h"
#include "core/transport/next_rays.h"

namespace eyeray {

struct PhysicalRay {
    TreeRay tree;
    std::uint32_t key = 0;  // addresses the random numbers at its end
    float pdfW = 0;         // with which it was sent; 0: it could not have gone elsewhere, as the eye ray
    bool scattered = false; // a rough or diffuse surface lies on its way from the eye
    std::uint32_t instance = 0xffffffff; // of the World, that it leaves; the eye ray leaves none
    bool forLamps = false; // one deeper than max depth: it only looks for lamps, beside the shadow rays
};

/// The key of a next ray.
inline std::uint32_t keyOfNext(const PhysicalRay& ray, RayKind kind) {
    return hashCombine(ray.key, static_cast<std::uint32_t>(kind) + 1);
}

/// Where a PhysicalRay ends.
struct PhysicalPoint {
    ShadingPoint p; // its `surface` has what no texture changes
    PhysicalSurface surface;
    Interface interface; // valid where the surface is transparent

    /// What a ray that leaves along `direction` runs in, if the one that came here runs in `media`.
    const MediumStack& mediaTowards(const Vec3& direction, const MediumStack& media) const {
        return glm::dot(p.geometricNormal, direction) < 0 ? interface.beyond : media;
    }

    Bsdf bsdf() const {
        return {surface, {p.wo, p.normal, p.geometricNormal, interface.eta, !p.object->solid}};
    }
};

template <Features F, class Index>
PhysicalPoint physicalPointAt(const World& world, const IndexedGeometry<Index>& geometry,
                              const PhysicalRay& ray, const Hit& hit) {
    constexpr Features kConstant{.varying = false, .transparent = F.transparent};
    std::optional<Surface> none;
    PhysicalPoint point{.p = shadingPointAt<kConstant>(world, geometry, ray.tree.ray, hit, none),
                        .surface = {},
                        .interface = {1, ray.tree.media}};
    const WorldObject& object = *point.p.object;
    const WorldMaterial& material = world.materials[object.material];
    if (F.varying && (material.varies || object.vertexColors)) {
        const auto uv = [&](int set) { return textureCoordinates(geometry, point.p.at, hit, set); };
        point.surface = physicalAt(world, material, uv, Color(vertexColor(geometry, hit)));
    } else {
        point.surface = material.physical;
    }
    if (F.transparent && point.surface.transparency > 0)
        point.interface = interfaceAt(world, point.p, ray.tree.media);
    return point;
}

/// Share of the light that is left after `distance` in a medium.
inline Color transmittanceIn(const World& world, const MediumStack& media, float distance) {
    if (media.top() == MediumStack::kVacuum) return Color(1);
    return transmittanceOf(world.materials[world.objects[media.top()].material].surface.attenuation,
                           distance);
}

}
