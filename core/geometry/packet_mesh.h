// The way of a packet through the triangles of a mesh. Compiled once for each instruction set, as
// core/base/lanes.h.
#if defined(EYERAY_PACKET_MESH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_MESH_H
#undef EYERAY_PACKET_MESH_H
#else
#define EYERAY_PACKET_MESH_H
#endif

#include "core/geometry/bvh8_hits.h"
#include "core/geometry/packet_hits.h"
#include "core/geometry/packet_traversal.h"
#include "core/geometry/packet_triangles.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// Rays of a packet, in the space of a placed mesh, whose directions are longest along the same axis.
struct RaysInMesh {
    const IndexedMesh<Bvh8>& mesh;
    std::uint32_t instance;
    const LocalRays& local;
    const Asked& asked; // some rays
    Rows rows;
};

template <bool kOneOrigin>
class PacketInMesh {
public:
    PacketInMesh(const RaysInMesh& rays, PacketHits& hits)
        : here_(rays), hits_(hits), shear_(rays.local, rays.asked, rays.rows) {}

    /// `slab`: of these rays, coherent.
    void trace(const PacketSlab& slab) {
        const auto leaf = [&](const Bvh8::Node& node, std::size_t child) HWY_ATTR {
            meetLeaf(Bvh8::boxOf(node, child), Bvh8::leafOf(node.child[child]));
        };
        traverse(here_.mesh.index, slab, hits_.limits(), here_.rows, leaf);
        for (std::size_t row = here_.rows.first; row < here_.rows.end; ++row)
            if (unfinished_[row].rays != 0) finish(row);
    }

private:
    using Triangles = TurnedTriangles<kOneOrigin>;

    // A leaf of triangles smaller than the gaps between rays is met by few rays, and each triangle by hardly
    // any: then each ray is tested against all triangles at once instead. Measured on knot and terrain.
    static constexpr int kFewRows = 2, kFewRays = 8;

    HWY_INLINE void meetLeaf(const Bounds& box, Bvh8::Leaf leaf) {
        prefetch(leaf);
        const std::uint32_t rows = shear_.rowsThatMayMeet(box, hits_.limits());
        if (rows == 0) return;
        if (std::popcount(rows) <= kFewRows) {
            Asked rays;
            if (raysThatMayMeet(box, rows, rays) <= kFewRays) return meetByRay(leaf, rows, rays);
        }
        Triangles triangles(here_.mesh.triangles.block(leaf.first), shear_.axes(), shear_.origin());
        eachBit(rows, [&](std::size_t row) HWY_ATTR {
            const std::uint32_t met =
                shear_.mayMeet(row, triangles, hits_.limits()[row]) & ((1U << leaf.count) - 1U);
            eachBit(met, [&](std::size_t triangle) HWY_ATTR { meet(triangles, triangle, leaf.first, row); });
        });
    }

    /// What lies in no cache comes while the leaf's box is tested.
    HWY_INLINE void prefetch(Bvh8::Leaf leaf) const {
        constexpr std::size_t kCacheLine = 64;
        const TriangleBlock& block = here_.mesh.triangles.block(leaf.first);
        const auto* const bytes = reinterpret_cast<const std::byte*>(&block);
        for (std::size_t i = 0; i < sizeof(block); i += kCacheLine) hwy::Prefetch(bytes + i);
        hwy::Prefetch(&here_.mesh.index.entries()[leaf.first]);
    }

    /// How many, and a bit each.
    HWY_NOINLINE int raysThatMayMeet(const Bounds& box, std::uint32_t rows, Asked& rays) const {
        int count = 0;
        eachBit(rows, [&](std::size_t row) HWY_ATTR {
            rays[row] = bitsOf(shear_.raysThatMayMeet(box, row, maskOf(here_.asked[row]), hits_.limit(row)));
            count += std::popcount(rays[row]);
        });
        return count;
    }

    HWY_NOINLINE void meetByRay(Bvh8::Leaf leaf, std::uint32_t rows, const Asked& rays) {
        eachBit(rows, [&](std::size_t row) HWY_ATTR {
            if (rays[row] == 0) return;
            const ShearSpread single = shear_.single(row);
            const Spread tMin = spread(here_.local.world.rows[row].tMin), limits = spread(hits_.limit(row));
            eachBit(rays[row], [&](std::size_t lane) HWY_ATTR {
                NearestHit nearest(limits.lane[lane]);
                const auto take = [&](Hit hit) {
                    hit.instance = here_.instance;
                    nearest.offer(hit);
                    return false;
                };
                visitTriangles(here_.mesh, leaf.first, leaf.count, single.at(lane, shear_.axes()),
                               tMin.lane[lane], nearest.limit(), take);
                if (const auto hit = nearest.get()) unfinished_[row].rays &= ~hits_.offer(row, lane, *hit);
            });
        });
    }

