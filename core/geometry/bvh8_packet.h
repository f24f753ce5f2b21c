// Some rays that run close together, taken through Bvh8 as one: boxes are tested by
// intervals of the rays' origins and of the inverses of their directions. S. Boulos, I. Wald, P. Shirley
// 2006, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of Utah UUCS-06-010.
// What the intervals leave is tested ray by ray as ever, so the hits are those of single rays. Compiled once
// for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_BVH8_PACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BVH8_PACKET_H
#undef EYERAY_BVH8_PACKET_H
#else
#define EYERAY_BVH8_PACKET_H
#endif

#include "core/geometry/bvh8_hits.h"
#include "core/geometry/ray_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// The slabs of several rays (RaySlab), and the intervals that hold them.
class PacketSlab {
public:
    /// Of the rays whose bit is set in `asked`, one at least.
    PacketSlab(const RayLanes& rays, std::uint32_t asked, const Bounds& world) {
        const FloatMask there = maskOf(asked);
        const auto first = static_cast<std::size_t>(std::countr_zero(asked));
        const auto filled = [&](FloatLanes v)
                                HWY_ATTR { return hn::IfThenElse(there, v, all(hn::ExtractLane(v, first))); };
        const Vec3Lanes origin{filled(rays.origin.x), filled(rays.origin.y), filled(rays.origin.z)};
        const Vec3Lanes direction{filled(rays.direction.x), filled(rays.direction.y),
                                  filled(rays.direction.z)};
        coherent_ = closeTogether(origin, direction, world);
        if (!coherent_) return;
        tMin_ = lowest(filled(rays.tMin));
        const auto reach =
            maxComponent(Vec3Lanes{hn::Max(all(world.hi.x) - origin.x, origin.x - all(world.lo.x)),
                                   hn::Max(all(world.hi.y) - origin.y, origin.y - all(world.lo.y)),
                                   hn::Max(all(world.hi.z) - origin.z, origin.z - all(world.lo.z))});
        const auto growth = all(RaySlab::kGrowth) * reach;
        coherent_ = axes_[0].set(origin.x, direction.x, growth) &&
                    axes_[1].set(origin.y, direction.y, growth) &&
                    axes_[2].set(origin.z, direction.z, growth);
    }

    /// Whether the rays run close together and to the same side along each axis; else the tests below are of
    /// no use.
    bool coherent() const { return coherent_; }

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
                    hn::Sub(hn::Load(d, &node.corners[axis.near][i][lane]), hn::Set(d, axis.farthestOrigin));
                const auto toFar = hn::Sub(hn::Load(d, &node.corners[1 - axis.near][i][lane]),
                                           hn::Set(d, axis.hindmostOrigin));
                in = hn::Max(in, hn::Min(hn::Mul(toNear, low), hn::Mul(toNear, high)));
                const auto leaves = hn::Max(hn::Mul(toFar, low), hn::Mul(toFar, high));
                out = hn::Min(out, hn::Mul(leaves, hn::Set(d, RaySlab::kLater)));
            }
            hn::Store(in, d, &enters[lane]);
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, hn::Le(in, out), bits);
            met |= static_cast<std::uint32_t>(bits[0]) << lane;
        }
        return met;
    }

    /// Which of the rays may meet this child of a node before their own limits, a bit each.
    std::uint32_t enter(const Bvh8::Node& node, std::size_t child, FloatLanes limits) const {
        auto in = all(tMin_), out = limits;
        for (std::size_t i = 0; i < 3; ++i) {
            const Axis& axis = axes_[i];
            const auto inverse = gathered(axis.inverse);
            const auto near = all(node.corners[axis.near][i][child]);
            const auto far = all(node.corners[1 - axis.near][i][child]);
            in = hn::Max(in, (near - gathered(axis.originNear)) * inverse);
            out = hn::Min(out, (far - gathered(axis.originFar)) * inverse * all(RaySlab::kLater));
        }
        return bitsOf(in <= out);
    }

