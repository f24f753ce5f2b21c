// The way of a ray through all instances of a scene with Bvh8, compiled once for each instruction set: see
// bvh8_traversal.h.
#if defined(EYERAY_BVH8_HITS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_HITS_H
#undef EYERAY_BVH8_HITS_H
#else
#define EYERAY_BVH8_HITS_H
#endif

#include <hwy/cache_control.h>

#include "core/geometry/accel.h"
#include "core/geometry/bvh8_traversal.h"
#include "core/geometry/nearest_hit.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

// Calls offer(hit) for the hits of a leaf's triangles at t in (tMin, limit) until it returns true; whether it
// did.
template <class Offer>
HWY_INLINE bool visitTriangles(const IndexedMesh<Bvh8>& mesh, std::uint32_t first, std::uint32_t count,
                               const RayShear& shear, float tMin, const float& limit, const Offer& offer) {
    hwy::Prefetch(&mesh.index.entries()[first]); // wanted last
    const TriangleBlock& block = mesh.triangles.block(first);
    const bool doubleSided = mesh.mesh->doubleSided;
    std::uint32_t lanes = mayMeet(block, doubleSided, shear, limit).open & ((1U << count) - 1U);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        const TriangleCorners corners = block.turned(lane, shear.axes);
        auto hit = detail::finishTriangle(corners, {shear(corners[0]), shear(corners[1]), shear(corners[2])},
                                          doubleSided, shear, tMin, limit);
        if (!hit) continue;
        hit->primitive = mesh.index.entries()[first + lane];
        if (offer(*hit)) return true;
    }
    return false;
}

// Whether the ray hits any triangle of a leaf at t in (tMin, limit): mostly without areas in double.
HWY_INLINE bool hitsTriangle(const IndexedMesh<Bvh8>& mesh, std::uint32_t first, std::uint32_t count,
                             const RayShear& shear, float tMin, float limit) {
    const TriangleBlock& block = mesh.triangles.block(first);
    const bool doubleSided = mesh.mesh->doubleSided;
    const LeafBits bits = mayMeet(block, doubleSided, shear, limit);
    for (std::uint32_t lanes = bits.open & ((1U << count) - 1U); lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        const TriangleCorners corners = block.turned(lane, shear.axes);
        const float t = detail::meetPlane(corners, shear);
        if (!(t > tMin && t < limit)) continue;
        if ((bits.certain >> lane & 1U) != 0 ||
            detail::hitWithin({shear(corners[0]), shear(corners[1]), shear(corners[2])}, doubleSided, t))
            return true;
    }
    return false;
}

// Calls offer(hit) for hits at t in (tMin, limit) until it returns true; whether it did. Not inlined: then
// more of it stays in registers.
template <Order kOrder, class Offer, class Log>
HWY_NOINLINE bool visitMesh(const IndexedMesh<Bvh8>& mesh, const Ray& local, const float& limit,
                            const Offer& offer, Log log) {
    const auto prepare = [&, log]() __attribute__((always_inline)) {
        return [&, log, shear = RayShear(local)](std::uint32_t first, std::uint32_t count)
                   __attribute__((always_inline)) {
                       for (const std::uint32_t triangle : mesh.index.entries().subspan(first, count))
                           log.triangle(triangle);
                       if constexpr (kOrder == Order::Any)
                           return hitsTriangle(mesh, first, count, shear, local.tMin, limit) && offer(Hit{});
                       else
                           return visitTriangles(mesh, first, count, shear, local.tMin, limit, offer);
                   };
    };
    return traverse<kOrder>(mesh.index, local, RaySlab::kGrowthOfTriangles, limit, prepare, log);
}

template <Order kOrder, class Offer, class Log>
HWY_INLINE bool visitHits(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask,
                          const float& limit, const Offer& offer, Log log) {
    const auto inInstance = [&, log](std::uint32_t id) {
        const Instance<Bvh8>& instance = geometry.instances[id];
        if (!sees(mask, instance.mask)) return false;
        const auto offerHere = [&](Hit hit) {
            hit.instance = id;
            return offer(hit);
        };
        Ray local = instance.placement.toObject(ray);
        local.tMax = limit;
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
            log.shape(id);
            const auto hit = intersect(*shape, local);
            return hit && offerHere(*hit);
        }
        const auto inMesh = log.into(id);
        return visitMesh<kOrder>(**std::get_if<1>(&instance.geometry), local, limit, offerHere, inMesh);
    };
    for (const std::uint32_t id : geometry.always)
        if (inInstance(id)) return true;
    const auto leaf = [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (inInstance(geometry.top.entries()[slot])) return true;
        return false;
    };
    return traverse<kOrder>(geometry.top, ray, RaySlab::kGrowth, limit, [&] { return leaf; }, log);
}

template <class Log>
std::optional<Hit> closest(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask, Log log) {
    NearestHit nearest(ray);
    const auto offer = [&](const Hit& hit) {
        nearest.offer(hit);
        return false;
    };
    visitHits<Order::Nearest>(geometry, ray, mask, nearest.limit(), offer, log);
    return nearest.get();
}

template <class Log>
bool any(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask, Log log) {
    const auto stop = [](const Hit&) { return true; };
    return visitHits<Order::Any>(geometry, ray, mask, ray.tMax, stop, log);
}

}
HWY_AFTER_NAMESPACE();

#endif