    /// The rays of a row and one triangle of the leaf whose slots begin at `first`.
    void meet(Triangles& triangles, std::size_t triangle, std::uint32_t first, std::size_t row) {
        const FloatTag f;
        const TriangleLanes at = shear_.test(row, triangles, triangle, here_.mesh.mesh->doubleSided);
        const auto before = at.nearest < hits_.limit(row) * shear_.row(row).along * all(kBeyond);
        const auto open = hn::And(maskOf(here_.asked[row]), hn::And(at.open, before));
        if (hn::AllFalse(f, open)) return;
        const std::uint32_t slot = first + static_cast<std::uint32_t>(triangle);
        const auto certain = hn::And(open, at.certain);
        if (!hn::AllFalse(f, certain)) {
            const FloatLanes t = shear_.meetPlane(row, triangles, triangle, at);
            const auto met =
                hn::And(certain, hn::And(t > here_.local.world.rows[row].tMin, t < hits_.limit(row)));
            take(slot, row, hn::IfThenElse(met, t, all(kInfinity)));
        }
        const auto unclear = hn::AndNot(at.certain, open);
        if (!hn::AllFalse(f, unclear)) meetSingly(slot, triangles.corners(triangle), row, unclear);
    }

    void take(std::uint32_t slot, std::size_t row, FloatLanes t) {
        const IntTag n;
        const auto primitive = hn::Set(n, static_cast<std::int32_t>(here_.mesh.index.entries()[slot])),
                   instance = hn::Set(n, static_cast<std::int32_t>(here_.instance)),
                   slots = hn::Set(n, static_cast<std::int32_t>(slot));
        const FloatMask better = hits_.offer(row, {t, all(0.0F), all(0.0F), primitive, instance});
        Unfinished& unfinished = unfinished_[row];
        unfinished.slots = hn::IfThenElse(hn::RebindMask(n, better), slots, unfinished.slots);
        unfinished.rays |= bitsOf(better);
    }

    /// Rays through an edge or a corner, where areas may be zero.
    HWY_NOINLINE void meetSingly(std::uint32_t slot, const TriangleCorners& corners, std::size_t row,
                                 FloatMask unclear) {
        const ShearSpread single = shear_.single(row);
        const Spread tMin = spread(here_.local.world.rows[row].tMin), limits = spread(hits_.limit(row));
        eachLane(unclear, [&](std::size_t lane) HWY_ATTR {
            const RayShear shear = single.at(lane, shear_.axes());
            auto hit = detail::finishTriangle(
                corners, {shear(corners[0]), shear(corners[1]), shear(corners[2])},
                here_.mesh.mesh->doubleSided, shear, tMin.lane[lane], limits.lane[lane]);
            if (!hit) return;
            hit->primitive = here_.mesh.index.entries()[slot], hit->instance = here_.instance;
            unfinished_[row].rays &= ~hits_.offer(row, lane, *hit);
        });
    }

    /// Hits whose u and v are still to be found.
    struct Unfinished {
        std::uint32_t rays = 0; // a bit each
        IntLanes slots;         // of their triangles

        Unfinished() : slots(hn::Zero(IntTag())) {}
    };

    /// u and v of all hits of a row at once, as detail::finishTriangle.
    void finish(std::size_t row) {
        const ShearLanes& shear = shear_.row(row);
        const Vec3Lanes origin = shear_.originOf(row);
        FloatLanes corners[3][3];
        gatherCorners(unfinished_[row], corners);
        const auto sheared = [&](std::size_t corner) HWY_ATTR {
            const auto& [x, y, z] = corners[corner];
            const auto along = z - origin.z;
            return std::pair(widen(x - origin.x - shear.sx * along), widen(y - origin.y - shear.sy * along));
        };
        const auto edge = [](const auto& p, const auto& q)
                              HWY_ATTR { return p.first * q.second - p.second * q.first; };
        const auto a = sheared(0), b = sheared(1), c = sheared(2);
        const auto u = edge(c, b), v = edge(a, c), w = edge(b, a);
        const auto share = all(1.0) / (u + v + w);
        hits_.setUV(row, maskOf(unfinished_[row].rays), narrow(v * share), narrow(w * share));
    }

    /// Those of the triangles that were hit.
    void gatherCorners(const Unfinished& unfinished, FloatLanes (&corners)[3][3]) const {
        const SpreadInt slots = spread(unfinished.slots);
        const auto turnedAt = [&](std::size_t lane) {
            const std::uint32_t slot = slots.at(lane);
            return here_.mesh.triangles.block(slot).turned(slot % Bvh8::kWidth, shear_.axes());
        };
        const auto each = [](const auto& set) HWY_ATTR {
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis) set(corner, axis);
        };
        const auto first = static_cast<std::size_t>(std::countr_zero(unfinished.rays));
        const auto others =
            hn::RebindMask(FloatTag(), unfinished.slots != hn::Set(IntTag(), slots.lane[first]));
        if (hn::AllFalse(FloatTag(), hn::And(maskOf(unfinished.rays), others))) {
            const TriangleCorners turned = turnedAt(first);
            return each([&](std::size_t corner, std::size_t axis)
                            HWY_ATTR { corners[corner][axis] = all(turned[corner][axis]); });
        }
        Spread gathering[3][3];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const TriangleCorners turned = turnedAt(lane);
            each([&](std::size_t corner, std::size_t axis)
                     HWY_ATTR { gathering[corner][axis].lane[lane] = turned[corner][axis]; });
        }
        each([&](std::size_t corner, std::size_t axis)
                 HWY_ATTR { corners[corner][axis] = gathered(gathering[corner][axis]); });
    }

    const RaysInMesh& here_;
    PacketHits& hits_;
    PacketShear<kOneOrigin> shear_;
    Unfinished unfinished_[kMostRows];
};

}
HWY_AFTER_NAMESPACE();

#endif
