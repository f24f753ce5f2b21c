// labels: unit
// Top levels whose boxes follow moved objects: the hits of brute force, and no tree that has gone bad.

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"
#include "tests/instruction_sets.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;

constexpr double kHalfSize = 5; // of the cube in which objects stand

template <class Index>
using Instances = std::vector<Instance<Index>>;

/// Shapes, placed meshes and an unbounded plane; every third object is `moved` as far as that.
template <class Index>
Instances<Index> scene(double moved) {
    Random random(1);
    const auto body = indexMesh<Index>(cases::shared(cases::closedMesh(5, 7, 0.5, 0.3)), {});
    Instances<Index> instances;
    const auto add = [&](const auto& geometry) {
        DMat4 map = cases::randomPlacement(random, kHalfSize / 2, 0.1, 0.5);
        const DVec3 away = random.direction();
        if (instances.size() % 3 == 0) map = glm::translate(DMat4(1), moved * away) * map;
        instances.push_back(place<Index>(map, geometry));
        instances.back().mask = random.below(3) == 0 ? RayMask::Transparent : RayMask::Opaque;
    };
    for (int i = 0; i < 50; ++i) {
        if (i % 5 == 0) add(body);
        add(Shape(Sphere{0.5F}));
        add(Shape(Box{Vec3(1, 0.5F, 0.7F)}));
        add(Shape(Cylinder{1, 0.2F, 0.4F}));
    }
    instances.push_back(place<Index>(glm::translate(DMat4(1), DVec3(0, -kHalfSize, 0)), Shape(Plane{})));
    return instances;
}

template <class Index>
void expectSameHits(const IndexedGeometry<Index>& tree, const IndexedGeometry<BruteForce>& all) {
    Random random(2);
    int hits = 0;
    for (int i = 0; i < 1'500; ++i) {
        const DVec3 origin = random.inCube(2 * kHalfSize);
        const Ray ray = cases::ray(origin, random.inCube(kHalfSize) - origin);
        for (const RayMask mask : {RayMask::All, RayMask::Opaque}) {
            const auto a = closestHit(tree, ray, mask), b = closestHit(all, ray, mask);
            ASSERT_EQ(a.has_value(), b.has_value()) << i;
            ASSERT_EQ(anyHit(tree, ray, mask), b.has_value()) << i;
            if (!a) continue;
            ++hits;
            ASSERT_EQ(a->t, b->t) << i;
            ASSERT_EQ(std::tie(a->u, a->v, a->primitive, a->instance),
                      std::tie(b->u, b->v, b->primitive, b->instance))
                << i;
        }
    }
    EXPECT_GT(hits, 1'000);
}

template <class Index>
class Refit : public testing::Test {};
using Trees = testing::Types<Bvh2, Bvh8>;
TYPED_TEST_SUITE(Refit, Trees);

TYPED_TEST(Refit, FindsTheHitsOfBruteForceBitForBit) {
    withEachInstructionSet([] {
        auto tree = indexInstances(scene<TypeParam>(0), {});
        EXPECT_FALSE(tree.costBuilt);
        const std::size_t nodes = tree.nodes;
        for (const double moved : {0.2, 0.4, 0.0, 0.3}) {
            tree = refitInstances(scene<TypeParam>(moved), tree, {});
            EXPECT_TRUE(tree.costBuilt) << moved;
            EXPECT_EQ(tree.nodes, nodes);
            expectSameHits(tree, indexInstances(scene<BruteForce>(moved), {}));
        }
    });
}

TYPED_TEST(Refit, WithEverythingInItsOldPlaceIsTheTreeThatWasBuilt) {
    const auto built = indexInstances(scene<TypeParam>(0), {});
    const auto there = refitInstances(scene<TypeParam>(1), built, {});
    const auto back = refitInstances(scene<TypeParam>(0), there, {});
    EXPECT_TRUE(std::ranges::equal(back.top.nodes(), built.top.nodes(),
                                   [](const auto& a, const auto& b) { return a.corners == b.corners; }));
    EXPECT_EQ(back.top.cost(), built.top.cost());
    EXPECT_GT(there.top.cost(), built.top.cost());
}

TYPED_TEST(Refit, GivesUpATreeThatHasBecomeHalfAsCostlyAgainSinceItWasBuilt) {
    const auto built = indexInstances(scene<TypeParam>(0), {});
    auto tree = built;
    double moved = 0;
    while (tree.costBuilt || moved == 0) { // in small steps, none of which is bad
        ASSERT_LT(moved, kHalfSize);
        tree = refitInstances(scene<TypeParam>(moved += 0.05), tree, {});
        if (tree.costBuilt) {
            EXPECT_EQ(*tree.costBuilt, built.top.cost());
            EXPECT_LE(tree.top.cost(), 1.5 * built.top.cost());
        }
    }
    const auto anew = indexInstances(scene<TypeParam>(moved), {});
    EXPECT_EQ(tree.top.cost(), anew.top.cost());
    expectSameHits(tree, indexInstances(scene<BruteForce>(moved), {}));
}

template <class Index>
void expectBuiltAnew(const Instances<Index>& changed, const Instances<BruteForce>& same) {
    const auto tree = refitInstances(changed, indexInstances(scene<Index>(0), {}), {});
    EXPECT_FALSE(tree.costBuilt);
    expectSameHits(tree, indexInstances(same, {}));
}

TYPED_TEST(Refit, IsNoneOfOtherObjects) {
    const auto with = [](const auto& change) {
        auto changed = scene<TypeParam>(0);
        auto same = scene<BruteForce>(0);
        change(changed);
        change(same);
        expectBuiltAnew(changed, same);
    };
    with([](auto& instances) { instances.pop_back(), instances.pop_back(); });
    with([](auto& instances) { instances.erase(instances.begin()); });
    with([](auto& instances) { instances[1].geometry = Shape(Plane{}); });
    with([](auto& instances) { instances.back().geometry = Shape(Sphere{1}); });
    with([](auto& instances) { instances[1].placement = Placement(DMat4(0)); });
}

TEST(RefitOfNothing, IsBuiltAnew) {
    const IndexedGeometry<Bvh8> nothing = indexInstances(Instances<Bvh8>{}, {});
    EXPECT_FALSE(closestHit(refitInstances(Instances<Bvh8>{}, nothing, {}), cases::ray({}, {0, 0, -1})));
    expectSameHits(refitInstances(scene<Bvh8>(0), nothing, {}), indexInstances(scene<BruteForce>(0), {}));
}

}
}
