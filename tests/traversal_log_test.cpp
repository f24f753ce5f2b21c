// labels: unit
// The log of a ray's way through an index: it changes no hit, and counts what brute force and the tree say.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;

/// Two meshes placed several times among shapes, over an infinite plane.
template <class Index>
IndexedGeometry<Index> scene() {
    Random random(1);
    const auto body = indexMesh<Index>(cases::shared(cases::closedMesh(20, 24, 0.5, 0.3)), {});
    const auto soup = indexMesh<Index>(cases::shared(cases::triangleSoup(random, 300, 0.5)), {});
    std::vector<Instance<Index>> instances;
    for (int i = 0; i < 5; ++i)
        for (const auto& mesh : {body, soup}) {
            instances.push_back(place<Index>(cases::randomPlacement(random, 1), mesh));
            instances.push_back(place<Index>(cases::randomPlacement(random, 1), Shape(Sphere{0.5F})));
        }
    instances.push_back(place<Index>(glm::translate(DMat4(1), DVec3(0, -3, 0)), Shape(Plane{})));
    return indexInstances<Index>(std::move(instances), {});
}

/// Nodes that a ray can go into: a mesh's as often as it is placed.
template <class Index>
std::size_t nodesOf(const IndexedGeometry<Index>& geometry) {
    std::size_t nodes = geometry.top.nodeCount();
    for (const auto& instance : geometry.instances)
        if (const auto* mesh = std::get_if<1>(&instance.geometry)) nodes += (*mesh)->index.nodeCount();
    return nodes;
}

Ray randomRay(Random& random) { return ray(random.inCube(4), random.inCube(2) - random.inCube(2)); }

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return std::tie(a->t, a->u, a->v, a->primitive, a->instance) ==
           std::tie(b->t, b->u, b->v, b->primitive, b->instance);
}

template <class Index>
class EachIndex : public testing::Test {};
using Indices = testing::Types<BruteForce, Bvh2, Bvh8>;
TYPED_TEST_SUITE(EachIndex, Indices);

template <class Index>
class EachTree : public testing::Test {};
using Trees = testing::Types<Bvh2, Bvh8>;
TYPED_TEST_SUITE(EachTree, Trees);

TYPED_TEST(EachIndex, GivesTheSameHitsWithALogOnEveryInstructionSet) {
    const auto geometry = scene<TypeParam>();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        Random random(2);
        for (int i = 0; i < 1000; ++i) {
            Ray r = randomRay(random);
            TraversalLog log;
            const auto hit = closestHit(geometry, r);
            ASSERT_TRUE(same(closestHit(geometry, r, RayMask::All, log), hit)) << i;
            if (hit && i % 2 == 0) r.tMax = hit->t * static_cast<float>(random.uniform(0.5, 1.5));
            ASSERT_EQ(anyHit(geometry, r, RayMask::All, log), anyHit(geometry, r)) << i;
        }
    }
    hwy::SetSupportedTargetsForTest(0);
}

TYPED_TEST(EachIndex, CountsAloneAreThoseOfAWholeLog) {
    const auto geometry = scene<TypeParam>();
    Random random(3);
    TraversalLog counts{.countsOnly = true, .counts = {}, .boxes = {}, .primitives = {}}, whole;
    for (int i = 0; i < 500; ++i) {
        const Ray r = randomRay(random);
        closestHit(geometry, r, RayMask::All, counts);
        closestHit(geometry, r, RayMask::All, whole);
    }
    EXPECT_EQ(counts.counts, whole.counts);
    EXPECT_EQ(whole.counts.primitives, whole.primitives.size());
    EXPECT_TRUE(counts.boxes.empty() && counts.primitives.empty());
}

TEST(BruteForceLog, HasEveryPrimitiveForEveryRayAndNothingElse) {
    const auto geometry = scene<BruteForce>();
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        TraversalLog log;
        closestHit(geometry, randomRay(random), RayMask::All, log);
        EXPECT_EQ(log.counts, (TraversalCounts{0, 0, geometry.primitives}));
    }
}

TYPED_TEST(EachTree, GoesIntoFewerNodesThanThereAreAndTestsFewerPrimitives) {
    const auto geometry = scene<TypeParam>();
    Random random(5);
    TraversalCounts sum;
    constexpr std::uint64_t kRays = 1000;
    for (std::uint64_t i = 0; i < kRays; ++i) {
        TraversalLog log;
        closestHit(geometry, randomRay(random), RayMask::All, log);
        EXPECT_LE(log.counts.nodes, nodesOf(geometry));
        EXPECT_LE(log.counts.primitives, geometry.primitives);
        sum += log.counts;
    }
    EXPECT_GT(sum.nodes, kRays);
    EXPECT_LT(sum.primitives, kRays * geometry.primitives / 20);
}

TYPED_TEST(EachTree, TestsThePrimitiveThatIsHit) {
    const auto geometry = scene<TypeParam>();
    Random random(6);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        TraversalLog log;
        const auto hit = closestHit(geometry, randomRay(random), RayMask::All, log);
        if (!hit) continue;
        ++hits;
        const bool shape = std::holds_alternative<Shape>(geometry.instances[hit->instance].geometry);
        EXPECT_TRUE(std::ranges::any_of(log.primitives, [&](const PrimitiveTest& test) {
            return test.instance == hit->instance && (shape || test.primitive == hit->primitive);
        }));
    }
    EXPECT_GT(hits, 300);
}

TYPED_TEST(EachTree, OfARayThatMeetsNothingHasNoPrimitive) {
    const auto geometry = cases::geometryOf<TypeParam>(cases::shared(cases::closedMesh(20, 24, 0.5)));
    TraversalLog log;
    EXPECT_FALSE(closestHit(geometry, ray({0, 5, 0}, {1, 0, 0}), RayMask::All, log));
    EXPECT_EQ(log.counts.primitives, 0U);
    EXPECT_GE(log.counts.boxes, 1U) << "the box around it all";
    for (const BoxTests& tests : log.boxes) EXPECT_EQ(tests.met, 0U);
}

TEST(Bvh8, GoesFirstToTheFarEndWhereAnyHitIsAsGood) {
    std::vector<Instance<Bvh8>> row;
    row.reserve(8);
    for (int i = 0; i < 8; ++i)
        row.push_back(place<Bvh8>(glm::translate(DMat4(1), DVec3(3 * i, 0, 0)), Shape(Sphere{1})));
    const auto geometry = indexInstances<Bvh8>(std::move(row), {});
    const auto firstTested = [&](const Ray& r) {
        TraversalLog log;
        EXPECT_TRUE(anyHit(geometry, r, RayMask::All, log));
        return log.primitives.front().instance;
    };
    EXPECT_EQ(firstTested(ray({-5, 0, 0}, {1, 0, 0})), 7U);
    EXPECT_EQ(firstTested(ray({26, 0, 0}, {-1, 0, 0})), 0U);
}

TEST(Bvh8, KnowsHowManyChildrenANodeHas) {
    for (const int count : {1, 3, 8}) {
        std::vector<Bounds> boxes;
        boxes.reserve(8);
        for (int i = 0; i < count; ++i) boxes.push_back({Vec3(DVec3(i)), Vec3(DVec3(i + 1))});
        EXPECT_EQ(Bvh8::childrenOf(Bvh8(boxes, 1, {}).nodes()[0]), static_cast<unsigned>(count));
    }
}

}
}
