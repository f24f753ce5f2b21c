// labels: unit
#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/study/svg.h"
#include "core/study/tidy_tree.h"
#include "core/study/tree_svg.h"
#include "core/study/wording.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr double kGap = 1;

struct RandomTree {
    std::vector<int> parents, levels;
    std::vector<double> breadths;
};

/// In pre-order: a node's parent is one of those on the way from the root to the node before.
RandomTree randomTree(unsigned seed, int count, bool equalBreadths) {
    std::mt19937 random(seed);
    RandomTree tree;
    for (int i = 0; i < count; ++i) {
        int parent = i - 1;
        while (parent > 0 && random() % 2 == 0) parent = tree.parents[static_cast<std::size_t>(parent)];
        tree.parents.push_back(parent);
        tree.levels.push_back(parent < 0 ? 0 : tree.levels[static_cast<std::size_t>(parent)] + 1);
        tree.breadths.push_back(equalBreadths ? 1.0 : 0.5 + static_cast<double>(random() % 4));
    }
    return tree;
}

std::vector<int> childrenOf(const RandomTree& tree, int node) {
    std::vector<int> children;
    for (std::size_t i = 0; i < tree.parents.size(); ++i)
        if (tree.parents[i] == node) children.push_back(static_cast<int>(i));
    return children;
}

TEST(TidyTree, NodesOfALevelKeepTheirOrderAndNeverOverlap) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const RandomTree tree = randomTree(seed, 120, seed % 2 == 0);
        const auto middles = tidyBreadths(tree.parents, tree.breadths, kGap);
        std::vector<std::size_t> last(tree.parents.size(), tree.parents.size());
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const auto level = static_cast<std::size_t>(tree.levels[i]);
            if (const std::size_t j = last[level]; j < middles.size()) {
                ASSERT_GE(middles[i] - middles[j], (tree.breadths[i] + tree.breadths[j]) / 2 + kGap - 1e-9)
                    << "seed " << seed << ", nodes " << j << " and " << i;
            }
            last[level] = i;
        }
    }
}

TEST(TidyTree, AParentStandsAtTheMiddleOfItsChildren) {
    const RandomTree tree = randomTree(7, 150, false);
    const auto middles = tidyBreadths(tree.parents, tree.breadths, kGap);
    for (int node = 0; node < 150; ++node) {
        const auto children = childrenOf(tree, node);
        if (children.empty()) continue;
        const double middle = (middles[static_cast<std::size_t>(children.front())] +
                               middles[static_cast<std::size_t>(children.back())]) /
                              2;
        EXPECT_NEAR(middles[static_cast<std::size_t>(node)], middle, 1e-9);
    }
}

TEST(TidyTree, AMirroredTreeIsDrawnMirrored) {
    // the root's children have 0, 3, 1 and 0, 1, 3 reversed: written from the other side
    const std::vector<int> parents = {-1, 0, 0, 2, 2, 2, 0, 6}, mirrored = {-1, 0, 1, 0, 3, 3, 3, 0};
    const std::vector<double> ones(parents.size(), 1.0);
    const auto a = tidyBreadths(parents, ones, kGap), b = tidyBreadths(mirrored, ones, kGap);
    const double width = *std::max_element(a.begin(), a.end()) + 0.5;
    EXPECT_NEAR(width, *std::max_element(b.begin(), b.end()) + 0.5, 1e-9);
    const std::vector<std::size_t> other = {0, 7, 3, 6, 5, 4, 1, 2};
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], width - b[other[i]], 1e-9) << i;
}

TEST(TidyTree, AChainIsStraight) {
    std::vector<int> parents(64);
    std::iota(parents.begin(), parents.end(), -1);
    for (const double middle : tidyBreadths(parents, std::vector<double>(64, 2.0), kGap))
        EXPECT_EQ(middle, 1);
}

/// A mirror in the floor's light, a sky, and one lamp that a ball hides.
Scene mirrorAndFloor() {
    Scene scene = underSky(Color(0.5F));
    add(scene, Sphere{1}, mirror(Color(0.5F)), at({0, 0, -4}));
    add(scene, Sphere{1}, matte(Color(0.5F)), at({0, 4, 2}));
    scene.lights = {taughtLampAt({0, 6, 4}), taughtLampAt({6, 0, 0})};
    scene.lights[0].name = "key";
    scene.lights[1].name = "fill";
    scene.objects[0].name = "mirror ball";
    auto& m = std::get<TaughtMaterial>(scene.materials[0].model);
    m.diffuse = Color(0.3F);
    return scene;
}

int count(const TreeDiagram& diagram, const std::string& title) {
    return static_cast<int>(
        std::count_if(diagram.nodes.begin(), diagram.nodes.end(), [&](const DiagramNode& node) {
            return node.title.find(title) != std::string::npos ||
                   node.detail.find(title) != std::string::npos;
        }));
}

TEST(TreeDiagram, HasANodeForEachRayThatWasTracedAndEachThatWasNot) {
    const Scene scene = mirrorAndFloor();
    const Retrace trace = Tracing(scene, toDepth(3)).retrace();
    const TreeDiagram diagram = diagramOf(trace, scene, {});
    EXPECT_EQ(diagram.nodes.size(), trace.rays.size() + trace.untraced.size());
    EXPECT_EQ(diagram.nodes[0].title, "mirror ball");
    EXPECT_EQ(diagram.nodes[0].detail, "t = 3 m");
    EXPECT_EQ(count(diagram, "nothing hit"), 1);
    EXPECT_EQ(count(diagram, "key: blocked"), 1);
    EXPECT_EQ(count(diagram, "fill: lit"), 1);
}

