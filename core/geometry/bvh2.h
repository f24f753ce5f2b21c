#pragma once
// Binary bounding volume hierarchy.

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"
#include "core/geometry/slab.h"
#include "core/geometry/traversal_log.h"

namespace eyeray {

/// A tree over boxes, split by the surface area heuristic in 16 bins (sah_split.h). Large ones are built by
/// all cores. The same boxes in the same order give the same tree, node by node, on any number of threads
/// and by every instruction set.
class Bvh2 {
public:
    static constexpr int kMaxDepth = 64;

    /// The two children of a node lie side by side; a leaf has its slots [first, first + count).
    struct Node {
        std::array<std::array<float, 3>, 2> corners; // lower, upper
        std::uint32_t first;                         // slot of a leaf, else left child
        std::uint32_t count;                         // of a leaf, else 0

        Bounds bounds() const {
            const auto& [lo, hi] = corners;
            return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
        }
    };
    static_assert(sizeof(Node) == 32);

    Bvh2() = default;
    /// Takes the boxes that are finite and not empty; leaves hold up to `leafSize`. `atOnce`: how many
    /// entries one test takes. Empty if `stop` was requested.
    Bvh2(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop, int atOnce = 1);

    /// Puts new boxes, finite and not empty, in place of those that it holds. The tree stays, and fits worse
    /// the farther boxes have moved from each other.
    void refit(std::span<const Bounds> boxes);
    /// By the surface area heuristic rays come to as many nodes as these have area: half of that, in m².
    double cost() const;

    /// Calls test(slot) for the entries whose boxes the ray may meet at t in [tMin, limit], roughly from near
    /// to far, until it returns true; whether it did. `limit` may shrink meanwhile. `log`: Watched if it is
    /// to be put down. `Slab`: the test of boxes.
    template <class Slab = RaySlab, class Test, class Log = Unwatched>
    bool visit(const Ray& ray, const float& limit, Test&& test, Log log = {}) const;

    /// Which box each slot stands for.
    std::span<const std::uint32_t> entries() const { return entries_; }
    /// How many boxes it holds.
    std::size_t size() const { return entries_.size(); }
    /// The root first; none if the tree is empty.
    std::span<const Node> nodes() const { return nodes_; }
    std::size_t nodeCount() const { return nodes_.size(); }
    std::size_t bytes() const {
        return nodes_.size() * sizeof(Node) + entries_.size() * sizeof(std::uint32_t);
    }

private:
    Bounds bounds_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> entries_;
};

template <class Slab, class Test, class Log>
bool Bvh2::visit(const Ray& ray, const float& limit, Test&& test, Log log) const {
    if (nodes_.empty()) return false;
    const Slab slab(ray, bounds_);
    const bool meets = slab.enter(nodes_[0].corners, limit) != kInfinity;
    log.boxes(BoxTests::kRoot, 1, meets ? 1U : 0U);
    if (!meets) return false;

    struct Pending {
        std::uint32_t node;
        float enters;
    };
    std::array<Pending, kMaxDepth> stack;
    std::size_t pending = 0;
    const Node* node = nodes_.data();
    while (true) {
        log.node();
        if (node->count == 0) {
            Pending near{node->first, slab.enter(nodes_[node->first].corners, limit)};
            Pending far{node->first + 1, slab.enter(nodes_[node->first + 1].corners, limit)};
            log.boxes(static_cast<std::uint32_t>(node - nodes_.data()), 2,
                      (near.enters != kInfinity ? 1U : 0U) | (far.enters != kInfinity ? 2U : 0U));
            if (far.enters < near.enters) std::swap(near, far);
            if (near.enters != kInfinity) {
                if (far.enters != kInfinity) stack[pending++] = far;
                node = &nodes_[near.node];
                continue;
            }
        } else {
            for (std::uint32_t slot = node->first; slot < node->first + node->count; ++slot)
                if (test(slot)) return true;
        }
        do {
            if (pending == 0) return false;
            --pending;
        } while (stack[pending].enters > limit);
        node = &nodes_[stack[pending].node];
    }
}

}
