// What the rays of a stream hit, and their order by it. Compiled once for each instruction set, as
// core/base/lanes.h.
#if defined(EYERAY_STREAM_HITS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_HITS_H
#undef EYERAY_STREAM_HITS_H
#else
#define EYERAY_STREAM_HITS_H
#endif

#include <numeric>

#include "core/geometry/accel_lanes.h"
#include "core/scene/world.h"
#include "core/transport/stream_batch.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// The instance of lanes that meet the background.
HWY_INLINE IntLanes missed() { return hn::Set(IntTag(), static_cast<std::int32_t>(TileHits::kMissed)); }

/// `place`: that of the first, if they lie side by side, or a BlockPlace.
template <class Place>
HWY_INLINE RayLanes raysAt(const RayStream& rays, Place place) {
    return {load(rays.origin, place), load(rays.direction, place), all(0.0F), all(kInfinity)};
}

template <class Place>
HWY_INLINE void storeHits(const HitLanes& hits, RayStream& rays, Place place) {
    store(hits.t, rays.t, place), store(hits.u, rays.u, place), store(hits.v, rays.v, place);
    store(hits.primitive, rays.primitive, place), store(hits.instance, rays.instance, place);
}

template <class Index>
HWY_INLINE void offerShape(const Instance<Index>& instance, std::uint32_t id, RayStream& rays,
                           std::size_t i) {
    const auto t = load(rays.t, i), none = all(kInfinity);
    const auto limit = hn::IfThenElse(t < none, nextAbove(t), none);
    const HitLanes before{t, load(rays.u, i), all(0.0F), loadInts(rays.primitive, i),
                          loadInts(rays.instance, i)};
    NearestLanes nearest(limit, before);
    const ShapeHitLanes found = intersectShape(instance, raysAt(rays, i), limit);
    if (hn::AllFalse(FloatTag(), found.t < none)) return;
    nearest.offer(found, id);
    storeHits(nearest.hit, rays, i);
}

/// One shape after the other through some rays, which stay in the nearest cache: the tests of one shape do
/// not wait for each other, and branch alike.
inline void closestShapes(const IndexedGeometry<BruteForce>& geometry, RayStream& rays) {
    constexpr std::size_t kBlock = 128;
    for (std::size_t begin = 0; begin < rays.size; begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, rays.size);
        for (std::size_t i = begin; i < end; i += kLanes) storeHits({.instance = missed()}, rays, i);
        for (const auto ids : instancesOf(geometry))
            for (const std::uint32_t id : ids)
                for (std::size_t i = begin; i < end; i += kLanes)
                    offerShape(geometry.instances[id], id, rays, i);
    }
}

/// In packets: of rays through pixels, those of a square, a block of it in each register; of others, those
/// that lie side by side.
inline void closestInPackets(const IndexedGeometry<Bvh8>& geometry, RayStream& rays) {
    constexpr std::size_t kAcross = kLanes > 8 ? 4 : 2; // blocks
    const bool inBlocks = rays.width > 0 && rays.size % rays.width == 0 && rays.width % kBlockWidth == 0 &&
                          rays.size / rays.width % kBlockLines == 0;
    const std::size_t width = inBlocks ? rays.width : kBlockWidth, line = kBlockLines * width;
    const std::size_t columns = width / kBlockWidth, lines = (rays.size + line - 1) / line;
    const std::size_t across = std::min(kAcross, columns), down = kMostRows / across;
    for (std::size_t top = 0; top < lines; top += down)
        for (std::size_t left = 0; left < columns; left += across) {
            PacketRays packet;
            std::array<BlockPlace, kMostRows> places;
            for (std::size_t y = top; y < std::min(top + down, lines); ++y)
                for (std::size_t x = left; x < std::min(left + across, columns); ++x) {
                    const BlockPlace place{y * line + x * kBlockWidth, width};
                    const std::size_t rest = inBlocks ? kLanes : rays.size - place.first;
                    places[packet.count] = place;
                    packet.add(raysAt(rays, place), bitsOf(hn::FirstN(FloatTag(), rest)));
                }
            const Packet found(geometry, packet, RayMask::All);
            for (std::size_t row = 0; row < packet.count; ++row) {
                HitLanes hits = found.hits(row);
                hits.instance = hn::IfThenElse(hn::RebindMask(IntTag(), hits.met()), hits.instance, missed());
                storeHits(hits, rays, places[row]);
            }
        }
}

/// Fills in the closest hits of a stream's rays.
template <class Index>
void closestHits(const IndexedGeometry<Index>& geometry, RayStream& rays) {
    if constexpr (std::is_same_v<Index, BruteForce>)
        if (geometry.shapesOnly) return closestShapes(geometry, rays);
    if constexpr (std::is_same_v<Index, Bvh8>) return closestInPackets(geometry, rays);
    for (std::size_t i = 0; i < rays.size; i += kLanes) {
        const auto there = hn::FirstN(FloatTag(), rays.size - i);
        HitLanes hits = closestHits(geometry, raysAt(rays, i), there, RayMask::All);
        hits.instance = hn::IfThenElse(hn::RebindMask(IntTag(), hits.met()), hits.instance, missed());
        storeHits(hits, rays, i);
    }
}

inline std::uint32_t materialOfRay(const World& world, const RayStream& rays, std::size_t i) {
    return world.objects[rays.instance[i]].material;
}

/// Calls each(end of their bucket, lanes, how many) for those of the rays from `i` on that hit something.
template <class Each>
HWY_INLINE void eachBucket(const World& world, RayStream& rays, std::size_t i, const Each& each) {
    const FloatTag f;
    const auto instances = loadInts(rays.instance, i);
    const auto hit = hn::And(hn::FirstN(f, rays.size - i), hn::RebindMask(f, instances != missed()));
    eachInstance(instances, hit, [&](std::uint32_t id, FloatMask lanes) HWY_ATTR {
        const std::size_t count = hn::CountTrue(f, lanes);
        each(rays.ends[world.objects[id].material % RayStream::kBuckets], lanes, count);
    });
}

/// Puts the rays that hit something in `order`.
inline void sortByMaterial(const World& world, RayStream& rays) {
    rays.ends.fill(0);
    for (std::size_t i = 0; i < rays.size; i += kLanes)
        eachBucket(world, rays, i, [](std::uint32_t& size, FloatMask, std::size_t count) HWY_ATTR {
            size += static_cast<std::uint32_t>(count);
        });
    std::exclusive_scan(rays.ends.begin(), rays.ends.end(), rays.ends.begin(), 0U);
    for (std::size_t i = 0; i < rays.size; i += kLanes) {
        const auto numbers = countedFrom(i);
        eachBucket(world, rays, i, [&](std::uint32_t& end, FloatMask lanes, std::size_t count) HWY_ATTR {
            storeFirst(count, compressed(numbers, lanes), rays.order, end);
            end += static_cast<std::uint32_t>(count);
        });
    }
}

/// The rays from this place of `order` on that are shaded together.
inline Batch batchAt(const World& world, const RayStream& rays, std::size_t place) {
    const auto material = [&](std::size_t i) { return materialOfRay(world, rays, rays.order[i]); };
    const std::size_t end = rays.ends[material(place) % RayStream::kBuckets];
    std::size_t count = std::min(kLanes, end - place);
    if (world.materials.size() > RayStream::kBuckets) {
        const std::size_t most = count;
        for (count = 1; count < most && material(place + count) == material(place);) ++count;
    }
    return Batch(rays.order, place, count);
}

}
HWY_AFTER_NAMESPACE();

#endif
