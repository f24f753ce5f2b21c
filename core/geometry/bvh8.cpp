#include "core/geometry/bvh8.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/geometry/bvh2.h"

namespace eyeray {
namespace {

Bounds boundsOf(const Bvh2::Node& node) {
    const auto& [lo, hi] = node.corners;
    return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}

}

/// Makes the wide nodes of a binary tree, depth first.
class Bvh8::Collapse {
public:
    Collapse(const Bvh2& binary, int leafSize, Bvh8& wide)
        : binary_(binary), leafSize_(static_cast<std::size_t>(leafSize)), wide_(wide) {}

    void run() {
        addNode(0);
        while (!pending_.empty()) {
            const Pending next = pending_.back();
            pending_.pop_back();
            wide_.nodes_[next.parent].child[next.lane] = static_cast<std::uint32_t>(wide_.nodes_.size());
            addNode(next.root);
        }
    }

private:
    struct Pending {
        std::uint32_t root; // of a part of the binary tree that becomes a node
        std::size_t parent, lane;
    };

    const Bvh2::Node& node(std::uint32_t index) const { return binary_.nodes()[index]; }

    // Up to kWidth parts of the tree under `root`.
    std::vector<std::uint32_t> opened(std::uint32_t root) const {
        std::vector<std::uint32_t> parts{root};
        while (parts.size() < kWidth) {
            const auto area = [&](std::uint32_t part) {
                return node(part).count > 0 ? -1.0F : boundsOf(node(part)).halfArea();
            };
            const auto largest =
                std::ranges::max_element(parts, [&](auto a, auto b) { return area(a) < area(b); });
            if (area(*largest) < 0) break;
            const std::uint32_t left = node(*largest).first;
            *largest = left;
            parts.push_back(left + 1);
        }
        return parts;
    }

    void addNode(std::uint32_t root) {
        constexpr std::size_t kLower = 0, kUpper = 1;
        const std::size_t index = wide_.nodes_.size();
        Node& result = wide_.nodes_.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            result.corners[kLower][axis].fill(kInfinity);
            result.corners[kUpper][axis].fill(-kInfinity);
        }
        const std::vector<std::uint32_t> parts = opened(root);
        for (std::size_t lane = 0; lane < parts.size(); ++lane) {
            const Bvh2::Node& part = node(parts[lane]);
            for (const std::size_t side : {kLower, kUpper})
                for (std::size_t axis = 0; axis < 3; ++axis)
                    result.corners[side][axis][lane] = part.corners[side][axis];
            if (part.count > 0)
                result.child[lane] = addLeaf(part);
            else
                pending_.push_back({parts[lane], index, lane});
        }
    }

    std::uint32_t addLeaf(const Bvh2::Node& leaf) {
        const std::size_t first = wide_.entries_.size();
        const auto entries = binary_.entries().subspan(leaf.first, leaf.count);
        wide_.entries_.insert(wide_.entries_.end(), entries.begin(), entries.end());
        wide_.entries_.resize(first + leafSize_, kNone);
        return kLeafBit | static_cast<std::uint32_t>(first * kMostSlots + leaf.count - 1);
    }

    const Bvh2& binary_;
    std::size_t leafSize_;
    Bvh8& wide_;
    std::vector<Pending> pending_;
};

Bvh8::Bvh8(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop) {
    ENSURE(leafSize >= 1 && leafSize <= static_cast<int>(kWidth));
    const Bvh2 binary(boxes, leafSize, stop, leafSize);
    if (binary.nodes().empty()) return;
    bounds_ = boundsOf(binary.nodes().front());
    size_ = binary.size();
    Collapse(binary, leafSize, *this).run();
    ENSURE(entries_.size() <= kLeafBit / kMostSlots);
}

}
