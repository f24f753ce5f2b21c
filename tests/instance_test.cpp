// labels: unit
// Placed objects: rays are not renormalised (stability F21), normals go by the inverse transpose (F22),
// mirrors keep the front in front, boxes and error bounds hold the truth.

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;

IndexedGeometry<Bvh2> sceneOf(const DMat4& map, const Shape& shape) {
    return indexInstances<Bvh2>({place<Bvh2>(map, shape)}, {});
}

TEST(Instance, TMeansTheSameInBothSpaces) {
    const DMat4 small = glm::scale(DMat4(1), DVec3(0.1));
    const auto scene = indexInstances<Bvh2>(
        {place<Bvh2>(small, Shape(Sphere{1})),
         place<Bvh2>(glm::translate(DMat4(1), DVec3(0, 0, -1)), Shape(Box{Vec3(9, 9, 0.5F)}))},
        {});
    const auto hit = closestHit(scene, ray({0, 0, 5}, {0, 0, -1}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 0U) << "a renormalised ray would put it at 49, behind the wall";
    EXPECT_NEAR(hit->t, 4.9, 1e-6);
}

TEST(Instance, PlacedMeshIsTheSameAsTheBakedOne) {
    Random random(1);
    const TriangleMesh mesh = cases::closedMesh(20, 30, 1, 0.3);
    for (int k = 0; k < 10; ++k) {
        const DMat4 map = cases::randomPlacement(random, 1);
        TriangleMesh baked = mesh;
        for (Vec3& p : baked.positions) p = Vec3(transformPoint(map, DVec3(p)));
        const auto placed =
            indexInstances<Bvh2>({place<Bvh2>(map, indexMesh<Bvh2>(cases::shared(mesh), {}))}, {});
        const auto direct = cases::geometryOf<Bvh2>(cases::shared(baked));
        int hits = 0, differ = 0;
        for (int i = 0; i < 5000; ++i) {
            const DVec3 origin = 6.0 * random.direction();
            const Ray r = ray(origin, transformPoint(map, random.inCube(0.8)) - origin);
            const auto a = closestHit(placed, r), b = closestHit(direct, r);
            if (!a || !b || a->primitive != b->primitive) {
                differ += a.has_value() != b.has_value() || (a && a->primitive != b->primitive) ? 1 : 0;
                continue;
            }
            ++hits;
            EXPECT_NEAR(a->t, b->t, 1e-5);
            const SurfacePoint p = surfaceAt(placed, r, *a), q = surfaceAt(direct, r, *b);
            EXPECT_LT(glm::length(p.position - q.position), 1e-4F);
            EXPECT_LT(glm::length(p.geometricNormal - q.geometricNormal), 1e-4F);
        }
        EXPECT_GT(hits, 4000);
        EXPECT_LE(differ, 5) << "rays through an edge";
    }
}

TEST(Instance, NormalOfASquashedSphereIsThatOfTheEllipsoid) {
    Random random(2);
    for (const double squash : {0.5, 0.1, 0.01}) {
        const DVec3 axes(1, 1, squash);
        const auto scene = sceneOf(glm::scale(DMat4(1), axes), Sphere{1});
        for (int i = 0; i < 5000; ++i) {
            const DVec3 target = random.inCube(0.5) * axes;
            const Ray r = ray(target + 5.0 * random.direction(), DVec3(0));
            const Ray aimed = ray(DVec3(r.origin), target - DVec3(r.origin));
            const auto hit = closestHit(scene, aimed);
            ASSERT_TRUE(hit);
            const SurfacePoint point = surfaceAt(scene, aimed, *hit);
            const DVec3 p(point.position), gradient = p / (axes * axes);
            ASSERT_LT(glm::length(DVec3(point.geometricNormal) - glm::normalize(gradient)), 1e-4);
            ASSERT_NEAR(glm::dot(p / axes, p / axes), 1, 1e-5);
        }
    }
    // The figure of the lecture: at 45° on (1, 1, 0.1) the map itself, used for the normal, is 78.58° wrong.
    const DMat4 map = glm::scale(DMat4(1), DVec3(1, 1, 0.1));
    SurfacePoint point;
    point.geometricNormal = point.shadingNormal = glm::normalize(Vec3(1, 0, 1));
    const Vec3 right = Placement(map).toWorld(point).geometricNormal;
    const Vec3 wrong = glm::normalize(Vec3(transformVector(map, point.geometricNormal)));
    EXPECT_NEAR(degrees(std::acos(glm::dot(DVec3(right), DVec3(wrong)))), 78.58, 0.01);
}

TEST(Instance, MirroringKeepsTheOwnSideOutward) {
    const DMat4 mirror = glm::scale(DMat4(1), DVec3(-1, 1, 1));
    TriangleMesh mesh = cases::closedMesh(10, 12, 1);
    mesh.doubleSided = false;
    const auto body =
        indexInstances<Bvh2>({place<Bvh2>(mirror, indexMesh<Bvh2>(cases::shared(mesh), {}))}, {});
    const auto ball = sceneOf(mirror, Sphere{1});
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const DVec3 origin = 3.0 * random.direction();
        const Ray r = ray(origin, -origin);
        for (const auto* scene : {&body, &ball}) {
            const auto hit = closestHit(*scene, r);
            ASSERT_TRUE(hit);
            ASSERT_LT(hit->t, 1) << "the outside is the front: what faces the ray is hit, not the far inside";
            ASSERT_LT(glm::dot(surfaceAt(*scene, r, *hit).geometricNormal, r.direction), 0);
        }
        EXPECT_FALSE(closestHit(body, ray(DVec3(0), origin))) << "from inside the back is not there";
    }
}

