// labels: unit
// Scenes through every index, the wide one with every instruction set: same hits, same bits; ties, masks,
// unbounded planes.

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"
#include "tests/instruction_sets.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;

/// Meshes and shapes of the order of `size`, some meshes placed twice, some objects transparent.
template <class Index>
IndexedGeometry<Index> mixedScene(double size, std::uint32_t seed) {
    Random random(seed);
    const auto body = indexMesh<Index>(cases::shared(cases::closedMesh(12, 16, 0.5, 0.3)), {});
    const auto soup = indexMesh<Index>(cases::shared(cases::triangleSoup(random, 200, 0.5)), {});
    TriangleMesh oneSided = cases::closedMesh(5, 7, 0.4);
    oneSided.doubleSided = false;
    const auto shell = indexMesh<Index>(cases::shared(oneSided), {});
    std::vector<Instance<Index>> instances;
    for (int i = 0; i < 4; ++i) {
        const auto add = [&](const auto& geometry) {
            instances.push_back(place<Index>(cases::randomPlacement(random, size), geometry));
            instances.back().mask = random.below(3) == 0 ? RayMask::Transparent : RayMask::Opaque;
        };
        add(body);
        add(soup);
        add(shell);
        add(Shape(Sphere{0.5F}));
        add(Shape(Box{Vec3(1, 0.5F, 0.7F)}));
        add(Shape(Cylinder{1, 0.4F, 0.4F}));
        add(Shape(Cylinder{1, 0, 0.4F}));
        add(Shape(Plane{1, 1, i % 2 == 0}));
    }
    instances.push_back(place<Index>(glm::translate(DMat4(1), DVec3(0, -2 * size, 0)), Shape(Plane{})));
    return indexInstances<Index>(std::move(instances), {});
}

Ray randomRay(Random& random, double size) {
    return ray(random.inCube(4 * size), random.inCube(2 * size) - random.inCube(2 * size));
}

void expectSame(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->t, b->t);
    EXPECT_EQ(a->u, b->u);
    EXPECT_EQ(a->v, b->v);
    EXPECT_EQ(a->primitive, b->primitive);
    EXPECT_EQ(a->instance, b->instance);
}

template <class Index>
class EachIndex : public testing::Test {};
using Indices = testing::Types<BruteForce, Bvh2, Bvh8>;
TYPED_TEST_SUITE(EachIndex, Indices);

template <class Index>
class EachTree : public testing::Test {};
using Trees = testing::Types<Bvh2, Bvh8>;
TYPED_TEST_SUITE(EachTree, Trees);

template <class Index>
void expectTheHitsOfBruteForce() {
    for (const double size : {1e-3, 1.0, 1e3}) {
        const auto tree = mixedScene<Index>(size, 1);
        const auto all = mixedScene<BruteForce>(size, 1);
        Random random(2);
        int hits = 0;
        for (int i = 0; i < 4'000; ++i) {
            const Ray r = randomRay(random, size);
            for (const RayMask mask : {RayMask::All, RayMask::Opaque, RayMask::Transparent}) {
                const auto hit = closestHit(tree, r, mask);
                expectSame(hit, closestHit(all, r, mask));
                EXPECT_EQ(anyHit(tree, r, mask), hit.has_value());
                EXPECT_EQ(anyHit(all, r, mask), hit.has_value());
                EXPECT_TRUE(!hit || mask == RayMask::All || tree.instances[hit->instance].mask == mask);
            }
            hits += closestHit(tree, r) ? 1 : 0;
            if (testing::Test::HasFailure()) FAIL() << "size " << size << ", ray " << i;
        }
        EXPECT_GT(hits, 1'200);
    }
}

TYPED_TEST(EachTree, FindsTheHitsOfBruteForceBitForBit) {
    withEachInstructionSet([] { expectTheHitsOfBruteForce<TypeParam>(); });
}

TYPED_TEST(EachTree, AgreesOnRaysThatEndBeforeOrBeginAfterTheHit) {
    const auto tree = mixedScene<TypeParam>(1, 3);
    const auto all = mixedScene<BruteForce>(1, 3);
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        Ray r = randomRay(random, 1);
        const auto hit = closestHit(tree, r);
        if (!hit) continue;
        r.tMax = hit->t;
        EXPECT_FALSE(closestHit(tree, r));
        EXPECT_FALSE(anyHit(tree, r));
        r = {.origin = r.origin, .direction = r.direction, .tMin = hit->t};
        const auto behind = closestHit(tree, r);
        expectSame(behind, closestHit(all, r));
        EXPECT_EQ(anyHit(tree, r), behind.has_value());
        EXPECT_TRUE(!behind || behind->t > hit->t);
        if (testing::Test::HasFailure()) FAIL() << i;
    }
}

