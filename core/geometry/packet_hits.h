// The nearest hits of a packet's rays so far. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_PACKET_HITS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_HITS_H
#undef EYERAY_PACKET_HITS_H
#else
#define EYERAY_PACKET_HITS_H
#endif

#include "core/geometry/hit_lanes.h"
#include "core/geometry/packet_rays.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

class PacketHits {
public:
    explicit PacketHits(const PacketRays& rays) : rays_(rays) {
        limits_.fill(-kInfinity);
        for (std::size_t row = 0; row < rays.count; ++row) {
            nearest_[row].limit = rays.rows[row].tMax;
            shrink(row);
        }
    }

    const HitLanes& hits(std::size_t row) const { return nearest_[row].hit; }
    /// Hits at this t and beyond change nothing: of each ray of a row, and of the rows the largest.
    FloatLanes limit(std::size_t row) const { return nearest_[row].limit; }
    const OfRows& limits() const { return limits_; }

    /// Hits of a row; returns where they are taken.
    HWY_INLINE FloatMask offer(std::size_t row, const HitLanes& hits) {
        const FloatMask better = nearest_[row].offer(hits);
        shrink(row);
        return better;
    }

    /// A hit of one ray; returns the ray's bit if it is taken.
    std::uint32_t offer(std::size_t row, std::size_t lane, const Hit& hit) {
        const IntTag n;
        const auto t = hn::IfThenElse(maskOf(1U << lane), all(hit.t), all(kInfinity));
        const auto primitive = hn::Set(n, static_cast<std::int32_t>(hit.primitive)),
                   instance = hn::Set(n, static_cast<std::int32_t>(hit.instance));
        return bitsOf(offer(row, {t, all(hit.u), all(hit.v), primitive, instance}));
    }

    /// Where some of a row's rays have hit a triangle.
    void setUV(std::size_t row, FloatMask rays, FloatLanes u, FloatLanes v) {
        HitLanes& hit = nearest_[row].hit;
        hit.u = hn::IfThenElse(rays, u, hit.u), hit.v = hn::IfThenElse(rays, v, hit.v);
    }

private:
    HWY_INLINE void shrink(std::size_t row) {
        const auto limit = hn::IfThenElse(maskOf(rays_.asked[row]), nearest_[row].limit, all(-kInfinity));
        limits_[row] = hn::GetLane(hn::MaxOfLanes(FloatTag(), limit));
    }

    NearestLanes nearest_[kMostRows];
    alignas(32) OfRows limits_;
    const PacketRays& rays_;
};

}
HWY_AFTER_NAMESPACE();

#endif
