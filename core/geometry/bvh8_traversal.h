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

/// Which children of a node the ray may meet at t in [tMin, limit], a bit each, and where it enters them.
inline std::uint32_t enterChildren(const Bvh8::Node& node, const RaySlab& slab, float limit,
                                   std::array<float, Bvh8::kWidth>& enters) {
    const Floats d;
    std::uint32_t met = 0;
    for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
        auto in = hn::Set(d, slab.tMin()), out = hn::Set(d, limit);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t near = slab.near(axis);
            const auto inverse = hn::Set(d, slab.inverse(axis));
            const auto t0 = hn::Mul(
                hn::Sub(hn::Load(d, &node.corners[near][axis][lane]), hn::Set(d, slab.originNear(axis))),
                inverse);
            const auto t1 = hn::Mul(hn::Mul(hn::Sub(hn::Load(d, &node.corners[1 - near][axis][lane]),
                                                    hn::Set(d, slab.originFar(axis))),
                                            inverse),
                                    hn::Set(d, RaySlab::kLater));
            in = hn::Max(in, t0);
            out = hn::Min(out, t1);
        }
        hn::Store(in, d, &enters[lane]);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(in, out), bits);
        met |= static_cast<std::uint32_t>(bits[0]) << lane;
    }
    return met;
}

/// Which triangles of a block the ray may meet, a bit each: those that intersectCorners does not rule out by
/// the signs of their areas in float, by the same operations, and that are not behind the origin with all
/// corners.
inline std::uint32_t mayMeet(const TriangleBlock& block, const RayShear& shear) {
    const Floats d;
    std::uint32_t kept = 0;
    for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
        const auto relative = [&](std::size_t corner, std::size_t k) {
            return hn::Sub(hn::Load(d, &block.corners[corner][k][lane]), hn::Set(d, shear.origin[k]));
        };
        const auto az = relative(0, shear.kz), bz = relative(1, shear.kz), cz = relative(2, shear.kz);
        const auto sx = hn::Set(d, shear.sx), sy = hn::Set(d, shear.sy);
        const auto ax = hn::Sub(relative(0, shear.kx), hn::Mul(sx, az));
        const auto bx = hn::Sub(relative(1, shear.kx), hn::Mul(sx, bz));
        const auto cx = hn::Sub(relative(2, shear.kx), hn::Mul(sx, cz));
        const auto ay = hn::Sub(relative(0, shear.ky), hn::Mul(sy, az));
        const auto by = hn::Sub(relative(1, shear.ky), hn::Mul(sy, bz));
        const auto cy = hn::Sub(relative(2, shear.ky), hn::Mul(sy, cz));
        const auto u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        const auto v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        const auto w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const auto zero = hn::Zero(d);
        const auto beside =
            hn::And(hn::Lt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(hn::Max(u, hn::Max(v, w)), zero));
        const auto behind = shear.direction[shear.kz] > 0 ? hn::Lt(hn::Max(az, hn::Max(bz, cz)), zero)
                                                          : hn::Gt(hn::Min(az, hn::Min(bz, cz)), zero);
        const auto missed = hn::Or(beside, behind);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Not(missed), bits);
        kept |= static_cast<std::uint32_t>(bits[0]) << lane;
    }
    return kept;
}

/// Calls leaf(first slot, slots) for the leaves whose boxes the ray may meet at t in [tMin, limit], roughly
/// from near to far, until it returns true; whether it did. `limit` may shrink meanwhile.
template <class Leaf, class Log>
bool traverse(const Bvh8& tree, const Ray& ray, const float& limit, const Leaf& leaf, Log log) {
    if (tree.nodes().empty()) return false;
    struct Pending {
        float enters;
        std::uint32_t child;
    };
    constexpr std::size_t kMostPending = Bvh2::kMaxDepth * (Bvh8::kWidth - 1) + 1;
    std::array<Pending, kMostPending> stack; // the nearest on top
    std::size_t pending = 0;
    alignas(32) std::array<float, Bvh8::kWidth> enters;
    const RaySlab slab(ray, tree.bounds());
    std::uint32_t child = 0;
    while (true) {
        if (Bvh8::isLeaf(child)) {
            const auto [first, count] = Bvh8::leafOf(child);
            if (leaf(first, count)) return true;
        } else {
            const Bvh8::Node& node = tree.nodes()[child];
            const std::size_t bottom = pending;
            std::uint32_t met = enterChildren(node, slab, limit, enters);
            log.node();
            log.boxes(child, Bvh8::childrenOf(node), met);
            for (; met != 0; met &= met - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(met));
                std::size_t place = pending++;
                for (; place > bottom && stack[place - 1].enters < enters[lane]; --place)
                    stack[place] = stack[place - 1];
                stack[place] = {enters[lane], node.child[lane]};
            }
        }
        do {
            if (pending == 0) return false;
            --pending;
        } while (stack[pending].enters > limit);
        child = stack[pending].child;
    }
}

}
HWY_AFTER_NAMESPACE();

#endif
