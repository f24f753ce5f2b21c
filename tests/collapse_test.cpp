// labels: unit
// How a binary tree is made a wide one: against all ways to do it, and against opening the largest node.

#include "core/geometry/collapse.h"

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using Node = std::uint32_t;

/// Boxes in clusters of very different size and density.
Bvh2 treeOver(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<Bounds> boxes;
    for (int i = 0; i < count; ++i) {
        const double scale = std::exp2(-random.uniform(0, 6));
        const DVec3 center = random.inCube(scale), half(scale * random.uniform(0, 0.3), 0.01, 0.02);
        boxes.push_back({Vec3(center - half), Vec3(center + half)});
    }
    return Bvh2(boxes, 1, {});
}

double areaOf(const Bvh2& tree, Node node) { return tree.nodes()[node].bounds().halfArea(); }
bool isLeaf(const Bvh2& tree, Node node) { return tree.nodes()[node].count > 0; }

/// Areas of the nodes of the wide tree that `childrenOf` makes, added up.
template <class ChildrenOf>
double costOf(const Bvh2& tree, Node node, const ChildrenOf& childrenOf) {
    if (isLeaf(tree, node)) return 0;
    double sum = areaOf(tree, node);
    for (const Node child : childrenOf(node)) sum += costOf(tree, child, childrenOf);
    return sum;
}

std::vector<Node> chosen(const Collapse& collapse, Node node) {
    const Collapse::Children children = collapse.childrenOf(node);
    return {children.node.begin(), children.node.begin() + static_cast<std::ptrdiff_t>(children.count)};
}

std::vector<Node> largestOpened(const Bvh2& tree, Node node) {
    std::vector<Node> parts{node};
    while (parts.size() < Bvh8::kWidth) {
        const auto size = [&](Node part) { return isLeaf(tree, part) ? -1.0 : areaOf(tree, part); };
        const auto largest = std::ranges::max_element(parts, {}, size);
        if (isLeaf(tree, *largest)) break;
        const Node left = tree.nodes()[*largest].first;
        *largest = left;
        parts.push_back(left + 1);
    }
    return parts;
}

/// Every way to stand for a node by up to `most` nodes below it, or by itself.
std::vector<std::vector<Node>> allWays(const Bvh2& tree, Node node, std::size_t most) {
    std::vector<std::vector<Node>> ways{{node}};
    if (isLeaf(tree, node) || most < 2) return ways;
    const Node left = tree.nodes()[node].first;
    for (const auto& first : allWays(tree, left, most - 1))
        for (const auto& second : allWays(tree, left + 1, most - first.size())) {
            ways.push_back(first);
            ways.back().insert(ways.back().end(), second.begin(), second.end());
        }
    return ways;
}

/// Least cost of any wide tree, by trying them all.
double leastCost(const Bvh2& tree, Node node, std::vector<double>& known) {
    if (isLeaf(tree, node)) return 0;
    if (known[node] >= 0) return known[node];
    double least = kInfinity;
    for (const auto& children : allWays(tree, node, Bvh8::kWidth)) {
        if (children.size() < 2) continue;
        double sum = areaOf(tree, node);
        for (const Node child : children) sum += leastCost(tree, child, known);
        least = std::min(least, sum);
    }
    return known[node] = least;
}

TEST(Collapse, IsTheCheapestOfAllWays) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const Bvh2 tree = treeOver(seed, 30);
        const Collapse collapse(tree.nodes());
        std::vector<double> known(tree.nodeCount(), -1);
        const double least = leastCost(tree, 0, known);
        const double cost = costOf(tree, 0, [&](Node node) { return chosen(collapse, node); });
        EXPECT_NEAR(cost, least, 1e-5 * least) << seed;
    }
}

TEST(Collapse, CostsLessThanOpeningTheLargestNodes) {
    const Bvh2 tree = treeOver(1, 20'000);
    const Collapse collapse(tree.nodes());
    const double cost = costOf(tree, 0, [&](Node node) { return chosen(collapse, node); });
    EXPECT_LT(cost, 0.97 * costOf(tree, 0, [&](Node node) { return largestOpened(tree, node); }));
}

TEST(Collapse, FillsNodesWhereNoBoxHasAnArea) {
    std::vector<Bounds> points(64);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].add(Vec3(i, 0, 0));
    const Bvh2 tree(points, 1, {});
    const Collapse collapse(tree.nodes());
    EXPECT_EQ(collapse.childrenOf(0).count, Bvh8::kWidth);
}

TEST(Collapse, FillsNodesWhereAreasAreBeyondFloats) {
    std::vector<Bounds> boxes(64);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double x = 1e30 * static_cast<double>(i);
        boxes[i] = {Vec3(x, 0, 0), Vec3(x, 1e30, 1e30)};
    }
    const Bvh2 tree(boxes, 1, {});
    const Collapse collapse(tree.nodes());
    EXPECT_EQ(collapse.childrenOf(0).count, Bvh8::kWidth);
}

TEST(Collapse, OfALeafIsThatLeaf) {
    const Bvh2 tree = treeOver(1, 1);
    const Collapse collapse(tree.nodes());
    EXPECT_EQ(chosen(collapse, 0), std::vector<Node>{0});
}

}
}
