// Rays that run close together, taken through Bvh8 as one packet: boxes and triangles are ruled out by
// intervals that hold all rays, then for the rays of a register at once. Hits are those of single rays, bit
// for bit. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_BVH8_PACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_PACKET_H
#undef EYERAY_BVH8_PACKET_H
#else
#define EYERAY_BVH8_PACKET_H
#endif

#include "core/geometry/packet_mesh.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// What the rays of a packet hit closest.
class Packet {
public:
    Packet(const IndexedGeometry<Bvh8>& geometry, const PacketRays& rays, RayMask mask)
        : hits_(rays), geometry_(geometry), rays_(rays), mask_(mask) {
        ask({0, rays.count});
    }

    const HitLanes& hits(std::size_t row) const { return hits_.hits(row); }

private:
    void ask(Rows rows) {
        const RayRanges ranges(rays_.asked, rows,
                               [&](std::size_t row) HWY_ATTR -> const RayLanes& { return rays_.rows[row]; });
        if (geometry_.top.nodes().empty()) return askAlways(rows, ranges);
        const PacketSlab slab(ranges, geometry_.top.bounds());
        if (!slab.coherent()) {
            if (rows.count() == 1) return singly(rows.first);
            for (const Rows half : rows.halves()) ask(half);
            return;
        }
        askAlways(rows, ranges);
        const auto leaf = [&](const Bvh8::Node& node, std::size_t child) HWY_ATTR {
            const auto [first, count] = Bvh8::leafOf(node.child[child]);
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                inInstance(geometry_.top.entries()[slot], rows, ranges);
        };
        traverse(geometry_.top, slab, hits_.limits(), rows, leaf);
    }

    void askAlways(Rows rows, const RayRanges& ranges) {
        for (const std::uint32_t id : geometry_.always) inInstance(id, rows, ranges);
    }

    void singly(std::size_t row) {
        const RaySpread single(rays_.rows[row]);
        eachLane(maskOf(rays_.asked[row]), [&](std::size_t lane) {
            if (const auto hit = closestHit(geometry_, single.at(lane), mask_)) hits_.offer(row, lane, *hit);
        });
    }

    void inInstance(std::uint32_t id, Rows rows, const RayRanges& ranges) {
        const Instance<Bvh8>& instance = geometry_.instances[id];
        if (!sees(mask_, instance.mask)) return;
        const LocalRays local{rays_, instance.placement};
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry))
            return inShape(*shape, id, local, rows);
        const IndexedMesh<Bvh8>& mesh = **std::get_if<1>(&instance.geometry);
        inMesh(mesh, id, local, rows,
               instance.placement.translates() ? ranges.moved(instance.placement.worldToObject().translation)
                                               : rangesOf(local, rows));
    }

    static RayRanges rangesOf(const LocalRays& local, Rows rows) {
        return {local.world.asked, rows, [&](std::size_t row) HWY_ATTR { return local.row(row); }};
    }

    /// With the limit of each ray.
    RayLanes rowOf(const LocalRays& local, std::size_t row) const {
        RayLanes rays = local.row(row);
        rays.tMax = hits_.limit(row);
        return rays;
    }

    void inShape(const Shape& shape, std::uint32_t id, const LocalRays& local, Rows rows) {
        for (std::size_t row = rows.first; row < rows.end; ++row) {
            const RayLanes rays = rowOf(local, row);
            const ShapeHitLanes hits =
                std::visit([&](const auto& s) HWY_ATTR { return intersect(s, rays); }, shape);
            const auto t = hn::IfThenElse(maskOf(rays_.asked[row]), hits.t, all(kInfinity));
            if (hn::AllFalse(FloatTag(), t < all(kInfinity))) continue;
            const auto ids = hn::Set(IntTag(), static_cast<std::int32_t>(id));
            hits_.offer(row, {t, hits.u, all(0.0F), hits.face, ids});
        }
    }

    void inMesh(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const LocalRays& local, Rows rows,
                const RayRanges& ranges) {
        const PacketSlab slab(ranges, mesh.index.bounds());
        if (!slab.coherent()) {
            if (rows.count() == 1) return singly(mesh, id, rowOf(local, rows.first), rows.first);
            for (const Rows half : rows.halves()) inMesh(mesh, id, local, half, rangesOf(local, half));
            return;
        }
        std::array<Asked, 3> asked{};
        std::array<std::uint32_t, 3> some{};
        for (std::size_t row = rows.first; row < rows.end; ++row) {
            const auto byAxis = byLongestAxis(local.row(row).direction);
            for (std::size_t axis = 0; axis < 3; ++axis)
                some[axis] |= asked[axis][row] = rays_.asked[row] & byAxis[axis];
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (some[axis] == 0) continue;
            const RaysInMesh here{mesh, id, local, asked[axis], rows};
            slab.oneOrigin() ? PacketInMesh<true>(here, hits_).trace(slab)
                             : PacketInMesh<false>(here, hits_).trace(slab);
        }
    }

    void singly(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const RayLanes& local, std::size_t row) {
        const RaySpread single(local);
        for (std::uint32_t bits = rays_.asked[row]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            NearestHit nearest(single.at(lane));
            const auto take = [&](Hit hit) {
                hit.instance = id;
                nearest.offer(hit);
                return false;
            };
            visitMesh<Order::Nearest>(mesh, single.at(lane), nearest.limit(), take, Unwatched{});
            if (const auto hit = nearest.get()) hits_.offer(row, lane, *hit);
        }
    }

    PacketHits hits_;
    const IndexedGeometry<Bvh8>& geometry_;
    const PacketRays& rays_;
    RayMask mask_;
};

}
HWY_AFTER_NAMESPACE();

#endif
