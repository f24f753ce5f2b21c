#include "core/geometry/bvh8.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/geometry/bvh2.h"
#include "core/geometry/collapse.h"

namespace eyeray {
namespace {

void setBox(Bvh8::Node& node, std::size_t lane, const Bounds& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        node.corners[0][a][lane] = box.lo[axis];
        node.corners[1][a][lane] = box.hi[axis];
    }
}

Bounds boundsOf(const Bvh8::Node& node) {
    Bounds box;
    for (std::size_t lane = 0; lane < Bvh8::kWidth; ++lane) box.add(Bvh8::boxOf(node, lane)); // or nothing
    return box;
}

}

/// Writes the nodes and leaves that a Collapse chooses, depth first.
class Bvh8::Writer {
public:
    Writer(const Bvh2& binary, int leafSize, Bvh8& wide)
        : binary_(binary), collapse_(binary.nodes()), leafSize_(static_cast<std::size_t>(leafSize)),
          wide_(wide) {}

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

    void addNode(std::uint32_t root) {
        const std::size_t index = wide_.nodes_.size();
        Node& result = wide_.nodes_.emplace_back();
        for (std::size_t lane = 0; lane < kWidth; ++lane) setBox(result, lane, Bounds{});
        const Collapse::Children children = collapse_.childrenOf(root);
        for (std::size_t lane = 0; lane < children.count; ++lane) {
            const Bvh2::Node& child = binary_.nodes()[children.node[lane]];
            setBox(result, lane, child.bounds());
            if (child.count > 0)
                result.child[lane] = addLeaf(child);
            else
                pending_.push_back({children.node[lane], index, lane});
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
    Collapse collapse_;
    std::size_t leafSize_;
    Bvh8& wide_;
    std::vector<Pending> pending_;
};

Bvh8::Bvh8(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop) {
    ENSURE(leafSize >= 1 && leafSize <= static_cast<int>(kWidth));
    const Bvh2 binary(boxes, leafSize, stop, leafSize);
    if (binary.nodes().empty()) return;
    bounds_ = binary.nodes().front().bounds();
    size_ = binary.size();
    Writer(binary, leafSize, *this).run();
    ENSURE(entries_.size() <= kLeafBit / kMostSlots);
}

void Bvh8::refit(std::span<const Bounds> boxes) {
    for (std::size_t i = nodes_.size(); i-- > 0;) { // children come after their parents
        Node& node = nodes_[i];
        for (std::size_t lane = 0; lane < childrenOf(node); ++lane) {
            Bounds box;
            if (isLeaf(node.child[lane])) {
                const Leaf leaf = leafOf(node.child[lane]);
                for (const std::uint32_t entry : entries().subspan(leaf.first, leaf.count))
                    box.add(boxes[entry]);
            } else {
                box = boundsOf(nodes_[node.child[lane]]);
            }
            setBox(node, lane, box);
        }
    }
    if (!nodes_.empty()) bounds_ = boundsOf(nodes_.front());
}

double Bvh8::cost() const {
    double sum = 0;
    for (const Node& node : nodes_)
        for (std::size_t lane = 0; lane < childrenOf(node); ++lane) sum += boxOf(node, lane).halfArea();
    return sum;
}

}