TYPED_TEST(EachIndex, FindsTheNearestOfAllObjects) {
    std::vector<Instance<TypeParam>> row;
    for (const double z : {-7.0, -3.0, -5.0})
        row.push_back(place<TypeParam>(glm::translate(DMat4(1), DVec3(0, 0, z)), Shape(Sphere{1})));
    const auto scene = indexInstances<TypeParam>(row, {});
    const auto hit = closestHit(scene, ray({0, 0, 0}, {0, 0, -1}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 1U);
    EXPECT_EQ(hit->t, 2);
}

template <class Index>
void expectLowerIdWins(const std::vector<Shape>& shapes, const DMat4& placement) {
    Random random(5);
    for (int order = 0; order < 4; ++order) {
        std::vector<Instance<Index>> instances(shapes.size());
        std::ranges::transform(shapes, instances.begin(),
                               [&](const Shape& shape) { return place<Index>(placement, shape); });
        // Others before, beside and behind, so that the tree is another one each time.
        for (int i = 0; i < order * 5; ++i)
            instances.push_back(place<Index>(glm::translate(DMat4(1), random.inCube(9) - DVec3(0, 0, 30)),
                                             Shape(Sphere{0.5F})));
        const auto scene = indexInstances<Index>(instances, {});
        int hits = 0;
        for (int i = 0; i < 500; ++i) {
            const auto hit = closestHit(
                scene, ray(random.inCube(1) + DVec3(0, 0, 6), random.inCube(0.4) - DVec3(0, 0, 6)));
            if (!hit || hit->instance >= shapes.size()) continue;
            ++hits;
            ASSERT_EQ(hit->instance, 0U);
        }
        EXPECT_GT(hits, 100);
    }
}

TYPED_TEST(EachIndex, TakesTheLowerIdOfCoincidentSurfaces) {
    const DMat4 turned = glm::rotate(DMat4(1), 1.4, glm::normalize(DVec3(1, 0.1, 0.2)));
    const Shape sheet = Plane{9, 9, true}, ball = Sphere{1}, endless = Plane{.doubleSided = true};
    for (const auto& pair :
         {std::vector{sheet, sheet, sheet}, {ball, ball}, {endless, sheet}, {sheet, endless}}) {
        expectLowerIdWins<TypeParam>(pair, turned);
    }
}

TYPED_TEST(EachIndex, TakesTheLowerIdOfCoincidentTriangles) {
    TriangleMesh mesh;
    mesh.positions = {Vec3(-1, -1, 0), Vec3(1, -1, 0.3F), Vec3(0, 1, 0.1F)};
    mesh.triangles.assign(50, {0, 1, 2});
    Random random(6);
    const auto tree = cases::geometryOf<TypeParam>(cases::shared(mesh));
    for (int i = 0; i < 1000; ++i) {
        const auto hit = closestHit(tree, ray(random.inCube(0.2) + DVec3(0, 0, 3), {0, 0, -1}));
        ASSERT_TRUE(hit);
        ASSERT_EQ(hit->primitive, 0U);
    }
}

TYPED_TEST(EachIndex, IgnoresTrianglesWithoutAreaAndKeepsTheOthersNumbers) {
    Random random(7);
    const TriangleMesh mesh = cases::closedMesh(8, 8, 1);
    TriangleMesh dirty = mesh;
    const auto first = static_cast<std::uint32_t>(dirty.positions.size());
    dirty.positions.insert(dirty.positions.end(), {Vec3(std::nanf("")), Vec3(kInfinity, 0, 0)});
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const std::uint32_t a = i % first, b = (i * 7) % first;
        dirty.triangles.push_back(i % 3 == 0 ? std::array{a, b, b} : std::array{a, b, first + i % 2});
    }
    const auto clean = cases::geometryOf<TypeParam>(cases::shared(mesh));
    const auto tree = cases::geometryOf<TypeParam>(cases::shared(dirty));
    EXPECT_EQ(tree.primitives, mesh.triangles.size());
    for (int i = 0; i < 2000; ++i) {
        const Ray r = ray(random.inCube(2), random.direction());
        expectSame(closestHit(tree, r), closestHit(clean, r));
    }
}

TYPED_TEST(EachIndex, WithNothingInItIsNotHit) {
    const auto nothing = indexInstances<TypeParam>({}, {});
    EXPECT_FALSE(closestHit(nothing, ray({0, 0, 0}, {0, 0, -1})));
    EXPECT_FALSE(anyHit(nothing, ray({0, 0, 0}, {0, 0, -1})));
    const auto emptyMesh = cases::geometryOf<TypeParam>(cases::shared(TriangleMesh{}));
    EXPECT_FALSE(closestHit(emptyMesh, ray({0, 0, 0}, {0, 0, -1})));
    EXPECT_EQ(emptyMesh.primitives, 0U);
}

TYPED_TEST(EachIndex, WithAMapThatIsNoMapIsNotHit) {
    std::vector<Instance<TypeParam>> instances;
    instances.push_back(place<TypeParam>(DMat4(0), Shape(Sphere{1})));
    instances.push_back(place<TypeParam>(DMat4(std::nan("")), Shape(Box{})));
    instances.push_back(place<TypeParam>(DMat4(0), Shape(Plane{})));
    const auto scene = indexInstances<TypeParam>(instances, {});
    EXPECT_FALSE(closestHit(scene, ray({0, 5, 5}, {0, -1, -1})));
}

TEST(Geometry, CountsTrianglesAndShapesPerInstanceAndBytesPerMesh) {
    const auto mesh = indexMesh<Bvh2>(cases::shared(cases::closedMesh(8, 8, 1)), {});
    const auto one = indexInstances<Bvh2>({place<Bvh2>(DMat4(1), mesh)}, {});
    const auto many = indexInstances<Bvh2>(
        {place<Bvh2>(DMat4(1), mesh), place<Bvh2>(DMat4(1), mesh), place<Bvh2>(DMat4(1), Shape(Sphere{}))},
        {});
    EXPECT_EQ(one.primitives, 112U);
    EXPECT_EQ(many.primitives, 2 * 112U + 1);
    EXPECT_LT(many.bytes, one.bytes + 200);
    EXPECT_EQ(many.nodes, one.nodes + 5) << "a single object needs no tree above it";
}

TYPED_TEST(EachTree, StoppedWhileBuiltIsEmpty) {
    const std::stop_source stop;
    stop.request_stop();
    const auto mesh = indexMesh<TypeParam>(cases::shared(cases::closedMesh(8, 8, 1)), stop.get_token());
    EXPECT_EQ(mesh->index.nodeCount(), 0U);
    EXPECT_TRUE(mesh->triangles.bytes() == 0);
}

}
}
