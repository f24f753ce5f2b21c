// Whether the rays of a register hit anything, as shadow rays ask. Those that run close together go through
// the top level together, to test shapes against all of them at once; through meshes they go one by one,
// which is faster: near the surface that they leave each meets triangles of its own. Compiled once for each
// instruction set, as core/base/lanes.h.
#if defined(EYERAY_BVH8_ANY_PACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_ANY_PACKET_H
#undef EYERAY_BVH8_ANY_PACKET_H
#else
#define EYERAY_BVH8_ANY_PACKET_H
#endif

#include "core/geometry/bvh8_hits.h"
#include "core/geometry/packet_traversal.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

class AnyPacket {
public:
    AnyPacket(const IndexedGeometry<Bvh8>& geometry, const RayLanes& rays, FloatMask asked, RayMask mask)
        : geometry_(geometry), open_(bitsOf(asked)), mask_(mask) {
        if (open_ == 0) return;
        rays_.add(rays, open_);
        limits_.fill(-kInfinity);
        shrink();
        ask();
    }

    /// The rays that have hit nothing, a bit each.
    std::uint32_t open() const { return open_; }

private:
    static constexpr Rows kRow{0, 1};

    void ask() {
        if (geometry_.top.nodes().empty()) return askAlways();
        const RayRanges ranges(rays_.asked, kRow,
                               [&](std::size_t) HWY_ATTR -> const RayLanes& { return rays_.rows[0]; });
        const PacketSlab slab(ranges, geometry_.top.bounds());
        if (!slab.coherent()) return singly();
        askAlways();
        const auto leaf = [&](const Bvh8::Node& node, std::size_t child) HWY_ATTR {
            const auto [first, count] = Bvh8::leafOf(node.child[child]);
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                inInstance(geometry_.top.entries()[slot]);
        };
        traverse(geometry_.top, slab, limits_, kRow, leaf);
    }

    void askAlways() {
        for (const std::uint32_t id : geometry_.always) inInstance(id);
    }

    void singly() {
        const RaySpread single(rays_.rows[0]);
        for (std::uint32_t bits = open_; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            if (anyHit(geometry_, single.at(lane), mask_)) open_ &= ~(1U << lane);
        }
    }

    void inInstance(std::uint32_t id) {
        const Instance<Bvh8>& instance = geometry_.instances[id];
        if (open_ == 0 || !sees(mask_, instance.mask)) return;
        const RayLanes local = toObject(instance.placement, rays_.rows[0]);
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
            const auto hits = std::visit([&](const auto& s) HWY_ATTR { return intersect(s, local); }, *shape);
            open_ &= ~bitsOf(hits.t < all(kInfinity));
        } else {
            inMesh(**std::get_if<1>(&instance.geometry), local);
        }
        shrink();
    }

    void inMesh(const IndexedMesh<Bvh8>& mesh, const RayLanes& local) {
        const RaySpread single(local);
        const auto stop = [](const Hit&) { return true; };
        for (std::uint32_t bits = open_; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const Ray ray = single.at(lane);
            if (visitMesh<Order::Any>(mesh, ray, ray.tMax, stop, Unwatched{})) open_ &= ~(1U << lane);
        }
    }

    void shrink() {
        const auto limit = hn::IfThenElse(maskOf(open_), rays_.rows[0].tMax, all(-kInfinity));
        limits_[0] = hn::GetLane(hn::MaxOfLanes(FloatTag(), limit));
    }

    alignas(32) OfRows limits_;
    PacketRays rays_;
    const IndexedGeometry<Bvh8>& geometry_;
    std::uint32_t open_;
    RayMask mask_;
};

}
HWY_AFTER_NAMESPACE();

#endif