private:
    struct Axis {
        Spread originNear, originFar, inverse;
        std::size_t near = 0;                         // which corner the rays meet first
        float farthestOrigin = 0, hindmostOrigin = 0; // along the rays
        float inverseLow = 0, inverseHigh = 0;

        /// As the constructor of RaySlab; false if the rays do not all run to the same side.
        bool set(FloatLanes origin, FloatLanes direction, FloatLanes growth) {
            const auto largest = all(RaySlab::kLargest);
            const auto inverses = hn::Min(hn::Max(all(1.0F) / direction, hn::Neg(largest)), largest);
            const std::uint32_t backward = bitsOf(inverses < hn::Zero(FloatTag()));
            near = backward == 0 ? 0 : 1;
            const auto outward = near == 0 ? growth : hn::Neg(growth);
            const auto nears = origin + outward, fars = origin - outward;
            inverse = spread(inverses), originNear = spread(nears), originFar = spread(fars);
            inverseLow = lowest(inverses), inverseHigh = highest(inverses);
            farthestOrigin = near == 0 ? highest(nears) : lowest(nears);
            hindmostOrigin = near == 0 ? lowest(fars) : highest(fars);
            return backward == 0 || backward == (1U << kLanes) - 1;
        }
    };

    static float lowest(FloatLanes v) { return hn::GetLane(hn::MinOfLanes(FloatTag(), v)); }
    static float highest(FloatLanes v) { return hn::GetLane(hn::MaxOfLanes(FloatTag(), v)); }
    static float widest(const Vec3Lanes& v) {
        return std::max({highest(v.x) - lowest(v.x), highest(v.y) - lowest(v.y), highest(v.z) - lowest(v.z)});
    }

    static bool closeTogether(const Vec3Lanes& origin, const Vec3Lanes& direction, const Bounds& world) {
        // Wider packets meet so many boxes that single rays are faster: measured on reflections in knot and
        // flake.
        constexpr float kWidest = 0.03F;
        if (world.empty()) return true;
        return widest(direction) <= kWidest * highest(maxComponent(abs(direction))) &&
               widest(origin) <= kWidest * eyeray::maxComponent(world.hi - world.lo);
    }

    std::array<Axis, 3> axes_;
    float tMin_ = 0;
    bool coherent_ = true;
};

