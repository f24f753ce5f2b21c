// The traversal of Bvh8, compiled once for each instruction set: included by a file that Google Highway's
// foreach_target includes, hence the guard.
#if defined(EYERAY_BVH8_TRAVERSAL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_TRAVERSAL_H
#undef EYERAY_BVH8_TRAVERSAL_H
#else
#define EYERAY_BVH8_TRAVERSAL_H
#endif

#include <hwy/highway.h>

#include <bit>

#include "core/geometry/bvh2.h"
#include "core/geometry/bvh8.h"
#include "core/geometry/leaf_triangles.h"
#include "core/geometry/slab.h"
#include "core/geometry/traversal_log.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, Bvh8::kWidth>;

/// One bit for each lane.
HWY_INLINE std::uint32_t bitsFrom(hn::Mask<Floats> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Floats(), mask, bits);
    return bits[0];
}

/// A ray's slab test, for the boxes of a node at once.
class SlabLanes {
public:
    explicit SlabLanes(const RaySlab& slab) : tMin_(hn::Set(Floats(), slab.tMin())) {
        const Floats d;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near_[axis] = slab.near(axis);
            inverse_[axis] = hn::Set(d, slab.inverse(axis));
            toNear_[axis] = hn::Set(d, slab.toNear(axis));
            toFar_[axis] = hn::Set(d, slab.toFar(axis));
        }
    }

    /// Which children of a node the ray may meet at t in [tMin, limit], a bit each, and where it enters them.
    std::uint32_t enterChildren(const Bvh8::Node& node, float limit,
                                std::array<float, Bvh8::kWidth>& enters) const {
        const Floats d;
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
            auto in = tMin_, out = hn::Set(d, limit);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto& near = node.corners[near_[axis]][axis];
                const auto& far = node.corners[1 - near_[axis]][axis];
                in = hn::Max(hn::MulSub(hn::Load(d, &near[lane]), inverse_[axis], toNear_[axis]), in);
                out = hn::Min(hn::MulSub(hn::Load(d, &far[lane]), inverse_[axis], toFar_[axis]), out);
            }
            hn::Store(in, d, &enters[lane]);
            met |= bitsFrom(hn::Le(in, out)) << lane;
        }
        return met;
    }

private:
    using Lanes = hn::VFromD<Floats>;
    Lanes tMin_, inverse_[3], toNear_[3], toFar_[3];
    std::size_t near_[3];
};

/// More than the rounding of a corner's distance and of the limit's.
inline constexpr float kBeyond = 1 + 0x1p-20F;

/// Triangles of a block, a bit each.
struct LeafBits {
    std::uint32_t open = 0;    // the ray may meet it
    std::uint32_t certain = 0; // its areas have the sign that is asked for
};

/// Which triangles the ray may meet before `limit`: those that intersectCorners does not rule out by the
/// signs of their areas in float, by the same operations, and that are not behind the origin or beyond the
/// limit with all corners.
inline LeafBits mayMeet(const TriangleBlock& block, bool doubleSided, const RayShear& shear, float limit) {
    const Floats d;
    LeafBits result;
    const float along = shear.direction[2];
    const float farthest = limit * std::fabs(along) * kBeyond;
    for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
        const auto relative = [&](std::size_t corner, std::size_t turned) {
            const auto& axis = block.corners[corner][shear.axes[turned]];
            return hn::Sub(hn::Load(d, &axis[lane]), hn::Set(d, shear.origin[turned]));
        };
        const auto az = relative(0, 2), bz = relative(1, 2), cz = relative(2, 2);
        const auto sx = hn::Set(d, shear.sx), sy = hn::Set(d, shear.sy);
        const auto ax = hn::Sub(relative(0, 0), hn::Mul(sx, az));
        const auto bx = hn::Sub(relative(1, 0), hn::Mul(sx, bz));
        const auto cx = hn::Sub(relative(2, 0), hn::Mul(sx, cz));
        const auto ay = hn::Sub(relative(0, 1), hn::Mul(sy, az));
        const auto by = hn::Sub(relative(1, 1), hn::Mul(sy, bz));
        const auto cy = hn::Sub(relative(2, 1), hn::Mul(sy, cz));
        const auto u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        const auto v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        const auto w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const auto zero = hn::Zero(d);
        const auto least = hn::Min(u, hn::Min(v, w)), most = hn::Max(u, hn::Max(v, w));
        auto beside = hn::Lt(least, zero), certain = hn::Gt(least, zero);
        if (doubleSided) {
            beside = hn::And(beside, hn::Gt(most, zero));
            certain = hn::Or(certain, hn::Lt(most, zero));
        }
        const auto sign = hn::Set(d, std::copysign(1.0F, along));
        const auto first = hn::Min(az, hn::Min(bz, cz)), last = hn::Max(az, hn::Max(bz, cz));
        // How far ahead: not by a branch on the sign, for it would be taken at random.
        const auto one = hn::Mul(first, sign), other = hn::Mul(last, sign);
        const auto outside =
            hn::Or(hn::Lt(hn::Max(one, other), zero), hn::Gt(hn::Min(one, other), hn::Set(d, farthest)));
        result.open |= bitsFrom(hn::Not(hn::Or(beside, outside))) << lane;
        result.certain |= bitsFrom(certain) << lane;
    }
    return result;
}

