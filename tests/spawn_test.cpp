// labels: unit
// Rays that leave a surface do not meet it again through rounding, and those that enter a solid meet its
// other side (stability F04 to F06): every shape, rotated and scaled unevenly, small and large, near and far.

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;
using Scene = IndexedGeometry<Bvh2>;

struct Counts {
    int spawned = 0, back = 0, lost = 0;
};

Vec3 mirrored(const Vec3& d, const Vec3& n) { return d - 2.0F * glm::dot(d, n) * n; }

/// Direction on the other side of the surface, for a medium 1.5 times as dense.
Vec3 refracted(const Vec3& direction, const Vec3& n) {
    const DVec3 d = glm::normalize(DVec3(direction)), normal(n);
    const double cosine = -glm::dot(d, normal), eta = 1 / 1.5;
    return Vec3(eta * d + (eta * cosine - std::sqrt(1 - eta * eta * (1 - cosine * cosine))) * normal);
}

// A surface met again through rounding is met at once; the other sides of the object may be near, but are
// another face or far away.
bool meetsSameFace(const Scene& scene, const Vec3& origin, const Vec3& direction, const Hit& from,
                   float near) {
    const auto again = closestHit(scene, {.origin = origin, .direction = direction});
    return again && again->instance == from.instance && again->primitive == from.primitive &&
           again->t * glm::length(direction) < near;
}

/// Rays from a distance of `distance` sizes at one placed object: how many mirrored rays meet the object
/// again and how many refracted ones do not find the way out of a convex solid.
Counts spawnAround(const Shape& shape, double size, double distance, int placements, int rays) {
    Random random(1);
    Counts counts;
    for (int k = 0; k < placements; ++k) {
        const DMat4 map = cases::randomPlacement(random, size, 0.1, 2);
        const Scene scene = indexInstances<Bvh2>({place<Bvh2>(map, shape)}, {});
        const auto near = static_cast<float>(1e-4 * size);
        for (int i = 0; i < rays; ++i) {
            const DVec3 target = transformPoint(map, random.inCube(0.6));
            const Ray eye = ray(target + distance * size * random.direction(), DVec3(0));
            const Ray aimed = ray(DVec3(eye.origin), glm::normalize(target - DVec3(eye.origin)));
            const auto hit = closestHit(scene, aimed);
            if (!hit) continue;
            const SurfacePoint point = surfaceAt(scene, aimed, *hit);
            const Vec3 facing = glm::dot(point.geometricNormal, aimed.direction) < 0 ? point.geometricNormal
                                                                                     : -point.geometricNormal;
            ++counts.spawned;
            const Vec3 up = mirrored(aimed.direction, facing), down = refracted(aimed.direction, facing);
            const Vec3 outside = spawnOrigin(point, up), inside = spawnOrigin(point, down);
            if (isSolid(shape) && anyHit(scene, {.origin = outside, .direction = up})) ++counts.back;
            if (meetsSameFace(scene, outside, up, *hit, near)) ++counts.back;
            if (meetsSameFace(scene, inside, down, *hit, near)) ++counts.back;
            if (isSolid(shape) && !closestHit(scene, {.origin = inside, .direction = down})) ++counts.lost;
        }
    }
    return counts;
}