TEST(TreeDiagram, NamesWhyARayWasNotTraced) {
    const Scene scene = mirrorAndFloor();
    const auto reasonOf = [&](const TraceSettings& settings) {
        const TreeDiagram diagram = diagramOf(Tracing(scene, settings).retrace(), scene, {});
        const auto found = std::find_if(diagram.nodes.begin(), diagram.nodes.end(),
                                        [](const DiagramNode& node) { return !node.traced; });
        return found == diagram.nodes.end() ? "" : found->detail;
    };
    EXPECT_EQ(reasonOf(toDepth(0)), "depth limit");
    TraceSettings off = toDepth(3), cut = toDepth(3);
    off.reflections = false;
    cut.cutoff = 0.6F;
    EXPECT_EQ(reasonOf(off), "switched off");
    EXPECT_EQ(reasonOf(cut), "below the cutoff");
    EXPECT_EQ(reasonOf(toDepth(3)), "");
}

TEST(TreeDiagram, NamesTotalInternalReflection) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{2, 2, 2}}, glass(1.5F), glm::rotate(at({0, 0, -4}), kPiD / 4, DVec3(0, 0, 1)));
    look(scene, {0.4, 0.3, 0}, {0.1, -0.4, -4});
    bool named = false;
    const Tracing tracing(scene, toDepth(6), 24, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const Retrace trace = tracing.retrace(x, y);
            const auto total = std::count_if(trace.rays.begin(), trace.rays.end(),
                                             [](const RayRecord& ray) { return ray.totalReflection; });
            EXPECT_EQ(count(diagramOf(trace, scene, {}), std::string(kTotalReflectionText)), total);
            named |= total > 0;
        }
    EXPECT_TRUE(named);
}

TEST(TreeDiagram, FiltersByKindWeightAndCollapse) {
    const Scene scene = mirrorAndFloor();
    const Retrace trace = Tracing(scene, toDepth(3)).retrace();
    TreeFilter noShadows, heavy, folded;
    noShadows.kinds[static_cast<std::size_t>(RayKind::Shadow)] = false;
    const TreeDiagram without = diagramOf(trace, scene, noShadows);
    EXPECT_TRUE(std::none_of(without.nodes.begin(), without.nodes.end(),
                             [](const DiagramNode& node) { return node.kind == RayKind::Shadow; }));
    EXPECT_EQ(without.nodes.size(), 2U);
    heavy.leastWeight = 0.6F;
    const TreeDiagram few = diagramOf(trace, scene, heavy);
    EXPECT_EQ(few.nodes.size(), 3U) << "the eye ray and its shadow rays weigh 1, the mirrored one 0.5";
    folded.collapsed = {0};
    const TreeDiagram one = diagramOf(trace, scene, folded);
    ASSERT_EQ(one.nodes.size(), 1U);
    EXPECT_EQ(one.nodes[0].hidden, 3);
}

TEST(TreeDiagram, ChildrenStandToTheRightAndEdgesEndAtTheirBoxes) {
    const Scene scene = mirrorAndFloor();
    const TreeDiagram diagram = diagramOf(Tracing(scene, toDepth(3)).retrace(), scene, {});
    for (const DiagramNode& node : diagram.nodes) {
        EXPECT_GE(node.x, 0);
        EXPECT_GE(node.y, 0);
        EXPECT_LE(node.x + node.width, diagram.width + 1e-4F);
        EXPECT_LE(node.y + node.height, diagram.height + 1e-4F);
        if (node.parent < 0) continue;
        const DiagramNode& parent = diagram.nodes[static_cast<std::size_t>(node.parent)];
        EXPECT_GT(node.x, parent.x + parent.width);
        const auto curve = edgeCurve(diagram, node);
        EXPECT_EQ(pointOf(curve, 0), Vec2(parent.x + parent.width, parent.y + parent.height / 2));
        EXPECT_EQ(pointOf(curve, 1), Vec2(node.x, node.y + node.height / 2));
    }
}

TEST(Svg, EscapesWhatXmlReservesAndDropsControlCharacters) {
    Svg svg(10, 10, 0xffffff);
    svg.text({1, 2}, "a<b & c>d\a", {});
    EXPECT_NE(svg.file().find(">a&lt;b &amp; c&gt;d</text>"), std::string::npos) << svg.file();
}

TEST(Svg, OfARayTreeHoldsEachBoxAndIsBalanced) {
    Scene scene = mirrorAndFloor();
    scene.objects[0].name = "ball <1> & co";
    const TreeDiagram diagram = diagramOf(Tracing(scene, toDepth(3)).retrace(), scene, {});
    const std::string svg = svgOf(diagram, "pixel (0, 0)", {}, false);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
    EXPECT_EQ(std::count(svg.begin(), svg.end(), '<'), std::count(svg.begin(), svg.end(), '>'));
    EXPECT_NE(svg.find("ball &lt;1&gt; &amp; co"), std::string::npos);
    EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos) << "shadow rays are dashed";
}

}
}