/// A child that is still to be gone into: where the ray enters it, and which it is, in one integer that
/// compares like the entry does. An entry is not negative, and such floats are ordered like their bits.
class PendingChild {
public:
    PendingChild() = default;
    PendingChild(float enters, std::uint32_t child)
        : bits_((static_cast<std::int64_t>(std::bit_cast<std::int32_t>(enters)) << 32) | child) {}

    float enters() const { return std::bit_cast<float>(static_cast<std::int32_t>(bits_ >> 32)); }
    std::uint32_t child() const { return static_cast<std::uint32_t>(bits_); }
    friend bool operator<(PendingChild a, PendingChild b) { return a.bits_ < b.bits_; }

private:
    std::int64_t bits_;
};

/// Whether the leaf nearest to the origin matters, or any. Children stand roughly by rising coordinates: so a
/// ray to which any hit is as good goes through them from one end, the farther ones first, for near its
/// origin lies the surface that it leaves.
enum class Order : std::uint8_t { Nearest, Any };

/// Calls leaf(first slot, slots) for the leaves whose boxes, grown as by RaySlab, the ray may meet at t in
/// [tMin, limit], until it returns true; whether it did. If the order is Nearest, roughly from near to far,
/// and `limit` may shrink meanwhile. prepare() returns the leaf function; it is called only once the ray
/// meets some child of the root.
template <Order kOrder, class Prepare, class Log>
HWY_INLINE bool traverse(const Bvh8& tree, const Ray& ray, float growth, const float& limit,
                         const Prepare& prepare, Log log) {
    if (tree.size() == 0) return false;
    constexpr bool kNearest = kOrder == Order::Nearest; // else it matters not where children are entered
    constexpr std::size_t kMostPending = Bvh2::kMaxDepth * (Bvh8::kWidth - 1) + 1;
    std::array<PendingChild, kMostPending> stack; // the nearest on top
    std::size_t pending = 0;
    alignas(32) std::array<float, Bvh8::kWidth> enters;
    const SlabLanes slab(RaySlab(ray, tree.bounds(), growth));
    const Bvh8::Node* const nodes = tree.nodes().data();
    const Bvh8::Node* node = nodes;
    std::uint32_t met = 0; // children of the node, a bit each
    const auto open = [&](std::uint32_t id) __attribute__((always_inline)) {
        node = nodes + id;
        met = slab.enterChildren(*node, limit, enters);
        log.node();
        log.boxes(id, Bvh8::childrenOf(*node), met);
    };
    open(0);
    if (met == 0) return false;
    const auto leaf = prepare();
    const bool upward = ray.direction.x + ray.direction.y + ray.direction.z > 0;
    while (true) {
        std::uint32_t child;
        if (met != 0) {
            const auto lowest = [&](std::uint32_t lanes) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                return PendingChild(kNearest ? enters[lane] : 0, node->child[lane]);
            };
            const auto first = static_cast<std::size_t>(std::countr_zero(met));
            child = node->child[first];
            met &= met - 1;
            if (met != 0) { // mostly not, and then where it is entered has not to be waited for
                PendingChild next(kNearest ? enters[first] : 0, child);
                if constexpr (!kNearest) {
                    if (upward) {
                        for (; met != 0; met &= met - 1) {
                            stack[pending++] = next;
                            next = lowest(met);
                        }
                    } else {
                        pending += static_cast<std::size_t>(std::popcount(met));
                        for (std::size_t place = pending; met != 0; met &= met - 1)
                            stack[--place] = lowest(met);
                    }
                } else {
                    for (const std::size_t bottom = pending; met != 0; met &= met - 1) {
                        const PendingChild other = lowest(met), farther = std::max(next, other);
                        next = std::min(next, other);
                        std::size_t place = pending++;
                        for (; place > bottom && stack[place - 1] < farther; --place)
                            stack[place] = stack[place - 1];
                        stack[place] = farther;
                    }
                }
                child = next.child();
            }
        } else {
            do {
                if (pending == 0) return false;
                --pending;
            } while (kNearest && stack[pending].enters() > limit);
            child = stack[pending].child();
        }
        if (!Bvh8::isLeaf(child)) {
            open(child);
            continue;
        }
        const auto [first, count] = Bvh8::leafOf(child);
        if (leaf(first, count)) return true;
    }
}

}
HWY_AFTER_NAMESPACE();

#endif