void expectClean(const Shape& shape) {
    int spawned = 0;
    for (const double size : {1e-3, 1.0, 1e3})
        for (const double distance : {5.0, 1e3}) {
            const Counts counts = spawnAround(shape, size, distance, 20, 1500);
            EXPECT_EQ(counts.back, 0) << "size " << size << ", distance " << distance;
            EXPECT_EQ(counts.lost, 0) << "size " << size << ", distance " << distance;
            spawned += counts.spawned;
        }
    EXPECT_GT(spawned, 50'000) << "each stands for a mirrored and a refracted ray";
}

TEST(SpawnedRay, LeavesASphere) { expectClean(Sphere{0.5F}); }
TEST(SpawnedRay, LeavesABox) { expectClean(Box{Vec3(1, 0.7F, 1.3F)}); }
TEST(SpawnedRay, LeavesACylinder) { expectClean(Cylinder{1, 0.5F, 0.5F}); }
TEST(SpawnedRay, LeavesACone) { expectClean(Cylinder{1, 0, 0.7F}); }
TEST(SpawnedRay, LeavesACappedCone) { expectClean(Cylinder{1, 0.3F, 0.7F}); }
TEST(SpawnedRay, LeavesARectangle) { expectClean(Plane{2, 2, true}); }
TEST(SpawnedRay, LeavesAnEndlessPlane) { expectClean(Plane{.doubleSided = true}); }

TEST(SpawnedRay, LeavesTheTrianglesOfAMesh) {
    Random random(2);
    const auto mesh = indexMesh<Bvh2>(cases::shared(cases::closedMesh(24, 32, 0.5)), {});
    int spawned = 0;
    for (const double size : {1e-3, 1.0, 1e3})
        for (const double distance : {5.0, 1e3})
            for (int k = 0; k < 10; ++k) {
                const DMat4 map = cases::randomPlacement(random, size, 0.1, 2);
                const Scene scene = indexInstances<Bvh2>({place<Bvh2>(map, mesh)}, {});
                int lost = 0, back = 0;
                for (int i = 0; i < 2000; ++i) {
                    const DVec3 target = transformPoint(map, random.inCube(0.25));
                    const Ray eye = ray(target + distance * size * random.direction(), DVec3(0));
                    const Ray aimed = ray(DVec3(eye.origin), glm::normalize(target - DVec3(eye.origin)));
                    const auto hit = closestHit(scene, aimed);
                    ASSERT_TRUE(hit);
                    const SurfacePoint point = surfaceAt(scene, aimed, *hit);
                    const Vec3 up = mirrored(aimed.direction, point.geometricNormal);
                    const Vec3 down = refracted(aimed.direction, point.geometricNormal);
                    back += anyHit(scene, {.origin = spawnOrigin(point, up), .direction = up}) ? 1 : 0;
                    const Ray within{.origin = spawnOrigin(point, down), .direction = down};
                    const auto out = closestHit(scene, within);
                    lost += out ? 0 : 1;
                    back += out && out->primitive == hit->primitive ? 1 : 0;
                    ++spawned;
                }
                EXPECT_EQ(back, 0) << "size " << size << ", distance " << distance;
                EXPECT_EQ(lost, 0) << "size " << size << ", distance " << distance;
            }
    EXPECT_GT(spawned, 100'000);
}

// The sphere of stability F04, which an unmoved origin meets again in 45 rays of 100.
TEST(SpawnedRay, LeavesASphereOffTheOriginInAllDirections) {
    Random random(3);
    const DMat4 map = glm::translate(DMat4(1), DVec3(3, -2, 10));
    const Scene scene = indexInstances<Bvh2>({place<Bvh2>(map, Shape(Sphere{2}))}, {});
    int outward = 0, unmoved = 0;
    for (int i = 0; i < 200'000; ++i) {
        const DVec3 origin = DVec3(3, -2, 10) + 20.0 * random.direction();
        const Ray r = ray(origin, DVec3(3, -2, 10) + random.inCube(1) - origin);
        const auto hit = closestHit(scene, r);
        ASSERT_TRUE(hit);
        const SurfacePoint point = surfaceAt(scene, r, *hit);
        Vec3 d(random.direction());
        if (glm::dot(d, point.geometricNormal) < 0) d = -d;
        if (anyHit(scene, {.origin = spawnOrigin(point, d), .direction = d})) ++outward;
        if (anyHit(scene, {.origin = r.at(hit->t), .direction = d})) ++unmoved;
        ASSERT_TRUE(anyHit(scene, {.origin = spawnOrigin(point, -d), .direction = -d}));
    }
    EXPECT_EQ(outward, 0);
    EXPECT_GT(unmoved, 50'000) << "else this test would prove nothing";
}

TEST(SpawnedRay, StartsWithinAFewUnitsInTheLastPlaceOfTheSurface) {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        const DMat4 map = cases::randomPlacement(random, 1, 0.1, 2);
        const SurfacePoint point =
            Placement(map).toWorld(surfacePoint(random.inCube(0.5), random.direction()));
        const Vec3 direction(random.direction());
        const Vec3 gap = spawnOrigin(point, direction) - point.position;
        EXPECT_LT(glm::length(gap), 1e-4F);
        EXPECT_GE(glm::dot(gap, point.geometricNormal) * glm::dot(direction, point.geometricNormal), 0)
            << "on the side of the direction";
    }
}

}
}
