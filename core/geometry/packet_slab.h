// The slab test of boxes against packets of rays. Compiled once for each instruction set, as
// core/base/lanes.h.
#if defined(EYERAY_PACKET_SLAB_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_SLAB_H
#undef EYERAY_PACKET_SLAB_H
#else
#define EYERAY_PACKET_SLAB_H
#endif

#include "core/geometry/packet_rays.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// The slabs of several rays (RaySlab), by intervals of the rays' origins and of the inverses of their
/// directions.
class PacketSlab {
public:
    /// `world` is a box around all boxes that will be tested.
    PacketSlab(const RayRanges& rays, const Bounds& world) : tMin_(rays.tMin) {
        const auto& origins = rays.origins;
        if (!rays.sameWay || !closeTogether(origins, world)) return;
        coherent_ = true;
        oneOrigin_ = std::ranges::all_of(origins, [](const Range& axis) { return axis.low == axis.high; });
        float reach = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            reach = std::max({reach, world.hi[axis] - origins[i].low, origins[i].high - world.lo[axis]});
        }
        for (std::size_t i = 0; i < 3; ++i)
            axes_[i] = Axis(origins[i], rays.directions[i], RaySlab::kGrowth * reach);
    }

    /// Whether the rays run close together and to the same side along each axis; else the tests below are of
    /// no use.
    bool coherent() const { return coherent_; }

    /// Whether all rays begin at the same point, as those from the eye do.
    bool oneOrigin() const { return oneOrigin_; }

    /// Which children of a node any ray may meet before `limit`, a bit each, and where the first one enters
    /// them at the earliest.
    std::uint32_t enterChildren(const Bvh8::Node& node, float limit,
                                std::array<float, Bvh8::kWidth>& enters) const {
        const Floats d;
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
            auto in = hn::Set(d, tMin_), out = hn::Set(d, limit);
            for (std::size_t i = 0; i < 3; ++i) {
                const Axis& axis = axes_[i];
                const auto low = hn::Set(d, axis.inverseLow), high = hn::Set(d, axis.inverseHigh);
                const auto toNear =
                    hn::Sub(hn::Load(d, &node.corners[axis.near][i][lane]), hn::Set(d, axis.farthest));
                const auto toFar =
                    hn::Sub(hn::Load(d, &node.corners[1 - axis.near][i][lane]), hn::Set(d, axis.hindmost));
                in = hn::Max(in, hn::Min(hn::Mul(toNear, low), hn::Mul(toNear, high)));
                const auto leaves = hn::Max(hn::Mul(toFar, low), hn::Mul(toFar, high));
                out = hn::Min(out, hn::Mul(leaves, hn::Set(d, RaySlab::kLater)));
            }
            hn::Store(in, d, &enters[lane]);
            met |= bitsFrom(hn::Le(in, out)) << lane;
        }
        return met;
    }

private:
    struct Axis {
        std::size_t near = 0;             // which corner the rays meet first
        float farthest = 0, hindmost = 0; // origins along the rays
        float inverseLow = 0, inverseHigh = 0;

        Axis() = default;
        Axis(Range origin, Range direction, float growth) : near(direction.low < 0 ? 1 : 0) {
            growth += kRounded * std::max(origin.high, -origin.low);
            farthest = near == 0 ? origin.high + growth : origin.low - growth;
            hindmost = near == 0 ? origin.low - growth : origin.high + growth;
            inverseLow = inverse(direction.high), inverseHigh = inverse(direction.low);
        }

        /// As the constructor of RaySlab.
        float inverse(float direction) const {
            if (direction == 0) return near == 0 ? RaySlab::kLargest : -RaySlab::kLargest;
            return std::min(std::max(1.0F / direction, -RaySlab::kLargest), RaySlab::kLargest);
        }
    };

    // Of an origin that is far from its own zero, so that the growth is not lost.
    static constexpr float kRounded = 3 * 0x1p-24F;

    static bool closeTogether(const std::array<Range, 3>& origins, const Bounds& world) {
        const float size = world.empty() ? kInfinity : eyeray::maxComponent(world.hi - world.lo);
        return std::ranges::all_of(
            origins, [&](const Range& axis) { return axis.high - axis.low <= RayRanges::kWidest * size; });
    }

    std::array<Axis, 3> axes_;
    float tMin_ = 0;
    bool coherent_ = false, oneOrigin_ = false;
};

}
HWY_AFTER_NAMESPACE();

#endif
