// labels: unit
// The index as boxes in space: every level holds the next, and what a ray is tested against is what a plain
// slab test in double says it must be.

#include <gtest/gtest.h>

#include "core/study/index_picture.h"
#include "core/study/ray_traversal.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;
using cases::Random;
using Role = SpaceBox::Role;

/// Two meshes placed several times, turned and stretched, among balls.
Scene crowd() {
    Scene scene = underSky(Color(0.4F));
    Random random(1);
    for (int i = 0; i < 4; ++i) {
        add(scene, cases::closedMesh(12, 16, 0.5, 0.3), matte(Color(0.5F)),
            cases::randomPlacement(random, 1));
        add(scene, cases::triangleSoup(random, 60, 0.5), matte(Color(0.5F)),
            cases::randomPlacement(random, 1));
        add(scene, Sphere{0.5F}, matte(Color(0.5F)), cases::randomPlacement(random, 1));
    }
    look(scene, {0, 0, 9}, {0, 0, 0});
    return scene;
}

std::shared_ptr<const World> worldOf(const Scene& scene, AccelKind kind) {
    return buildWorld(std::make_shared<const Scene>(scene), {kind});
}

/// True if a point lies in a box whose edges may be turned, but for rounding.
bool contains(const SpaceBox& box, const Vec3& point) {
    const DVec3 origin(box.corners[0]), p = DVec3(point) - origin;
    for (const std::size_t i : {1U, 2U, 4U}) {
        const DVec3 edge = DVec3(box.corners[i]) - origin;
        // distances from the two faces that this edge joins
        const DVec3 other1 = DVec3(box.corners[i == 1 ? 2 : 1]) - origin,
                    other2 = DVec3(box.corners[i == 4 ? 2 : 4]) - origin;
        const DVec3 normal = glm::cross(other1, other2);
        const double length = glm::length(normal);
        if (!(length > 0)) continue;
        const double along = glm::dot(p, normal) / length, whole = glm::dot(edge, normal) / length;
        if (along < std::min(0.0, whole) - 1e-5 || along > std::max(0.0, whole) + 1e-5) return false;
    }
    return true;
}

bool contains(const SpaceBox& outer, const SpaceBox& inner) {
    return std::ranges::all_of(inner.corners, [&](const Vec3& corner) { return contains(outer, corner); });
}

class EachTree : public testing::TestWithParam<AccelKind> {};
INSTANTIATE_TEST_SUITE_P(Trees, EachTree, testing::Values(AccelKind::Bvh2, AccelKind::Bvh8));

TEST_P(EachTree, EveryBoxOfALevelLiesInOneOfTheLevelAbove) {
    const auto world = worldOf(crowd(), GetParam());
    const int levels = levelsOf(*world);
    ASSERT_GT(levels, 2);
    EXPECT_EQ(boxesOfLevel(*world, 0).boxes.size(), 1U);
    std::size_t ofMeshes = 0;
    for (int level = 1; level < levels; ++level) {
        const IndexPicture above = boxesOfLevel(*world, level - 1), here = boxesOfLevel(*world, level);
        ASSERT_EQ(above.leftOut + here.leftOut, 0U);
        ASSERT_FALSE(here.boxes.empty());
        for (const SpaceBox& box : here.boxes) {
            ofMeshes += box.role == Role::Mesh ? 1U : 0U;
            EXPECT_TRUE(std::ranges::any_of(above.boxes, [&](const SpaceBox& o) { return contains(o, box); }))
                << "level " << level;
        }
    }
    EXPECT_GT(ofMeshes, 40U);
    EXPECT_TRUE(boxesOfLevel(*world, levels).boxes.empty());
}

TEST_P(EachTree, LevelZeroHoldsEveryVertex) {
    const auto world = worldOf(crowd(), GetParam());
    const SpaceBox all = boxesOfLevel(*world, 0).boxes.front();
    for (const Object& object : world->scene->objects) {
        const auto* mesh = std::get_if<MeshId>(&object.geometry);
        if (mesh == nullptr) continue;
        for (const Vec3& p : world->scene->meshes[static_cast<std::size_t>(mesh->index)].triangles->positions)
            ASSERT_TRUE(contains(all, Vec3(DVec3(object.transform * DVec4(DVec3(p), 1)) - world->origin)));
    }
}

TEST_P(EachTree, OfOneObjectBeginsWithTheTreeOfItsMesh) {
    Scene scene = underSky(Color(0.4F));
    add(scene, cases::closedMesh(12, 16, 0.5, 0.3), matte(Color(0.5F)));
    const auto world = worldOf(scene, GetParam());
    const IndexPicture root = boxesOfLevel(*world, 0);
    ASSERT_EQ(root.boxes.size(), 1U);
    EXPECT_EQ(root.boxes.front().role, Role::Mesh);
}

