#pragma once
// How a binary tree is made a wide one. H. Ylitie, T. Karras, S. Laine 2017, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", High-Performance Graphics, section 3.1.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/bvh2.h"
#include "core/geometry/bvh8.h"

namespace eyeray {

/// Chooses which nodes of a binary tree become nodes of a wide one, with its leaves, such that their areas
/// sum up to the least: rays come to nodes in proportion to that. The same tree gives the same choice.
class Collapse {
public:
    /// Takes time and memory in proportion to the nodes, whose children come after their parents. They must
    /// outlive this.
    explicit Collapse(std::span<const Bvh2::Node> binary);

    /// Nodes of the binary tree: leaves, or such as become nodes of the wide one.
    struct Children {
        std::array<std::uint32_t, Bvh8::kWidth> node;
        std::size_t count = 0;
    };
    /// What stands below a node of the wide tree that is made of this one, from left to right as in the
    /// binary tree, hence roughly by rising coordinates; the leaf itself if it is one.
    Children childrenOf(std::uint32_t node) const;

private:
    using Costs = std::array<float, Bvh8::kWidth>; // of a tree as up to i + 1 children of the node above

    /// How many of a number of lanes go to the left child.
    struct Share {
        std::size_t toLeft;
        float cost;
    };

    static Costs sideBySide(const Costs& left, const Costs& right);
    Share cheapest(std::uint32_t node, std::size_t lanes) const;
    void gather(std::uint32_t node, std::size_t lanes, Children& children) const;
    void gatherBelow(std::uint32_t node, const Share&, std::size_t lanes, Children& children) const;

    std::span<const Bvh2::Node> binary_;
    std::vector<Costs> costs_;
};

}
