#pragma once
// The two trees by one name: what is below a node, for those who look at them rather than trace.

#include <vector>

#include "core/geometry/bvh2.h"
#include "core/geometry/bvh8.h"

namespace eyeray {

/// A box of a tree, and what is in it: further parts, or the slots of a leaf.
struct TreePart {
    Bounds box;
    bool leaf = false;
    std::uint32_t node = 0;             // unless it is a leaf
    std::uint32_t first = 0, count = 0; // slots of a leaf
};

inline TreePart partOf(const Bvh2& tree, std::uint32_t node) {
    const Bvh2::Node& n = tree.nodes()[node];
    const auto& [lo, hi] = n.corners;
    return {.box = {Vec3(lo[0], lo[1], lo[2]), Vec3(hi[0], hi[1], hi[2])},
            .leaf = n.count > 0,
            .node = node,
            .first = n.first,
            .count = n.count};
}

/// The root of a tree that is not empty.
inline TreePart rootOf(const Bvh2& tree) { return partOf(tree, 0); }
inline TreePart rootOf(const Bvh8& tree) { return {.box = tree.bounds()}; }

/// The parts below a node, in the order of the bits of BoxTests::met.
inline std::vector<TreePart> partsBelow(const Bvh2& tree, std::uint32_t node) {
    const std::uint32_t left = tree.nodes()[node].first;
    return {partOf(tree, left), partOf(tree, left + 1)};
}

inline std::vector<TreePart> partsBelow(const Bvh8& tree, std::uint32_t node) {
    const Bvh8::Node& n = tree.nodes()[node];
    const auto& [lo, hi] = n.corners;
    std::vector<TreePart> parts;
    for (std::size_t lane = 0; lane < Bvh8::childrenOf(n); ++lane) {
        TreePart part;
        part.box = {Vec3(lo[0][lane], lo[1][lane], lo[2][lane]), Vec3(hi[0][lane], hi[1][lane], hi[2][lane])};
        part.leaf = Bvh8::isLeaf(n.child[lane]);
        if (part.leaf) {
            const auto [first, count] = Bvh8::leafOf(n.child[lane]);
            part.first = first;
            part.count = count;
        } else {
            part.node = n.child[lane];
        }
        parts.push_back(part);
    }
    return parts;
}

}
