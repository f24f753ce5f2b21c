#pragma once
// Wide bounding volume hierarchy: eight boxes a node, laid out for one SIMD test of all. I. Wald, C. Benthin,
// S. Boulos 2008, "Getting Rid of Packets: Efficient SIMD Single-Ray Traversal using Multi-branching BVHs",
// IEEE Symposium on Interactive Ray Tracing. It is traversed in bvh8_traversal.h.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/geometry/bounds.h"

namespace eyeray {

/// The same boxes give the same tree: that of Bvh2, with the leaves that eight at once make cheapest, and
/// its nodes joined to wide ones by collapse.h.
class Bvh8 {
public:
    static constexpr std::size_t kWidth = 8;

    /// A child that is not there has lower corner ∞ and upper corner −∞.
    struct alignas(32) Node {
        using Lanes = std::array<float, kWidth>;
        std::array<std::array<Lanes, 3>, 2> corners; // lower, upper; by axis; by child
        std::array<std::uint32_t, kWidth> child;     // index of a node, or a leaf by leafOf
    };
    static_assert(sizeof(Node) == 224);

    Bvh8() = default;
    /// Takes the boxes that are finite and not empty; leaves hold up to `leafSize` of them, at most kWidth.
    /// Empty if `stop` was requested.
    Bvh8(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop);

    /// As those of Bvh2.
    void refit(std::span<const Bounds> boxes);
    double cost() const;

    /// Which box each slot stands for. A leaf has its slots from a multiple of the leaf size on; those that
    /// it leaves over are kNone.
    std::span<const std::uint32_t> entries() const { return entries_; }
    static constexpr std::uint32_t kNone = 0xffffffff;
    /// How many boxes it holds.
    std::size_t size() const { return size_; }
    /// The root first; none if the tree is empty.
    std::span<const Node> nodes() const { return nodes_; }
    std::size_t nodeCount() const { return nodes_.size(); }
    const Bounds& bounds() const { return bounds_; }
    /// The boxes that a node really has.
    static unsigned childrenOf(const Node& node) {
        return static_cast<unsigned>(
            std::ranges::count_if(node.corners[0][0], [](float x) { return x < kInfinity; }));
    }
    static Bounds boxOf(const Node& node, std::size_t child) {
        const auto& [lo, hi] = node.corners;
        return {{lo[0][child], lo[1][child], lo[2][child]}, {hi[0][child], hi[1][child], hi[2][child]}};
    }
    std::size_t bytes() const {
        return nodes_.size() * sizeof(Node) + entries_.size() * sizeof(std::uint32_t);
    }

    struct Leaf {
        std::uint32_t first, count; // slots
    };
    static bool isLeaf(std::uint32_t child) { return (child & kLeafBit) != 0; }
    static Leaf leafOf(std::uint32_t child) {
        return {(child & ~kLeafBit) / kMostSlots, child % kMostSlots + 1};
    }

private:
    static constexpr std::uint32_t kLeafBit = 0x80000000, kMostSlots = kWidth;
    class Writer;

    Bounds bounds_;
    std::size_t size_ = 0;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> entries_;
};

}