/// Calls leaf(first slot, slots, rays that may meet its box) for leaves that the rays may meet before
/// `limits`, roughly from near to far, until it returns true. `limits` and `farthest`, the largest of them,
/// may shrink meanwhile.
template <class Leaf>
void traverse(const Bvh8& tree, const PacketSlab& slab, const Spread& limits, const float& farthest,
              const Leaf& leaf) {
    if (tree.nodes().empty()) return;
    struct Pending {
        float enters;
        std::uint32_t node, slot; // the child in this slot of the node
    };
    constexpr std::size_t kMostPending = Bvh2::kMaxDepth * (Bvh8::kWidth - 1) + 1;
    std::array<Pending, kMostPending> stack; // the nearest on top
    std::size_t pending = 0;
    alignas(32) std::array<float, Bvh8::kWidth> enters;
    const auto open = [&](std::uint32_t id) HWY_ATTR {
        const std::size_t bottom = pending;
        std::uint32_t met = slab.enterChildren(tree.nodes()[id], farthest, enters);
        for (; met != 0; met &= met - 1) {
            const auto slot = static_cast<std::uint32_t>(std::countr_zero(met));
            std::size_t place = pending++;
            for (; place > bottom && stack[place - 1].enters < enters[slot]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {enters[slot], id, slot};
        }
    };
    open(0);
    while (pending > 0) {
        const Pending next = stack[--pending];
        if (next.enters > farthest) continue;
        const Bvh8::Node& node = tree.nodes()[next.node];
        const std::uint32_t child = node.child[next.slot];
        if (!Bvh8::isLeaf(child)) {
            open(child);
            continue;
        }
        const auto [first, count] = Bvh8::leafOf(child);
        const std::uint32_t rays = slab.enter(node, next.slot, gathered(limits));
        if (rays != 0 && leaf(first, count, rays)) return;
    }
}

/// One question of several rays to a scene: what they hit closest, or whether they hit anything.
template <bool kAny>
class Packet {
public:
    Packet(const IndexedGeometry<Bvh8>& geometry, const RayLanes& rays, FloatMask asked, RayMask mask)
        : geometry_(geometry), rays_(rays), mask_(mask), open_(bitsOf(asked)), limits_(spread(rays.tMax)) {
        const RaySpread single(rays);
        for (std::size_t lane = 0; lane < kLanes; ++lane) nearest_[lane].emplace(single.at(lane));
        limit();
    }

    /// False, with nothing found, if the rays do not run close together.
    bool trace() {
        const PacketSlab slab(rays_, open_, geometry_.top.bounds());
        if (!slab.coherent()) return false;
        for (const std::uint32_t id : geometry_.always) inInstance(id, open_);
        if (open_ == 0) return true;
        const auto leaf = [&](std::uint32_t first, std::uint32_t count, std::uint32_t rays) HWY_ATTR {
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                inInstance(geometry_.top.entries()[slot], rays & open_);
            return open_ == 0;
        };
        traverse(geometry_.top, slab, limits_, farthest_, leaf);
        return true;
    }

    std::optional<Hit> hit(std::size_t lane) const { return nearest_[lane]->get(); }
    /// The rays that have hit nothing, a bit each.
    std::uint32_t open() const { return open_; }

private:
    void inInstance(std::uint32_t id, std::uint32_t rays) {
        const Instance<Bvh8>& instance = geometry_.instances[id];
        if (rays == 0 || !sees(mask_, instance.mask)) return;
        RayLanes local = toObject(instance.placement, rays_);
        local.tMax = gathered(limits_);
        if (const Shape* shape = std::get_if<Shape>(&instance.geometry))
            inShape(*shape, id, local, rays);
        else
            inMesh(**std::get_if<1>(&instance.geometry), id, local, rays);
        limit();
    }

    void inShape(const Shape& shape, std::uint32_t id, const RayLanes& local, std::uint32_t rays) {
        const ShapeHitLanes hits =
            std::visit([&](const auto& s) HWY_ATTR { return intersect(s, local); }, shape);
        const Spread t = spread(hits.t), u = spread(hits.u);
        const SpreadInt face = spread(hits.face);
        for (std::uint32_t bits = rays & bitsOf(hits.t < all(kInfinity)); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            offer(lane, {t.lane[lane], u.lane[lane], 0, face.at(lane), id});
        }
    }

    void inMesh(const IndexedMesh<Bvh8>& mesh, std::uint32_t id, const RayLanes& local, std::uint32_t rays) {
        const RaySpread single(local);
        const PacketSlab slab(local, rays, mesh.index.bounds());
        const auto offerOf = [&](std::size_t lane) {
            return [this, lane, id](Hit hit) {
                hit.instance = id;
                offer(lane, hit);
                return kAny;
            };
        };
        if (!slab.coherent()) {
            for (std::uint32_t bits = rays; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
                visitMesh<kAny ? Order::Any : Order::Nearest>(mesh, single.at(lane), limits_.lane[lane],
                                                              offerOf(lane), Unwatched{});
            }
            return;
        }
        std::array<std::optional<RayShear>, kLanes> shears;
        const auto leaf = [&](std::uint32_t first, std::uint32_t count, std::uint32_t met) HWY_ATTR {
            for (std::uint32_t bits = met & rays & open_; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
                if (!shears[lane]) shears[lane].emplace(single.at(lane));
                visitTriangles(mesh, first, count, *shears[lane], single.tMin.lane[lane], limits_.lane[lane],
                               offerOf(lane));
            }
            limit();
            return (rays & open_) == 0;
        };
        traverse(mesh.index, slab, limits_, farthest_, leaf);
    }

    void offer(std::size_t lane, const Hit& hit) {
        if constexpr (kAny) {
            open_ &= ~(1U << lane);
            limits_.lane[lane] = -kInfinity;
        } else {
            nearest_[lane]->offer(hit);
            limits_.lane[lane] = nearest_[lane]->limit();
        }
    }

    void limit() {
        farthest_ = -kInfinity;
        for (std::uint32_t bits = open_; bits != 0; bits &= bits - 1)
            farthest_ = std::max(farthest_, limits_.lane[std::countr_zero(bits)]);
    }

    const IndexedGeometry<Bvh8>& geometry_;
    const RayLanes rays_;
    RayMask mask_;
    std::uint32_t open_; // rays that still ask, a bit each
    Spread limits_;      // hits from here on change nothing
    float farthest_ = 0;
    std::array<std::optional<NearestHit>, kLanes> nearest_;
};

}
HWY_AFTER_NAMESPACE();

#endif
