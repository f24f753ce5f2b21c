// labels: unit
// Spheres where the textbook fails: huge ones seen from close by, small ones from far away (stability F02,
// F06).

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;
using Real = long double;

// In float the quadratic is off by 1.6e-2 at R = 1e6.
TEST(HugeSphere, IsMetWhereLongDoubleSays) {
    Random random(1);
    for (const double radius : {1e4, 1e5, 1e6, 1e7, 1e8}) {
        const Sphere ground{static_cast<float>(radius)};
        for (int i = 0; i < 10'000; ++i) {
            const double angle = radians(random.uniform(5.7, 90)), around = random.uniform(0, 2 * kPiD);
            const Ray r = ray(
                {0, radius + std::max(1.0, radius * 1e-7), 0},
                {std::cos(angle) * std::cos(around), -std::sin(angle), std::cos(angle) * std::sin(around)});
            const auto hit = intersect(ground, r);
            ASSERT_TRUE(hit) << radius;
            const Real y = r.origin.y, dx = r.direction.x, dy = r.direction.y, dz = r.direction.z;
            const Real a = dx * dx + dy * dy + dz * dz, b = y * dy, R = ground.radius;
            const Real exact = ((y - R) * (y + R)) / (-b + std::sqrt(b * b - a * (y - R) * (y + R)));
            const Real t = static_cast<Real>(hit->t) + hit->u; // u is what the float lacks
            EXPECT_LT(std::fabs(t / exact - 1), radius <= 1e6 ? 1e-9L : 1e-7L) << radius;
        }
    }
}

/// Rays from `distance` radii away, mirrored in a random direction outward: how many meet it again.
template <class Object>
int metAgain(const Object& object, double distance, int rays) {
    Random random(2);
    const auto scene = indexInstances<Bvh2>({place<Bvh2>(DMat4(1), object)}, {});
    int count = 0;
    for (int i = 0; i < rays; ++i) {
        const DVec3 origin(Vec3(distance * random.direction()));
        const Ray aimed = ray(origin, random.inCube(0.5) - origin);
        const auto hit = closestHit(scene, aimed);
        if (!hit) continue;
        const SurfacePoint point = surfaceAt(scene, aimed, *hit);
        Vec3 away(random.direction());
        if (glm::dot(away, point.geometricNormal) < 0) away = -away;
        count += anyHit(scene, {.origin = spawnOrigin(point, away), .direction = away}) ? 1 : 0;
    }
    return count;
}

// An offset alone, without a reprojected point, leaves 51 % self-hits at 10,000 radii.
TEST(FarEye, SeesASphereThatItsMirroredRaysLeave) {
    for (const double distance : {1e2, 1e3, 1e4, 1e5, 1e6})
        EXPECT_EQ(metAgain(Shape(Sphere{1}), distance, 50'000), 0) << distance;
}

TEST(FarEye, SeesAMeshThatItsMirroredRaysLeave) {
    const auto mesh = indexMesh<Bvh2>(cases::shared(cases::closedMesh(16, 24, 1)), {});
    for (const double distance : {1e2, 1e3, 1e4, 1e5, 1e6})
        EXPECT_EQ(metAgain(mesh, distance, 50'000), 0) << distance;
}

}
}
