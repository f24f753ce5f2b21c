// Rays that run close together, taken through Bvh8 as one packet: boxes and triangles are ruled out by
// intervals that hold all rays, then for the rays of a register at once. Hits are those of single rays, bit
// for bit. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_BVH8_PACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_PACKET_H
#undef EYERAY_BVH8_PACKET_H
#else
#define EYERAY_BVH8_PACKET_H
#endif

#include "core/geometry/bvh8_hits.h"
#include "core/geometry/hit_lanes.h"
#include "core/geometry/packet_traversal.h"
#include "core/geometry/packet_triangles.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// What the rays of a packet hit closest.
class Packet {
public:
    Packet(const IndexedGeometry<Bvh8>& geometry, const PacketRays& rays, RayMask mask)
        : geometry_(geometry), rays_(rays), mask_(mask) {
        limits_.fill(-kInfinity);
        for (std::size_t row = 0; row < rays.count; ++row) {
            nearest_[row].limit = rays.rows[row].tMax;
            shrink(row);
        }
        ask({0, rays.count});
    }

    const HitLanes& hits(std::size_t row) const { return nearest_[row].hit; }

private:
    void ask(Rows rows) {
        if (geometry_.top.nodes().empty()) return askAlways(rows);
        const PacketSlab slab(rays_, rows, geometry_.top.bounds());
        if (!slab.coherent()) {
            if (rows.count() == 1) return singly(rows.first);
            for (const Rows half : rows.halves()) ask(half);
            return;
        }
        askAlways(rows);
        const auto leaf = [&](std::uint32_t first, std::uint32_t count) HWY_ATTR {
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                inInstance(geometry_.top.entries()[slot], rows);
        };
        traverse(geometry_.top, slab, limits_, rows, leaf);
    }

    void askAlways(Rows rows) {
        for (const std::uint32_t id : geometry_.always) inInstance(id, rows);
    }

    void singly(std::size_t row) {
        const RaySpread single(rays_.rows[row]);
        eachLane(maskOf(rays_.asked[row]), [&](std::size_t lane) {
            if (const auto hit = closestHit(geometry_, single.at(lane), mask_)) offer(row, lane, *hit);
        });
    }

