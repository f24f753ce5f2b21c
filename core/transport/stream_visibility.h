// How much of a lamp's light arrives at several points at once: as `visibility` of direct_light.h, by the
// same steps. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_VISIBILITY_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_VISIBILITY_H
#undef EYERAY_STREAM_VISIBILITY_H
#else
#define EYERAY_STREAM_VISIBILITY_H
#endif

#include "core/geometry/accel_lanes.h"
#include "core/transport/direct_light.h"
#include "core/transport/medium_table.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// What each ray runs in.
struct MediumLanes {
    MediumTable& table;
    IntLanes numbers;
};

/// Of a World, known before tracing.
struct GlassNeeds {
    bool any = false;        // something transmits
    bool attenuates = false; // some medium takes light on the way
    bool varies = false;     // some glass has a texture

    explicit GlassNeeds(const World& world) : any(world.needs.refractions) {
        for (const WorldMaterial& material : world.materials) {
            attenuates |= material.transmits && !isBlack(material.surface.attenuation);
            varies |= material.transmits && material.varies;
        }
        for (const WorldObject& object : world.objects)
            varies |= object.vertexColors && world.materials[object.material].transmits;
    }
};

inline Color attenuationIn(const World& world, const MediumStack& media) {
    if (media.top() == MediumStack::kVacuum) return Color(0);
    return world.materials[world.objects[media.top()].material].surface.attenuation;
}

/// As detail::filteredStraight, of glass without textures.
template <class Index>
Vec3Lanes filteredStraight(const World& world, const IndexedGeometry<Index>& geometry,
                           const GlassNeeds& needs, RayLanes rays, FloatMask asked,
                           const MediumLanes& mediaOfRays) {
    constexpr int kMostSurfaces = 256; // more are taken as opaque
    const FloatTag f;
    MediumTable& table = mediaOfRays.table;
    SpreadInt media = spread(mediaOfRays.numbers);
    Vec3Lanes transmitted = all(Color(1));
    for (int i = 0; i < kMostSurfaces; ++i) {
        const HitLanes hits = closestHits(geometry, rays, asked, RayMask::Transparent);
        const auto length = hn::IfThenElse(hits.met(), hits.t, rays.tMax);
        if (needs.attenuates) {
            const Spread lengths = spread(length);
            Spread3 left = spread(all(Color(1)));
            eachLane(asked, [&](std::size_t lane) {
                const Color sigma = attenuationIn(world, table.at(media.at(lane)));
                left.set(lane, transmittanceOf(sigma, lengths.lane[lane]));
            });
            transmitted = transmitted * gathered(left);
        }
        asked = hn::And(asked, hn::And(hits.met(), notBlack(transmitted)));
        if (hn::AllFalse(f, asked)) return transmitted;
        const SurfaceLanes at = surfacesAt(geometry, rays, hits, asked);
        const std::uint32_t front = bitsOf(dot(at.geometricNormal, -rays.direction) >= hn::Zero(f));
        eachInstance(hits.instance, asked, [&](std::uint32_t id, FloatMask lanes) HWY_ATTR {
            const WorldObject& object = world.objects[id];
            const Vec3Lanes left = transmitted * all(world.materials[object.material].surface.transmission);
            transmitted = select(lanes, left, transmitted);
            if (!needs.attenuates || !object.solid) return;
            eachLane(lanes, [&](std::size_t lane) {
                const MediumStack& before = table.at(media.at(lane));
                const bool entered = ((front >> lane) & 1U) != 0;
                media.set(lane, table.numberOf(entered ? before.entered(id, object.rank) : before.left(id)));
            });
        });
        rays.origin = select(asked, spawnOrigin(at, rays.direction), rays.origin);
        rays.tMax = rays.tMax - length;
    }
    return orZero(hn::Not(asked), transmitted);
}

/// The rays that meet something opaque, and the others that meet glass.
struct Blockers {
    FloatMask byOpaque, byGlass;
};

template <class Index>
HWY_INLINE Blockers blockersOf(const IndexedGeometry<Index>& geometry, const RayLanes& rays,
                               FloatMask asked) {
    const FloatTag f;
    if constexpr (std::is_same_v<Index, BruteForce>) { // tests each shape once
        const auto opaque = anyHits(geometry, rays, asked, RayMask::Opaque);
        const auto others = hn::AndNot(opaque, asked);
        if (hn::AllFalse(f, others)) return {opaque, others};
        return {opaque, anyHits(geometry, rays, others, RayMask::Transparent)};
    } else { // goes through the tree once for rays that meet nothing
        const auto some = anyHits(geometry, rays, asked, RayMask::Objects);
        if (hn::AllFalse(f, some)) return {some, some};
        const auto opaque = anyHits(geometry, rays, some, RayMask::Opaque);
        return {opaque, hn::AndNot(opaque, some)};
    }
}

/// Share of a lamp's light that arrives along the `asked` rays, by the named policy for glass.
template <class Index>
Vec3Lanes visibility(const TraceContext& context, const IndexedGeometry<Index>& geometry,
                     const GlassNeeds& needs, const RayLanes& rays, FloatMask asked,
                     const MediumLanes& media) {
    const GlassShadows policy = context.settings.glassShadows;
    if (!needs.any || policy != GlassShadows::Straight) {
        const bool opaqueOnly = needs.any && policy == GlassShadows::OpaqueOnly;
        const RayMask blocking = opaqueOnly ? RayMask::Opaque : RayMask::Objects;
        return orZero(hn::AndNot(anyHits(geometry, rays, asked, blocking), asked), all(Color(1)));
    }
    const Blockers blocked = blockersOf(geometry, rays, asked);
    const auto passes = hn::AndNot(hn::Or(blocked.byOpaque, blocked.byGlass), asked);
    const auto ones = [&] { return orZero(passes, all(Color(1))); };
    std::uint32_t filtered = bitsOf(blocked.byGlass);
    const SpreadInt numbers = spread(media.numbers);
    if (needs.attenuates)
        eachLane(passes, [&](std::size_t lane) {
            if (media.table.at(numbers.at(lane)).top() != MediumStack::kVacuum) filtered |= 1U << lane;
        });
    if (filtered == 0) return ones();
    if (!needs.varies) {
        const auto lanes = maskOf(filtered);
        const Vec3Lanes left = filteredStraight(*context.world, geometry, needs, rays, lanes, media);
        return select(lanes, left, ones());
    }
    Spread3 result = spread(ones());
    const RaySpread single(rays);
    RayCounts counts;
    NoRecorder recorder;
    SampleState<Index, NoRecorder> state{context, geometry, counts, recorder, {}, {}};
    eachLane(maskOf(filtered), [&](std::size_t lane) {
        constexpr Features kAll{.varying = true, .transparent = true};
        result.set(lane,
                   detail::filteredStraight<kAll>(state, single.at(lane), media.table.at(numbers.at(lane))));
    });
    return gathered(result);
}

}
HWY_AFTER_NAMESPACE();

#endif
