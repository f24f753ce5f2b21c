// labels: unit
// The wide tree: every box once, in its node, every node in its parent.

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/geometry/bvh8.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;

std::vector<Bounds> randomBoxes(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<Bounds> boxes(static_cast<std::size_t>(count));
    for (Bounds& box : boxes) {
        const DVec3 center = random.inCube(1), half(random.uniform(0, 0.1));
        box = {Vec3(center - half), Vec3(center + half)};
    }
    return boxes;
}

Bounds boxOfLane(const Bvh8::Node& node, std::size_t lane) {
    const auto& [lo, hi] = node.corners;
    return {{lo[0][lane], lo[1][lane], lo[2][lane]}, {hi[0][lane], hi[1][lane], hi[2][lane]}};
}

bool contains(const Bounds& outer, const Bounds& inner) {
    Bounds both = outer;
    both.add(inner);
    return both.lo == outer.lo && both.hi == outer.hi;
}

/// How often each box is in a leaf.
std::vector<int> timesFound(const Bvh8& tree, std::span<const Bounds> boxes, std::uint32_t leafSize) {
    std::vector<int> found(boxes.size(), 0);
    std::vector<std::pair<std::uint32_t, Bounds>> open{{0U, tree.bounds()}};
    std::size_t visited = 0;
    while (!open.empty()) {
        const auto [index, outer] = open.back();
        open.pop_back();
        ++visited;
        for (std::size_t lane = 0; lane < Bvh8::kWidth; ++lane) {
            const Bounds box = boxOfLane(tree.nodes()[index], lane);
            if (box.empty()) continue;
            EXPECT_TRUE(contains(outer, box));
            const std::uint32_t child = tree.nodes()[index].child[lane];
            if (!Bvh8::isLeaf(child)) {
                open.emplace_back(child, box);
                continue;
            }
            const auto [first, count] = Bvh8::leafOf(child);
            EXPECT_LE(count, leafSize);
            EXPECT_EQ(first % leafSize, 0U);
            for (std::uint32_t slot = first; slot < first + count; ++slot) {
                const std::uint32_t entry = tree.entries()[slot];
                ++found[entry];
                EXPECT_TRUE(contains(box, boxes[entry]));
            }
        }
    }
    EXPECT_EQ(visited, tree.nodeCount());
    return found;
}

TEST(Bvh8, HoldsEveryBoxOnceInItsNodes) {
    for (const int count : {1, 2, 7, 8, 9, 100, 5000})
        for (const int leafSize : {1, 4, 8}) {
            const auto boxes = randomBoxes(1, count);
            const Bvh8 tree(boxes, leafSize, {});
            EXPECT_EQ(tree.size(), boxes.size());
            for (const int times : timesFound(tree, boxes, static_cast<std::uint32_t>(leafSize)))
                ASSERT_EQ(times, 1) << count << " boxes, leaves of " << leafSize;
        }
}

TEST(Bvh8, NeedsFarFewerNodesThanBoxes) {
    const Bvh8 tree(randomBoxes(2, 10'000), 8, {});
    EXPECT_LT(tree.nodeCount(), 10'000 / 10);
}

TEST(Bvh8, FillsLeavesThatAreTestedAtOnce) {
    const Bvh8 tree(randomBoxes(2, 10'000), 8, {});
    EXPECT_LT(tree.entries().size(), 10'000 * 1.2) << "slots, some of which no box takes";
}

TEST(Bvh8, IsTheSameTreeForTheSameBoxes) {
    const auto boxes = randomBoxes(3, 2000);
    const Bvh8 a(boxes, 8, {}), b(boxes, 8, {});
    EXPECT_TRUE(std::ranges::equal(a.entries(), b.entries()));
    EXPECT_TRUE(std::ranges::equal(a.nodes(), b.nodes(), {}, &Bvh8::Node::child, &Bvh8::Node::child));
}

TEST(Bvh8, LeavesOutWhatIsEmptyOrNotFinite) {
    auto boxes = randomBoxes(4, 20);
    boxes[3] = Bounds{};
    boxes[7].hi.x = kInfinity;
    const Bvh8 tree(boxes, 4, {});
    EXPECT_EQ(tree.size(), 18U);
    const auto found = timesFound(tree, boxes, 4);
    EXPECT_EQ(found[3] + found[7], 0);
}

TEST(Bvh8, OfNothingOrStoppedIsEmpty) {
    EXPECT_EQ(Bvh8({}, 8, {}).nodeCount(), 0U);
    const std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(Bvh8(randomBoxes(5, 1000), 8, stop.get_token()).nodeCount(), 0U);
}

TEST(Bvh8, TakesLeavesOfUpToItsWidth) { EXPECT_THROW(Bvh8(randomBoxes(6, 10), 9, {}), InternalError); }

}
}
