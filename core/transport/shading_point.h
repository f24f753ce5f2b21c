#pragma once
// A hit, ready for shading.

#include "core/base/ray_kind.h"
#include "core/geometry/accel.h"
#include "core/scene/world.h"

namespace eyeray {

/// What a scene has, known before tracing: code for the rest is not compiled in.
struct Features {
    bool varying = false;     // materials with textures or vertex colours
    bool transparent = false; // materials that transmit
};

/// Normals are turned to the side of wo.
struct ShadingPoint {
    SurfacePoint at;
    Vec3 wo;              // unit, back along the ray
    Vec3 normal;          // for shading; dot(normal, wo) > 0
    Vec3 geometricNormal; // dot(geometricNormal, wo) >= 0
    bool front;           // the surface's own side was hit
    std::uint32_t instance;
    const WorldObject* object;
    const Surface* surface; // of the World, or what the caller holds
};

/// Where a shadow ray towards the unit direction wi starts: on this side of the surface, lifted to the
/// rounded one that a mesh stands for, so that no facet shades what its normals call lit.
inline Vec3 shadowOrigin(const ShadingPoint& p, const Vec3& wi) {
    if (!(glm::dot(p.normal, wi) > 0)) return spawnOrigin(p.at, wi);
    return spawnOrigin(p.at, p.geometricNormal) + p.at.lift;
}

/// The point that `hit` of `ray` (of unit direction) describes. `own` is to live as long: it holds the
/// surface of a material that varies.
template <Features F, class Index>
ShadingPoint shadingPointAt(const World& world, const IndexedGeometry<Index>& geometry, const Ray& ray,
                            const Hit& hit, std::optional<Surface>& own) {
    ShadingPoint p;
    p.at = surfaceAt(geometry, ray, hit);
    p.wo = -ray.direction;
    p.front = glm::dot(p.at.geometricNormal, p.wo) >= 0;
    p.geometricNormal = p.front ? p.at.geometricNormal : -p.at.geometricNormal;
    const bool sameSide = glm::dot(p.at.shadingNormal, p.at.geometricNormal) >= 0;
    p.normal = p.front == sameSide ? p.at.shadingNormal : -p.at.shadingNormal;
    if (!(glm::dot(p.normal, p.wo) > 0)) p.normal = p.geometricNormal;
    p.instance = hit.instance;
    p.object = &world.objects[hit.instance];
    const WorldMaterial& material = world.materials[p.object->material];
    if constexpr (F.varying) {
        if (material.varies || p.object->vertexColors) {
            const auto uv = [&](int set) { return textureCoordinates(geometry, p.at, hit, set); };
            own = surfaceAt(world, material, uv, Color(vertexColor(geometry, hit)));
            p.surface = &*own;
            return p;
        }
    }
    p.surface = &material.surface;
    return p;
}

}
