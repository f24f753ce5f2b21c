// The way of a packet of rays through Bvh8. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_PACKET_TRAVERSAL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_TRAVERSAL_H
#undef EYERAY_PACKET_TRAVERSAL_H
#else
#define EYERAY_PACKET_TRAVERSAL_H
#endif

#include "core/geometry/packet_slab.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// Of some rows.
HWY_INLINE float largest(const OfRows& values, Rows rows) {
    const Floats d;
    auto most = hn::Set(d, -kInfinity);
    for (std::size_t first = 0; first < kMostRows; first += hn::Lanes(d)) {
        const auto row = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<float>(first)));
        const auto asked = hn::And(hn::Ge(row, hn::Set(d, static_cast<float>(rows.first))),
                                   hn::Lt(row, hn::Set(d, static_cast<float>(rows.end))));
        most = hn::IfThenElse(asked, hn::Max(most, hn::Load(d, &values[first])), most);
    }
    return hn::GetLane(hn::MaxOfLanes(d, most));
}

/// Calls leaf(node, which of its children) for leaves that rays may meet before the largest of their rows'
/// limits, roughly from near to far. The limits may shrink meanwhile.
template <class Leaf>
void traverse(const Bvh8& tree, const PacketSlab& slab, const OfRows& limits, Rows rows, const Leaf& leaf) {
    struct Pending {
        float enters;
        std::uint32_t node, slot; // the child in this slot of the node
    };
    constexpr std::size_t kMostPending = Bvh2::kMaxDepth * (Bvh8::kWidth - 1) + 1;
    std::array<Pending, kMostPending> stack; // the nearest on top
    std::size_t pending = 0;
    alignas(32) std::array<float, Bvh8::kWidth> enters;
    float limit = largest(limits, rows);
    const auto open = [&](std::uint32_t id) HWY_ATTR {
        const std::size_t bottom = pending;
        std::uint32_t met = slab.enterChildren(tree.nodes()[id], limit, enters);
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
        if (next.enters > limit) continue;
        const Bvh8::Node& node = tree.nodes()[next.node];
        const std::uint32_t child = node.child[next.slot];
        if (!Bvh8::isLeaf(child)) {
            open(child);
            continue;
        }
        leaf(node, next.slot);
        limit = largest(limits, rows);
    }
}

}
HWY_AFTER_NAMESPACE();

#endif
