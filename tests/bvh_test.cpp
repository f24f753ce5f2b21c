// labels: unit threads
// The binary tree: what it must hold together by, also for boxes made to break builders (stability F26).

#include <gtest/gtest.h>

#include "core/geometry/bvh2.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

constexpr int kLeaf = 4;

Bounds boxAt(const DVec3& center, double half) {
    return {Vec3(center - DVec3(half)), Vec3(center + DVec3(half))};
}

bool contains(const Bvh2::Node& outer, const Bounds& inner) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (inner.lo[axis] < outer.corners[0][i] || inner.hi[axis] > outer.corners[1][i]) return false;
    }
    return true;
}

Bounds boundsOfNode(const Bvh2::Node& node) {
    const auto& [lo, hi] = node.corners;
    return {Vec3(lo[0], lo[1], lo[2]), Vec3(hi[0], hi[1], hi[2])};
}

/// Every slot is in one leaf, every box in its node, every node in its parent; how deep the tree is.
int checkedDepth(const Bvh2& tree, std::span<const Bounds> boxes, int leafSize) {
    std::vector<int> found(tree.entries().size(), 0);
    int deepest = 0;
    std::vector<std::pair<std::uint32_t, int>> open;
    if (!tree.nodes().empty()) open.emplace_back(0U, 0);
    std::size_t visited = 0;
    while (!open.empty()) {
        const auto [index, depth] = open.back();
        open.pop_back();
        ++visited;
        deepest = std::max(deepest, depth);
        const Bvh2::Node& node = tree.nodes()[index];
        EXPECT_LE(node.count, static_cast<std::uint32_t>(leafSize));
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
            ++found[slot];
            EXPECT_TRUE(contains(node, boxes[tree.entries()[slot]]));
        }
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            EXPECT_TRUE(contains(node, boundsOfNode(tree.nodes()[child])));
            open.emplace_back(child, depth + 1);
        }
    }
    EXPECT_EQ(visited, tree.nodeCount());
    EXPECT_TRUE(std::ranges::all_of(found, [](int times) { return times == 1; }));
    return deepest;
}

int depthOver(std::span<const Bounds> boxes, int leafSize = kLeaf) {
    const Bvh2 tree(boxes, leafSize, {});
    EXPECT_EQ(tree.entries().size(), boxes.size());
    const int depth = checkedDepth(tree, boxes, leafSize);
    EXPECT_LE(depth, Bvh2::kMaxDepth);
    return depth;
}

std::vector<Bounds> randomBoxes(std::uint32_t seed, int count, double scale = 1) {
    Random random(seed);
    std::vector<Bounds> boxes(static_cast<std::size_t>(count));
    for (Bounds& box : boxes) box = boxAt(random.inCube(scale), random.uniform(0, 0.1 * scale));
    return boxes;
}

TEST(Bvh2, OfNothingIsEmptyAndVisitsNothing) {
    const Bvh2 tree({}, kLeaf, {});
    EXPECT_EQ(tree.nodeCount(), 0U);
    EXPECT_FALSE(tree.visit(ray({0, 0, 0}, {0, 0, 1}), kInfinity, [](std::uint32_t) { return true; }));
}

