// Rays side by side in a few registers, and the intervals that hold them all: S. Boulos, I. Wald, P. Shirley
// 2006, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of Utah UUCS-06-010.
// Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_PACKET_RAYS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_RAYS_H
#undef EYERAY_PACKET_RAYS_H
#else
#define EYERAY_PACKET_RAYS_H
#endif

#include <span>

#include "core/geometry/bvh8_traversal.h"
#include "core/geometry/ray_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// How many registers of rays make a packet at most: as many as a node has boxes, so that one box is tested
/// against all of them as one ray against all boxes.
inline constexpr std::size_t kMostRows = Bvh8::kWidth;

/// A number for each row.
using OfRows = Bvh8::Node::Lanes;

/// Rays, a register of them in each row.
struct PacketRays {
    std::array<RayLanes, kMostRows> rows;
    std::array<std::uint32_t, kMostRows> asked{}; // rays that are meant, a bit each
    std::size_t count = 0;                        // of rows

    /// One ray at least.
    void add(const RayLanes& row, std::uint32_t rays) { rows[count] = row, asked[count++] = rays; }
};

/// Some of the rows of a packet.
struct Rows {
    std::size_t first, end;

    std::size_t count() const { return end - first; }
    /// A bit each.
    std::uint32_t bits() const { return (1U << end) - (1U << first); }
    std::array<Rows, 2> halves() const {
        const std::size_t middle = (first + end) / 2;
        return {{{first, middle}, {middle, end}}};
    }
};

/// One bit for each lane.
HWY_INLINE std::uint32_t bitsFrom(hn::Mask<Floats> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Floats(), mask, bits);
    return bits[0];
}

/// What numbers lie between.
struct Range {
    float low, high;
};

/// The same, lane by lane, of the numbers added.
struct RangeLanes {
    FloatLanes low, high;

    RangeLanes() : low(all(kInfinity)), high(all(-kInfinity)) {}
    HWY_INLINE void add(FloatLanes v, FloatMask asked) {
        low = hn::Min(low, hn::IfThenElse(asked, v, low)),
        high = hn::Max(high, hn::IfThenElse(asked, v, high));
    }
    HWY_INLINE Range ends() const {
        const FloatTag f;
        return {hn::GetLane(hn::MinOfLanes(f, low)), hn::GetLane(hn::MaxOfLanes(f, high))};
    }
};

/// What a number of the rays lies between: of each row, and of all.
struct RowRanges {
    alignas(32) OfRows low{}, high{};
    Range whole{kInfinity, -kInfinity};

    HWY_INLINE void set(std::size_t row, FloatLanes v, FloatMask asked) {
        RangeLanes range;
        range.add(v, asked);
        const Range ends = range.ends();
        low[row] = ends.low, high[row] = ends.high;
        whole.low = std::min(whole.low, ends.low), whole.high = std::max(whole.high, ends.high);
    }
};

}
HWY_AFTER_NAMESPACE();

#endif
