// Closest and any hits of several rays at once, and the surfaces there: those of closestHit, anyHit and
// surfaceAt, bit for bit. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_ACCEL_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_ACCEL_LANES_H
#undef EYERAY_ACCEL_LANES_H
#else
#define EYERAY_ACCEL_LANES_H
#endif

#include "core/geometry/accel.h"
#include "core/geometry/bvh8_any_packet.h"
#include "core/geometry/bvh8_packet.h"
#include "core/geometry/mesh_lanes.h"
#include "core/geometry/ray_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

template <class Index>
HWY_INLINE ShapeHitLanes intersectShape(const Instance<Index>& instance, RayLanes rays, FloatLanes limit) {
    rays = toObject(instance.placement, rays);
    rays.tMax = limit;
    const Shape& shape = *std::get_if<Shape>(&instance.geometry);
    // Not std::visit, which is not inlined: that takes a third longer.
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return intersect(*sphere, rays);
    if (const auto* plane = std::get_if<Plane>(&shape)) return intersect(*plane, rays);
    if (const auto* box = std::get_if<Box>(&shape)) return intersect(*box, rays);
    return intersect(*std::get_if<Cylinder>(&shape), rays);
}

/// Instances in the order in which they are tested.
inline std::array<std::span<const std::uint32_t>, 2>
instancesOf(const IndexedGeometry<BruteForce>& geometry) {
    return {geometry.always, geometry.top.entries()};
}

/// Closest hits of the `asked` rays among the instances of the mask.
template <class Index>
HWY_INLINE HitLanes closestHits(const IndexedGeometry<Index>& geometry, const RayLanes& rays, FloatMask asked,
                                RayMask mask) {
    if constexpr (std::is_same_v<Index, BruteForce>) {
        if (geometry.shapesOnly) {
            NearestLanes nearest(rays.tMax);
            for (const auto ids : instancesOf(geometry))
                for (const std::uint32_t id : ids)
                    if (const auto& instance = geometry.instances[id]; sees(mask, instance.mask))
                        nearest.offer(intersectShape(instance, rays, nearest.limit), id);
            return nearest.hit;
        }
    }
    if constexpr (std::is_same_v<Index, Bvh8>) {
        PacketRays packet;
        packet.add(rays, bitsOf(asked));
        return Packet(geometry, packet, mask).hits(0);
    }
    HitSpread hits{HitLanes{}};
    const RaySpread single(rays);
    eachLane(asked, [&](std::size_t lane) {
        if (const auto hit = closestHit(geometry, single.at(lane), mask)) hits.set(lane, *hit);
    });
    return hits.gathered();
}

/// Which of the `asked` rays hit something of the mask.
template <class Index>
HWY_INLINE FloatMask anyHits(const IndexedGeometry<Index>& geometry, const RayLanes& rays, FloatMask asked,
                             RayMask mask) {
    if constexpr (std::is_same_v<Index, BruteForce>) {
        if (geometry.shapesOnly) {
            const FloatTag f;
            FloatMask hit = hn::MaskFromVec(hn::Zero(f));
            for (const auto ids : instancesOf(geometry))
                for (const std::uint32_t id : ids) {
                    const auto& instance = geometry.instances[id];
                    if (!sees(mask, instance.mask)) continue;
                    hit = hn::Or(hit, intersectShape(instance, rays, rays.tMax).t < all(kInfinity));
                    if (hn::AllFalse(f, hn::AndNot(hit, asked))) return asked;
                }
            return hn::And(hit, asked);
        }
    }
    if constexpr (std::is_same_v<Index, Bvh8>)
        return hn::AndNot(maskOf(AnyPacket(geometry, rays, asked, mask).open()), asked);
    const RaySpread single(rays);
    std::uint32_t hit = 0;
    eachLane(asked, [&](std::size_t lane) {
        if (anyHit(geometry, single.at(lane), mask)) hit |= 1U << lane;
    });
    return maskOf(hit);
}

/// Calls each(instance, lanes) for every instance that is hit in lanes of `asked`.
template <class Each>
HWY_INLINE void eachInstance(IntLanes instances, FloatMask asked, const Each& each) {
    const FloatTag f;
    const IntTag n;
    while (!hn::AllFalse(f, asked)) {
        const std::int32_t id = hn::GetLane(compressed(instances, asked));
        const auto there = hn::And(asked, hn::RebindMask(f, instances == hn::Set(n, id)));
        each(static_cast<std::uint32_t>(id), there);
        asked = hn::AndNot(there, asked);
    }
}

/// The surfaces at hits of one instance, in world space; of a mesh in the `asked` lanes alone.
template <class Index>
inline SurfaceLanes surfacesOf(const IndexedGeometry<Index>& geometry, const Instance<Index>& instance,
                               const RayLanes& rays, const HitLanes& hits, FloatMask asked) {
    const auto ofShape = [&](const auto& shape) HWY_ATTR {
        const ShapeHitLanes hit{hits.t, hits.u, hits.primitive};
        return toWorld(instance.placement, surfaceAt(shape, toObject(instance.placement, rays), hit));
    };
    const Shape* shape = std::get_if<Shape>(&instance.geometry);
    if (const auto* sphere = std::get_if<Sphere>(shape)) return ofShape(*sphere);
    if (const auto* plane = std::get_if<Plane>(shape)) return ofShape(*plane);
    if (const auto* box = std::get_if<Box>(shape)) return ofShape(*box);
    SurfaceLanes surfaces{};
    if (const auto* mesh = std::get_if<1>(&instance.geometry)) {
        const RayLanes local = toObject(instance.placement, rays);
        const MeshSurfaces found = surfacesOn(*(*mesh)->mesh, local.direction, hits, asked);
        surfaces = toWorld(instance.placement, found.points);
        surfaces.shadingNormal = normalToWorld(instance.placement, found.points.shadingNormal);
        surfaces.lift = times(instance.placement.objectToWorld().linear, found.points.lift);
        if (hn::AllFalse(FloatTag(), found.others)) return surfaces;
        asked = found.others;
    }
    const RaySpread single(rays);
    const HitSpread hit(hits);
    SurfaceSpread result(surfaces);
    eachLane(asked,
             [&](std::size_t lane) { result.set(lane, surfaceAt(geometry, single.at(lane), hit.at(lane))); });
    return result.gathered();
}

/// The surfaces at hits of the `asked` rays, one of them at least, in world space; most often those of a
/// single instance.
template <class Index>
HWY_INLINE SurfaceLanes surfacesAt(const IndexedGeometry<Index>& geometry, const RayLanes& rays,
                                   const HitLanes& hits, FloatMask asked) {
    const auto first = hn::GetLane(compressed(hits.instance, asked));
    const auto others = hn::And(asked, hn::RebindMask(FloatTag(), hits.instance != hn::Set(IntTag(), first)));
    SurfaceLanes result = surfacesOf(geometry, geometry.instances[static_cast<std::uint32_t>(first)], rays,
                                     hits, hn::AndNot(others, asked));
    eachInstance(hits.instance, others, [&](std::uint32_t id, FloatMask lanes) HWY_ATTR {
        const SurfaceLanes here = surfacesOf(geometry, geometry.instances[id], rays, hits, lanes);
        result.position = select(lanes, here.position, result.position);
        result.error = select(lanes, here.error, result.error);
        result.geometricNormal = select(lanes, here.geometricNormal, result.geometricNormal);
        result.shadingNormal = select(lanes, here.shadingNormal, result.shadingNormal);
        result.lift = select(lanes, here.lift, result.lift);
    });
    return result;
}

}
HWY_AFTER_NAMESPACE();

#endif