TEST(Instance, BoundsHoldWhatTheMapMakesOfTheBox) {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Affine map =
            Affine::from(cases::randomPlacement(random, std::pow(10, random.uniform(-3, 3)), 0.01, 3));
        const Bounds box{Vec3(-random.inCube(1) - DVec3(1)), Vec3(random.inCube(1) + DVec3(1))};
        const Bounds mapped = boundsOf(map, box);
        const double size = glm::length(DVec3(mapped.extent()));
        Bounds exact;
        for (int corner = 0; corner < 8; ++corner) {
            const DVec3 p((corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                          (corner & 4) != 0 ? box.hi.z : box.lo.z);
            const DVec3 q = DMat3(map.linear) * p + DVec3(map.translation);
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_LE(mapped.lo[axis], q[axis]);
                ASSERT_GE(mapped.hi[axis], q[axis]);
            }
            exact.add(Vec3(q));
        }
        EXPECT_LT(glm::length(DVec3(mapped.lo - exact.lo)),
                  1e-6 * size + 1e-5 * glm::length(map.translation));
    }
    EXPECT_TRUE(boundsOf(Affine{}, Bounds{}).empty());
}

// The true place of the point is that which the exact inverse of the ray's map would bring to it.
TEST(Instance, ErrorBoundHoldsTheRoundingOfBothMaps) {
    Random random(5);
    double worst = 0;
    for (int i = 0; i < 50'000; ++i) {
        const double size = std::pow(10, random.uniform(-3, 3));
        const DMat4 map = cases::randomPlacement(random, size, 0.01, 3);
        const Placement placement(map);
        const SurfacePoint local = surfacePoint(random.inCube(1), random.direction());
        const SurfacePoint world = placement.toWorld(local);
        const DVec3 error =
            transformVector(map, DVec3(placement.toObject(world.position)) - DVec3(local.position));
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(std::fabs(error[axis]), world.error[axis]);
            worst = std::fmax(worst, std::fabs(error[axis]) / world.error[axis]);
        }
    }
    EXPECT_GT(worst, 0.1) << "a bound ten times too wide would be a bad one";
}

}
}