/// Whether a ray passes a box between 0 and tMax, by slabs in double along the box's own axes.
bool passes(const SpaceBox& box, const Ray& ray, double tMax) {
    const DVec3 origin(box.corners[0]);
    const DMat3 edges(DVec3(box.corners[1]) - origin, DVec3(box.corners[2]) - origin,
                      DVec3(box.corners[4]) - origin);
    const DMat3 inverse = glm::inverse(edges); // to the unit cube
    const DVec3 o = inverse * (DVec3(ray.origin) - origin), d = inverse * DVec3(ray.direction);
    double in = 0, out = tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = -o[axis] / d[axis], b = (1 - o[axis]) / d[axis];
        in = std::fmax(in, std::fmin(a, b));
        out = std::fmin(out, std::fmax(a, b));
    }
    return in < out - 1e-5;
}

/// True for the box around a mesh's tree of eight, which is not tested by itself: its leaf above was.
bool isRootOfEight(const World& world, const SpaceBox& box) {
    const auto* geometry = std::get_if<IndexedGeometry<Bvh8>>(world.accel.get());
    if (geometry == nullptr) return false;
    return std::ranges::any_of(geometry->instances, [&](const Instance<Bvh8>& instance) {
        const auto* mesh = std::get_if<1>(&instance.geometry);
        return mesh != nullptr && box.corners[0] == instance.placement.toWorld((*mesh)->index.bounds().lo) &&
               box.corners[7] == instance.placement.toWorld((*mesh)->index.bounds().hi);
    });
}

TEST_P(EachTree, EveryBoxThatARayPassesBeforeItsHitIsAmongThoseMet) {
    const auto world = worldOf(crowd(), GetParam());
    const int levels = levelsOf(*world);
    Random random(2);
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        SampleRecord record;
        record.rays.push_back({.origin = Vec3(random.inCube(4)), .direction = Vec3(random.direction())});
        const RayRecord& ray = record.rays.front();
        TraversalLog log;
        logTraversal(*world, TraceSettings{}, record, 0, log);
        const auto hit = std::visit(
            [&](const auto& geometry) { return closestHit(geometry, Ray{ray.origin, ray.direction}); },
            *world->accel);
        const double end = hit ? static_cast<double>(hit->t) : 1e3;
        const Ray plain{ray.origin, ray.direction};
        const IndexPicture tested = pictureOf(*world, log);
        ASSERT_EQ(tested.leftOut, 0U);
        const auto drawn = [&](const SpaceBox& box, Role role) {
            return std::ranges::any_of(tested.boxes, [&](const SpaceBox& other) {
                return other.role == role && other.corners == box.corners;
            });
        };
        for (int level = 1; level < levels; ++level)
            for (const SpaceBox& box : boxesOfLevel(*world, level).boxes) {
                if (!passes(box, plain, end) || isRootOfEight(*world, box)) continue;
                ++met;
                EXPECT_TRUE(drawn(box, Role::Met));
                EXPECT_FALSE(drawn(box, Role::Missed));
            }
    }
    EXPECT_GT(met, 100);
}

TEST_P(EachTree, DrawsEveryTriangleAndShapeThatIsTested) {
    const auto world = worldOf(crowd(), GetParam());
    const Tracing tracing(world, toDepth(1), 32, 32);
    std::size_t triangles = 0, shapes = 0;
    for (int i = 0; i < 32; ++i) {
        const Retrace trace = tracing.retrace(i, i);
        TraversalLog log;
        logTraversal(*world, TraceSettings{}, trace, 0, log);
        const IndexPicture tested = pictureOf(*world, log);
        const auto boxes =
            static_cast<std::size_t>(std::ranges::count(tested.boxes, Role::Tested, &SpaceBox::role));
        EXPECT_EQ(tested.triangles.size() + boxes, log.counts.primitives);
        EXPECT_EQ(tested.boxes.size() - boxes, log.counts.boxes);
        triangles += tested.triangles.size();
        shapes += boxes;
    }
    EXPECT_GT(triangles, 20U);
    EXPECT_GT(shapes, 0U);
}

TEST(IndexPicture, WithoutAnIndexHasPrimitivesAloneAndNoLevel) {
    const auto world = worldOf(crowd(), AccelKind::Brute);
    EXPECT_EQ(levelsOf(*world), 0);
    EXPECT_TRUE(boxesOfLevel(*world, 0).boxes.empty());
    const Tracing tracing(world, toDepth(0));
    TraversalLog log;
    logTraversal(*world, TraceSettings{}, tracing.retrace(), 0, log);
    const IndexPicture tested = pictureOf(*world, log);
    EXPECT_EQ(tested.boxes.size(), 4U) << "the balls";
    EXPECT_EQ(tested.triangles.size() + tested.leftOut + 4, world->primitives);
}

TEST(IndexPicture, LeavesOutSomeOfVeryManyBoxesAndSaysSo) {
    Scene scene = underSky(Color(0.4F));
    Random random(3);
    add(scene, cases::triangleSoup(random, 20'000, 1), matte(Color(0.5F)));
    const auto world = worldOf(scene, AccelKind::Bvh8);
    bool cut = false;
    for (int level = levelsOf(*world) - 1; level > 0; --level) {
        const IndexPicture picture = boxesOfLevel(*world, level);
        EXPECT_LE(picture.boxes.size(), kMostIndexBoxes);
        cut |= picture.leftOut > 0;
    }
    EXPECT_TRUE(cut) << "some level has more";
}

}
}