    void inInstance(std::uint32_t id, Rows rows) {
        const Instance<Bvh8>& instance = geometry_.instances[id];
        if (!sees(mask_, instance.mask)) return;
        PacketRays local;
        for (std::size_t row = rows.first; row < rows.end; ++row) {
            local.asked[row] = rays_.asked[row];
            local.rows[row] = toObject(instance.placement, rays_.rows[row]);
            local.rows[row].tMax = nearest_[row].limit;
        }
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry))
            inShape(*shape, id, local, rows);
        else
            inMesh(**std::get_if<1>(&instance.geometry), id, local, rows);
    }

    void inShape(const Shape& shape, std::uint32_t id, const PacketRays& local, Rows rows) {
        for (std::size_t row = rows.first; row < rows.end; ++row) {
            const ShapeHitLanes hits =
                std::visit([&](const auto& s) HWY_ATTR { return intersect(s, local.rows[row]); }, shape);
            const auto t = hn::IfThenElse(maskOf(local.asked[row]), hits.t, all(kInfinity));
            if (hn::AllFalse(FloatTag(), t < all(kInfinity))) continue;
            const auto ids = hn::Set(IntTag(), static_cast<std::int32_t>(id));
            nearest_[row].offer({t, hits.u, all(0.0F), hits.face, ids});
            shrink(row);
        }
    }

    void inMesh(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const PacketRays& local, Rows rows) {
        const PacketSlab slab(local, rows, mesh.index.bounds());
        if (slab.coherent() && (slab.oneOrigin() ? throughTree<true>(mesh, id, local, rows, slab)
                                                 : throughTree<false>(mesh, id, local, rows, slab)))
            return;
        if (rows.count() == 1)
            return singly(mesh, id, local.rows[rows.first], rows.first, local.asked[rows.first]);
        for (const Rows half : rows.halves()) inMesh(mesh, id, local, half);
    }

    /// False, with nothing done, if the rays do not run along the same axis.
    template <bool kOneOrigin>
    bool throughTree(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const PacketRays& local, Rows rows,
                     const PacketSlab& slab) {
        const PacketShear<kOneOrigin> shear(local, rows);
        if (!shear.aligned()) return false;
        Unfinished unfinished[kMostRows];
        const auto leaf = [&](std::uint32_t first, std::uint32_t count) HWY_ATTR {
            const TriangleBlock& block = mesh.triangles.block(first);
            std::uint32_t triangles = shear.mayMeet(block, largest(limits_, rows)) & ((1U << count) - 1U);
            for (; triangles != 0; triangles &= triangles - 1) {
                const auto lane = static_cast<std::uint32_t>(std::countr_zero(triangles));
                const Candidate triangle{
                    mesh, id, first + lane, {block.turned(lane, shear.axes()), shear.origin()}};
                std::uint32_t here = rows.bits();
                if (rows.count() > 1) here = shear.rowsThatMayMeet(triangle.turned, limits_);
                for (; here != 0; here &= here - 1) {
                    const auto row = static_cast<std::size_t>(std::countr_zero(here));
                    meet(triangle, shear, row, local, unfinished[row]);
                }
            }
        };
        traverse(mesh.index, slab, limits_, rows, leaf);
        for (std::size_t row = rows.first; row < rows.end; ++row)
            finish(mesh, shear.row(row), shear.axes(), row, unfinished[row]);
        return true;
    }

    struct Candidate {
        const IndexedMesh<Bvh8>& mesh;
        std::uint32_t instance, slot;
        TurnedTriangle turned;
    };

    /// Hits whose u and v are still to be found.
    struct Unfinished {
        std::uint32_t rays = 0; // a bit each
        IntLanes slots;         // of their triangles

        Unfinished() : slots(hn::Zero(IntTag())) {}
    };

    template <bool kOneOrigin>
    void meet(const Candidate& triangle, const PacketShear<kOneOrigin>& shear, std::size_t row,
              const PacketRays& local, Unfinished& unfinished) {
        const FloatTag f;
        const TriangleLanes at = shear.test(row, triangle.turned, triangle.mesh.mesh->doubleSided);
        const auto open =
            hn::And(maskOf(local.asked[row]), hn::And(at.open, at.soonest < nearest_[row].limit));
        if (hn::AllFalse(f, open)) return;
        const auto certain = hn::And(open, at.certain);
        if (!hn::AllFalse(f, certain)) {
            const FloatLanes t = shear.meetPlane(row, triangle.turned, at);
            const auto met = hn::And(certain, hn::And(t > local.rows[row].tMin, t < nearest_[row].limit));
            take(triangle, row, hn::IfThenElse(met, t, all(kInfinity)), unfinished);
        }
        const auto unclear = hn::AndNot(at.certain, open);
        if (!hn::AllFalse(f, unclear)) meetSingly(triangle, row, unclear, local, unfinished);
    }

    void take(const Candidate& triangle, std::size_t row, FloatLanes t, Unfinished& unfinished) {
        const IntTag n;
        const HitLanes hits{
            t, all(0.0F), all(0.0F),
            hn::Set(n, static_cast<std::int32_t>(triangle.mesh.index.entries()[triangle.slot])),
            hn::Set(n, static_cast<std::int32_t>(triangle.instance))};
        const FloatMask better = nearest_[row].offer(hits);
        const auto slot = hn::Set(n, static_cast<std::int32_t>(triangle.slot));
        unfinished.slots = hn::IfThenElse(hn::RebindMask(n, better), slot, unfinished.slots);
        unfinished.rays |= bitsOf(better);
        shrink(row);
    }

    /// Rays through an edge or a corner, where areas may be zero.
    HWY_NOINLINE void meetSingly(const Candidate& triangle, std::size_t row, FloatMask unclear,
                                 const PacketRays& local, Unfinished& unfinished) {
        const RaySpread single(local.rows[row]);
        eachLane(unclear, [&](std::size_t lane) {
            const RayShear shear(single.at(lane));
            const float limit = spread(nearest_[row].limit).lane[lane];
            const TriangleCorners& corners = triangle.turned.corners;
            auto hit =
                detail::finishTriangle(corners, {shear(corners[0]), shear(corners[1]), shear(corners[2])},
                                       triangle.mesh.mesh->doubleSided, shear, single.tMin.lane[lane], limit);
            if (!hit) return;
            hit->primitive = triangle.mesh.index.entries()[triangle.slot], hit->instance = triangle.instance;
            unfinished.rays &= ~offer(row, lane, *hit);
        });
    }

    /// u and v of all hits of a row at once, as detail::finishTriangle.
    void finish(const IndexedMesh<Bvh8>& mesh, const ShearLanes& shear,
                const std::array<std::size_t, 3>& axes, std::size_t row, const Unfinished& unfinished) {
        if (unfinished.rays == 0) return;
        const SpreadInt slots = spread(unfinished.slots);
        alignas(64) float corners[3][3][kLanes];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::uint32_t slot = slots.at(lane);
            const TriangleCorners turned = mesh.triangles.block(slot).turned(slot % Bvh8::kWidth, axes);
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    corners[corner][axis][lane] = turned[corner][axis];
        }
        const auto sheared = [&](std::size_t corner) HWY_ATTR {
            const auto from = [&](std::size_t axis, FloatLanes origin)
                                  HWY_ATTR { return hn::Load(FloatTag(), corners[corner][axis]) - origin; };
            const auto z = from(2, shear.origin.z);
            return std::pair(widen(from(0, shear.origin.x) - shear.sx * z),
                             widen(from(1, shear.origin.y) - shear.sy * z));
        };
        const auto edge = [](const auto& p, const auto& q)
                              HWY_ATTR { return p.first * q.second - p.second * q.first; };
        const auto a = sheared(0), b = sheared(1), c = sheared(2);
        const auto u = edge(c, b), v = edge(a, c), w = edge(b, a);
        const auto share = all(1.0) / (u + v + w);
        const auto rays = maskOf(unfinished.rays);
        HitLanes& hit = nearest_[row].hit;
        hit.u = hn::IfThenElse(rays, narrow(v * share), hit.u);
        hit.v = hn::IfThenElse(rays, narrow(w * share), hit.v);
    }

    void singly(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const RayLanes& local, std::size_t row,
                std::uint32_t asked) {
        const RaySpread single(local);
        for (std::uint32_t bits = asked; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            NearestHit nearest(single.at(lane));
            const auto take = [&](Hit hit) {
                hit.instance = id;
                nearest.offer(hit);
                return false;
            };
            visitMesh<Order::Nearest>(mesh, single.at(lane), nearest.limit(), take, Unwatched{});
            if (const auto hit = nearest.get()) offer(row, lane, *hit);
        }
    }

    /// Returns the ray's bit if it is taken.
    std::uint32_t offer(std::size_t row, std::size_t lane, const Hit& hit) {
        const IntTag n;
        const auto here = maskOf(1U << lane);
        const FloatMask better =
            nearest_[row].offer({hn::IfThenElse(here, all(hit.t), all(kInfinity)), all(hit.u), all(hit.v),
                                 hn::Set(n, static_cast<std::int32_t>(hit.primitive)),
                                 hn::Set(n, static_cast<std::int32_t>(hit.instance))});
        shrink(row);
        return bitsOf(better);
    }

    void shrink(std::size_t row) {
        const auto limit = hn::IfThenElse(maskOf(rays_.asked[row]), nearest_[row].limit, all(-kInfinity));
        limits_[row] = hn::GetLane(hn::MaxOfLanes(FloatTag(), limit));
    }

    NearestLanes nearest_[kMostRows];
    alignas(32) OfRows limits_; // the largest of each row's rays: hits from there on change nothing
    const IndexedGeometry<Bvh8>& geometry_;
    const PacketRays& rays_;
    RayMask mask_;
};

}
HWY_AFTER_NAMESPACE();

#endif
