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

/// Which rays of each row are meant, a bit each.
using Asked = std::array<std::uint32_t, kMostRows>;

/// Rays, a register of them in each row.
struct PacketRays {
    std::array<RayLanes, kMostRows> rows;
    Asked asked{};
    std::size_t count = 0; // of rows

    /// One ray at least.
    void add(const RayLanes& row, std::uint32_t rays) { rows[count] = row, asked[count++] = rays; }
};

/// The rays of a packet in the space of an instance, brought there row by row.
struct LocalRays {
    const PacketRays& world;
    const Placement& placement;

    HWY_INLINE RayLanes row(std::size_t i) const { return toObject(placement, world.rows[i]); }
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

/// The rays whose directions are longest along each axis, as longestAxis has it, a bit each.
HWY_INLINE std::array<std::uint32_t, 3> byLongestAxis(const Vec3Lanes& direction) {
    const Vec3Lanes size = abs(direction);
    const std::uint32_t x = bitsOf(size.x > size.y), xOrY = bitsOf(hn::Max(size.x, size.y) > size.z);
    return {xOrY & x, xOrY & ~x, ~xOrY};
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
        low = hn::IfThenElse(asked, hn::Min(low, v), low),
        high = hn::IfThenElse(asked, hn::Max(high, v), high);
    }
    HWY_INLINE Range ends() const {
        const FloatTag f;
        return {hn::GetLane(hn::MinOfLanes(f, low)), hn::GetLane(hn::MaxOfLanes(f, high))};
    }
};

/// What vectors lie between, by axis.
struct VectorRangeLanes {
    RangeLanes x, y, z;

    HWY_INLINE void add(const Vec3Lanes& v, FloatMask asked) {
        x.add(v.x, asked), y.add(v.y, asked), z.add(v.z, asked);
    }
    HWY_INLINE std::array<Range, 3> ends() const { return {x.ends(), y.ends(), z.ends()}; }
};

/// What the origins and directions of some rays lie between.
struct RayRanges {
    std::array<Range, 3> directions{};
    bool sameWay = false; // close together, and to the same side along each axis; else the rest is not known
    std::array<Range, 3> origins{};
    float tMin = 0;

    /// rowAt(row): rays of the packet, in whichever space.
    template <class RowAt>
    RayRanges(const Asked& asked, Rows rows, const RowAt& rowAt) {
        VectorRangeLanes along, from;
        for (std::size_t row = rows.first; row < rows.end; ++row)
            along.add(rowAt(row).direction, maskOf(asked[row]));
        directions = along.ends();
        sameWay = allSameWay();
        if (!sameWay) return;
        RangeLanes starts;
        for (std::size_t row = rows.first; row < rows.end; ++row) {
            const RayLanes& rays = rowAt(row);
            const FloatMask there = maskOf(asked[row]);
            from.add(rays.origin, there), starts.add(rays.tMin, there);
        }
        origins = from.ends();
        tMin = starts.ends().low;
    }

    /// Of the rays moved: rounding is monotonic, so these ends are theirs.
    RayRanges moved(const Vec3& by) const {
        RayRanges result = *this;
        for (std::size_t i = 0; i < 3; ++i) {
            result.origins[i].low += by[static_cast<int>(i)];
            result.origins[i].high += by[static_cast<int>(i)];
        }
        return result;
    }

    // Wider packets meet so many boxes that single rays are faster: measured on reflections in knot and
    // flake.
    static constexpr float kWidest = 0.03F;

private:
    bool allSameWay() const {
        float longest = 0;
        for (const auto& [low, high] : directions) longest = std::max({longest, high, -low});
        return std::ranges::all_of(directions, [&](const Range& axis) {
            return axis.high - axis.low <= kWidest * longest && !(axis.low < 0 && axis.high > 0);
        });
    }
};

/// What a number of the rays of each row lies between.
struct RowRanges {
    alignas(32) OfRows low{}, high{};

    HWY_INLINE void set(std::size_t row, FloatLanes v, FloatMask asked) {
        RangeLanes range;
        range.add(v, asked);
        const Range ends = range.ends();
        low[row] = ends.low, high[row] = ends.high;
    }
};

}
HWY_AFTER_NAMESPACE();

#endif
