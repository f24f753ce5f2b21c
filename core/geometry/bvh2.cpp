#include "core/geometry/bvh2.h"

#include <algorithm>
#include <numeric>

namespace eyeray {
namespace {

constexpr int kBins = 16;
// Splits by area down to here, then at the median: no more than 32 further levels for 2³² entries.
constexpr int kMaxAreaDepth = Bvh2::kMaxDepth - 32;
// One node's test against one entry's; from 0.5 to 2 the rate of eye rays on 100,000 triangles hardly moves.
constexpr double kNodeCost = 1;

struct Item {
    Bounds box;
    std::uint32_t entry;

    Vec3 center() const { return box.center(); }
};

struct Task {
    std::uint32_t node;
    std::uint32_t begin, end;
    int depth;
};

struct Split {
    int axis = -1; // none found
    int bin = 0;   // the first that goes right
    double cost = 0;
};

double halfArea(const Bounds& box) { // in double: the area of 2^±120 is out of float's range
    const DVec3 e = DVec3(box.hi) - DVec3(box.lo);
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Cuts the range of centres into equal bins along each axis.
class Binning {
public:
    explicit Binning(const Bounds& centers) : lo_(centers.lo) {
        const Vec3 extent = centers.extent();
        for (int axis = 0; axis < 3; ++axis) {
            const bool wide = extent[axis] > 1e-30F && std::isfinite(extent[axis]);
            scale_[axis] = wide ? static_cast<float>(kBins) / extent[axis] : 0.0F;
        }
    }

    bool splits(int axis) const { return scale_[axis] > 0; }
    int bin(const Vec3& center, int axis) const {
        return std::min(kBins - 1, static_cast<int>((center[axis] - lo_[axis]) * scale_[axis]));
    }

private:
    Vec3 lo_, scale_;
};

struct Bin {
    Bounds box;
    std::uint32_t count = 0;

    void add(const Bin& other) {
        box.add(other.box);
        count += other.count;
    }
};
using Bins = std::array<Bin, kBins>;

// Least sum of child area times child count along one axis.
void improve(Split& best, const Bins& bins, int axis) {
    std::array<double, kBins> right{};
    Bin sum;
    for (std::size_t i = kBins - 1; i > 0; --i) {
        sum.add(bins[i]);
        right[i] = sum.count > 0 ? halfArea(sum.box) * sum.count : -1;
    }
    sum = Bin{};
    for (std::size_t i = 1; i < kBins; ++i) {
        sum.add(bins[i - 1]);
        if (sum.count == 0 || right[i] < 0) continue;
        const double cost = halfArea(sum.box) * sum.count + right[i];
        if (best.axis < 0 || cost < best.cost) best = {axis, static_cast<int>(i), cost};
    }
}

Split bestSplit(std::span<const Item> items, const Binning& binning) {
    std::array<Bins, 3> bins;
    for (const Item& item : items) {
        const Vec3 center = item.center();
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin =
                bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(binning.bin(center, axis))];
            bin.box.add(item.box);
            ++bin.count;
        }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis)
        if (binning.splits(axis)) improve(best, bins[static_cast<std::size_t>(axis)], axis);
    return best;
}

std::size_t medianSplit(std::span<Item> items, const Bounds& centers) {
    const Vec3 e = centers.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : (e.y >= e.z ? 1 : 2);
    const auto middle = static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), items.begin() + middle, items.end(), [=](const Item& a, const Item& b) {
        const float p = a.center()[axis], q = b.center()[axis];
        return p < q || (p == q && a.entry < b.entry);
    });
    return static_cast<std::size_t>(middle);
}

// How many items go left, or 0 for a leaf. Reorders the items.
std::size_t partition(std::span<Item> items, const Bounds& box, int leafSize, int depth) {
    const bool mayBeLeaf = items.size() <= static_cast<std::size_t>(leafSize);
    if (items.size() == 1) return 0;
    Bounds centers;
    for (const Item& item : items) centers.add(item.center());
    if (depth >= kMaxAreaDepth) return mayBeLeaf ? 0 : medianSplit(items, centers);

    const Binning binning(centers);
    const Split split = bestSplit(items, binning);
    const double area = halfArea(box);
    const double leafCost = area * static_cast<double>(items.size());
    if (mayBeLeaf && !(split.axis >= 0 && area * kNodeCost + split.cost < leafCost)) return 0;
    if (split.axis < 0) return medianSplit(items, centers);
    const auto right = std::partition(items.begin(), items.end(), [&](const Item& item) {
        return binning.bin(item.center(), split.axis) < split.bin;
    });
    return static_cast<std::size_t>(right - items.begin());
}

}

Bvh2::Bvh2(std::span<const Bounds> boxes, int leafSize, const std::stop_token& stop) {
    std::vector<Item> items;
    items.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].finite() || boxes[i].empty()) continue;
        items.push_back({boxes[i], i});
        bounds_.add(boxes[i]);
    }
    if (items.empty()) return;

    nodes_.reserve(items.size());
    nodes_.emplace_back();
    std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(items.size()), 0}};
    while (!tasks.empty()) {
        if (stop.stop_requested()) {
            *this = Bvh2();
            return;
        }
        const Task task = tasks.back();
        tasks.pop_back();
        const auto range = std::span(items).subspan(task.begin, task.end - task.begin);
        Bounds box;
        for (const Item& item : range) box.add(item.box);
        Node& node = nodes_[task.node];
        node.corners = {{{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}}};
        const std::size_t left = partition(range, box, leafSize, task.depth);
        if (left == 0) {
            node.first = task.begin;
            node.count = task.end - task.begin;
            continue;
        }
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        const auto middle = task.begin + static_cast<std::uint32_t>(left);
        node.first = child;
        node.count = 0;
        nodes_.resize(nodes_.size() + 2);
        tasks.push_back({child + 1, middle, task.end, task.depth + 1});
        tasks.push_back({child, task.begin, middle, task.depth + 1});
    }
    entries_.resize(items.size());
    std::ranges::transform(items, entries_.begin(), &Item::entry);
}

}
