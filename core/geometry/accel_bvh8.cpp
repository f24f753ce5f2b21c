// Rays through Bvh8: the whole way of a ray is compiled for each instruction set, and chosen once per ray.
// SIMD only rules out; what is left is decided by the same scalar tests that all indices use, so all find the
// same hits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/geometry/accel_bvh8.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/accel.h"
#include "core/geometry/bvh8_traversal.h"
#include "core/geometry/nearest_hit.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

// Calls offer(hit) for hits at t in (tMin, limit) until it returns true; whether it did.
template <class Offer>
bool visitMesh(const IndexedMesh<Bvh8>& mesh, const Ray& local, const float& limit, const Offer& offer) {
    const RayShear shear(local);
    const bool doubleSided = mesh.mesh->doubleSided;
    return traverse(mesh.index, local, limit, [&](std::uint32_t first, std::uint32_t count) {
        const TriangleBlock& block = mesh.triangles.block(first);
        std::uint32_t lanes = mayMeet(block, shear) & ((1U << count) - 1U);
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
            auto hit = intersectCorners(block.triangle(lane), doubleSided, shear, local.tMin, limit);
            if (!hit) continue;
            hit->primitive = mesh.index.entries()[first + lane];
            if (offer(*hit)) return true;
        }
        return false;
    });
}

template <class Offer>
bool visitHits(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask, const float& limit,
               const Offer& offer) {
    const auto inInstance = [&](std::uint32_t id) {
        const Instance<Bvh8>& instance = geometry.instances[id];
        if (!sees(mask, instance.mask)) return false;
        const auto offerHere = [&](Hit hit) {
            hit.instance = id;
            return offer(hit);
        };
        Ray local = instance.placement.toObject(ray);
        local.tMax = limit;
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
            const auto hit = intersect(*shape, local);
            return hit && offerHere(*hit);
        }
        return visitMesh(**std::get_if<1>(&instance.geometry), local, limit, offerHere);
    };
    for (const std::uint32_t id : geometry.always)
        if (inInstance(id)) return true;
    return traverse(geometry.top, ray, limit, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (inInstance(geometry.top.entries()[slot])) return true;
        return false;
    });
}

std::optional<Hit> closestHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    NearestHit nearest(ray);
    visitHits(geometry, ray, mask, nearest.limit(), [&](const Hit& hit) {
        nearest.offer(hit);
        return false;
    });
    return nearest.get();
}

bool anyHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return visitHits(geometry, ray, mask, ray.tMax, [](const Hit&) { return true; });
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(closestHit8);
HWY_EXPORT(anyHit8);

template <>
std::optional<Hit> closestHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return HWY_DYNAMIC_DISPATCH(closestHit8)(geometry, ray, mask);
}

template <>
bool anyHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return HWY_DYNAMIC_DISPATCH(anyHit8)(geometry, ray, mask);
}

}
#endif
