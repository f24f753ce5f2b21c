#include "core/geometry/bvh2.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/base/thread_pool.h"
#include "core/geometry/sah_split.h"

namespace eyeray {
namespace {

// Splits by area down to here, then by size: no more than 32 further levels for 2³² entries.
constexpr int kMaxAreaDepth = Bvh2::kMaxDepth - 32;
// Fewer entries are not worth a second thread.
constexpr std::size_t kPartSize = 4096;
constexpr std::size_t kMostParts = 64;

using Nodes = std::vector<Bvh2::Node>;

/// Items whose tree is still to be built, under a node that is there.
struct Part {
    std::uint32_t node;
    std::uint32_t begin, end; // items
    int depth;
    BoxSpan span;

    std::size_t size() const { return end - begin; }
};

/// Splits the items of a tree, which may be done for several parts at a time.
class Splitter {
public:
    Splitter(std::span<BoxItem> items, const LeafSizes& leaf) : items_(items), leaf_(leaf) {}

    std::optional<SahSplit> split(const Part& part) const {
        return splitBySah(items_.subspan(part.begin, part.size()), part.span, leaf_,
                          part.depth >= kMaxAreaDepth);
    }

private:
    std::span<BoxItem> items_;
    LeafSizes leaf_;
};

Bvh2::Node leafOf(const Part& part) {
    const auto& [lo, hi] = part.span.boxes;
    return {.corners = {{{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}},
            .first = part.begin,
            .count = part.end - part.begin};
}

/// Puts the part into its node: as a leaf, or with two children, which are returned.
std::optional<std::array<Part, 2>> place(const Part& part, const std::optional<SahSplit>& split,
                                         Nodes& nodes) {
    nodes[part.node] = leafOf(part);
    if (!split) return {};
    const auto child = static_cast<std::uint32_t>(nodes.size());
    nodes[part.node].first = child;
    nodes[part.node].count = 0;
    nodes.resize(nodes.size() + 2);
    const auto middle = part.begin + static_cast<std::uint32_t>(split->left);
    return {{{{child, part.begin, middle, part.depth + 1, split->leftSpan},
              {child + 1, middle, part.end, part.depth + 1, split->rightSpan}}}};
}

/// The tree of a part, its root first; unfinished if `stop` was requested.
Nodes treeOf(const Part& part, const Splitter& splitter, const std::stop_token& stop) {
    Nodes nodes(1);
    nodes.reserve(part.size());
    std::vector<Part> pending{part};
    pending.front().node = 0;
    while (!pending.empty() && !stop.stop_requested()) {
        const Part next = pending.back();
        pending.pop_back();
        const auto children = place(next, splitter.split(next), nodes);
        if (!children) continue;
        pending.push_back(children->back());
        pending.push_back(children->front());
    }
    return nodes;
}

/// Puts the tree in place of one node; its further nodes come last.
void graft(const Nodes& tree, std::uint32_t at, Nodes& nodes) {
    const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
    const auto shifted = [&](Bvh2::Node node) {
        if (node.count == 0) node.first += shift;
        return node;
    };
    nodes[at] = shifted(tree.front());
    std::transform(tree.begin() + 1, tree.end(), std::back_inserter(nodes), shifted);
}

/// Level by level from the root, until there are parts enough for all threads; then part by part. The same
/// tree on any number of threads.
Nodes treeByThreads(const Part& root, const Splitter& splitter, const std::stop_token& stop) {
    ThreadPool pool;
    const std::size_t mostSize = std::max(kPartSize, root.size() / kMostParts);
    Nodes nodes(1);
    std::vector<Part> level{root}, small;
    while (!level.empty()) {
        std::vector<std::optional<SahSplit>> splits(level.size());
        pool.forEach(static_cast<int>(level.size()), stop, [&](int i) {
            splits[static_cast<std::size_t>(i)] = splitter.split(level[static_cast<std::size_t>(i)]);
        });
        if (stop.stop_requested()) return {};
        std::vector<Part> next;
        for (std::size_t i = 0; i < level.size(); ++i) {
            const auto children = place(level[i], splits[i], nodes);
            if (!children) continue;
            for (const Part& child : *children) (child.size() > mostSize ? next : small).push_back(child);
        }
        level = std::move(next);
    }
    std::ranges::sort(small, std::greater<>{},
                      [](const Part& part) { return std::pair(part.size(), part.begin); });
    std::vector<Nodes> trees(small.size()); // the last ones to be begun are short
    pool.forEach(static_cast<int>(small.size()), stop, [&](int i) {
        trees[static_cast<std::size_t>(i)] = treeOf(small[static_cast<std::size_t>(i)], splitter, stop);
    });
    if (stop.stop_requested()) return {};
    for (std::size_t i = 0; i < small.size(); ++i) graft(trees[i], small[i].node, nodes);
    return nodes;
}

}

Bvh2::Bvh2(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop, int atOnce) {
    std::vector<BoxItem> items;
    items.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].finite() && !boxes[i].empty()) items.emplace_back(boxes[i], i);
    if (items.empty()) return;

    const Splitter splitter(items, {leafSize, atOnce});
    const Part root{0, 0, static_cast<std::uint32_t>(items.size()), 0, spanOf(items)};
    Nodes nodes =
        items.size() > kPartSize ? treeByThreads(root, splitter, stop) : treeOf(root, splitter, stop);
    if (stop.stop_requested()) return;
    nodes_ = std::move(nodes);
    const auto& [lo, hi] = root.span.boxes;
    bounds_ = {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    entries_.resize(items.size());
    std::ranges::transform(items, entries_.begin(), &BoxItem::entry);
}

void Bvh2::refit(std::span<const Bounds> boxes) {
    for (std::size_t i = nodes_.size(); i-- > 0;) { // children come after their parents
        Node& node = nodes_[i];
        Bounds box;
        if (node.count == 0)
            for (std::uint32_t child = node.first; child < node.first + 2; ++child)
                box.add(nodes_[child].bounds());
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot)
            box.add(boxes[entries_[slot]]);
        node.corners = {{{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}}};
    }
    if (!nodes_.empty()) bounds_ = nodes_.front().bounds();
}

double Bvh2::cost() const {
    double sum = 0;
    for (const Node& node : nodes_) sum += node.bounds().halfArea();
    return sum;
}

}