TEST(Bvh2, HoldsEveryBoxOnceInBalancedDepth) {
    for (const int count : {1, 2, 3, 4, 5, 9, 100, 10'000}) {
        const auto boxes = randomBoxes(1, count);
        EXPECT_LE(depthOver(boxes), 2 * std::log2(count) + 4);
        EXPECT_LE(depthOver(boxes, 1), 2 * std::log2(count) + 4);
    }
}

TEST(Bvh2, IsTheSameTreeForTheSameBoxesWhicheverThreadIsFirst) {
    const auto boxes = randomBoxes(2, 50'000);
    const Bvh2 a(boxes, kLeaf, {});
    for (int again = 0; again < 5; ++again) {
        const Bvh2 b(boxes, kLeaf, {});
        ASSERT_EQ(a.nodeCount(), b.nodeCount());
        EXPECT_TRUE(std::ranges::equal(a.entries(), b.entries()));
        EXPECT_TRUE(std::ranges::equal(a.nodes(), b.nodes(), [](const auto& p, const auto& q) {
            return p.corners == q.corners && p.first == q.first && p.count == q.count;
        }));
    }
}

TEST(Bvh2, SurvivesEqualBoxes) {
    for (const int count : {1000, 2000, 100'000}) {
        const std::vector<Bounds> boxes(static_cast<std::size_t>(count), boxAt({1, 2, 3}, 0.5));
        EXPECT_LE(depthOver(boxes), 18);
    }
}

TEST(Bvh2, SurvivesBoxesThatGrowByPowersOfTwo) {
    std::vector<Bounds> corner, around, apart;
    for (int e = -120; e <= 120; ++e) {
        const double size = std::exp2(e);
        corner.push_back({Vec3(0), Vec3(DVec3(size))});
        around.push_back(boxAt(DVec3(0), size));
        apart.push_back(boxAt(DVec3(1.5 * size, 0, 0), 0.25 * size));
    }
    depthOver(corner);
    depthOver(around);
    depthOver(apart);
    std::vector<Bounds> many;
    for (int repeat = 0; repeat < 400; ++repeat) many.insert(many.end(), apart.begin(), apart.end());
    depthOver(many);
}

TEST(Bvh2, SurvivesPointsAndFlatBoxes) {
    std::vector<Bounds> points, wall;
    for (int i = 0; i < 5000; ++i) points.push_back(boxAt(DVec3(i % 7, i % 11, i % 13), 0));
    for (int i = 0; i < 5000; ++i) wall.push_back({Vec3(i % 70, i / 70, 0), Vec3(i % 70 + 1, i / 70 + 1, 0)});
    depthOver(points);
    depthOver(wall);
}

TEST(Bvh2, LeavesOutBoxesThatAreEmptyOrNotFinite) {
    auto boxes = randomBoxes(3, 100);
    const float nan = std::nanf("");
    boxes[10] = Bounds{};
    boxes[20].hi.x = kInfinity;
    boxes[30].lo.y = nan;
    boxes[40] = {Vec3(nan), Vec3(nan)};
    boxes[50] = {Vec3(1), Vec3(-1)};
    const Bvh2 tree(boxes, kLeaf, {});
    EXPECT_EQ(tree.entries().size(), 95U);
    for (const std::uint32_t entry : tree.entries()) EXPECT_TRUE(entry % 10 != 0 || entry == 0 || entry > 50);
    checkedDepth(tree, boxes, kLeaf);
    EXPECT_EQ(BruteForce(boxes, kLeaf, {}).entries().size(), 95U);
}

TEST(Bvh2, IsEmptyIfStopped) {
    const std::stop_source stop;
    stop.request_stop();
    for (const int count : {1000, 20'000}) {
        const Bvh2 tree(randomBoxes(4, count), kLeaf, stop.get_token());
        EXPECT_EQ(tree.nodeCount(), 0U);
        EXPECT_TRUE(tree.entries().empty());
    }
}

TEST(Bvh2, VisitsEveryBoxThatARayCrosses) {
    using Real = long double;
    Random random(5);
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const auto boxes = randomBoxes(6, 500, scale);
        const Bvh2 tree(boxes, kLeaf, {});
        for (int i = 0; i < 2000; ++i) {
            const Ray r = ray(random.inCube(2 * scale), random.direction());
            std::vector<bool> visited(boxes.size(), false);
            tree.visit(r, kInfinity, [&](std::uint32_t slot) {
                visited[tree.entries()[slot]] = true;
                return false;
            });
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                Real in = 0, out = kInfinity;
                for (int axis = 0; axis < 3; ++axis) {
                    const Real o = r.origin[axis], d = r.direction[axis];
                    const Real a = (boxes[k].lo[axis] - o) / d, b = (boxes[k].hi[axis] - o) / d;
                    in = std::fmax(in, std::fmin(a, b));
                    out = std::fmin(out, std::fmax(a, b));
                }
                ASSERT_TRUE(visited[k] || in > out);
            }
        }
    }
}

TEST(Bvh2, StopsAtTheFirstYesAndHeedsAShrinkingLimit) {
    std::vector<Bounds> row(100);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = boxAt(DVec3(0, 0, -static_cast<double>(i)), 0.25);
    const Bvh2 tree(row, 1, {});
    const Ray r = ray({0, 0, 5}, {0, 0, -1});
    int calls = 0;
    EXPECT_TRUE(tree.visit(r, kInfinity, [&](std::uint32_t) { return ++calls == 3; }));
    EXPECT_EQ(calls, 3);
    calls = 0;
    float limit = kInfinity;
    EXPECT_FALSE(tree.visit(r, limit, [&](std::uint32_t slot) {
        EXPECT_EQ(tree.entries()[slot], static_cast<std::uint32_t>(calls++)) << "from near to far";
        limit = 5.5F;
        return false;
    }));
    EXPECT_EQ(calls, 1) << "the second box begins at 5.75";
}

}
}
