// labels: unit
// One triangle at a time: sides, limits, sizes, degenerate ones (stability F08 to F11).

#include <gtest/gtest.h>

#include "core/base/thread_pool.h"
#include "core/geometry/mesh.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

TriangleMesh triangle(const DVec3& a, const DVec3& b, const DVec3& c) {
    TriangleMesh mesh;
    mesh.positions = {Vec3(a), Vec3(b), Vec3(c)};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

std::optional<Hit> intersect(const TriangleMesh& mesh, const Ray& r) {
    return intersectTriangle(mesh, 0, RayShear(r), r);
}

const TriangleMesh kUnit = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

TEST(Triangle, HitCarriesTheWeightsOfItsSecondAndThirdVertex) {
    const auto hit = intersect(kUnit, ray({0.25, 0.5, 3}, {0, 0, -1}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 3);
    EXPECT_EQ(hit->u, 0.25F);
    EXPECT_EQ(hit->v, 0.5F);
    EXPECT_EQ(intersect(kUnit, ray({0.25, 0.5, 3}, {0, 0, -2}))->t, 1.5F);
}

TEST(Triangle, BackIsHitOnlyIfTheMeshIsDoubleSided) {
    TriangleMesh oneSided = kUnit;
    oneSided.doubleSided = false;
    for (const DVec3& d : {DVec3(0, 0, 1), DVec3(0.3, 0.2, 1)}) {
        const DVec3 target(0.25, 0.25, 0);
        EXPECT_TRUE(intersect(kUnit, ray(target + d, -d)));
        EXPECT_TRUE(intersect(kUnit, ray(target - d, d)));
        EXPECT_TRUE(intersect(oneSided, ray(target + d, -d))) << "counter-clockwise is the front";
        EXPECT_FALSE(intersect(oneSided, ray(target - d, d)));
    }
}

TEST(Triangle, EachAxisMayBeTheLongestOfTheDirection) {
    Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        const TriangleMesh mesh = triangle(random.inCube(1), random.inCube(1), random.inCube(1));
        const double u = random.uniform(0.05, 0.5), v = random.uniform(0.05, 0.45);
        const DVec3 a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
        const DVec3 target = (1 - u - v) * a + u * b + v * c, origin = 3.0 * random.direction();
        const DVec3 normal = safeNormalize(glm::cross(b - a, c - a));
        const double facing = glm::dot(normal, glm::normalize(target - origin));
        if (std::fabs(facing) < 0.05 || glm::length(glm::cross(b - a, c - a)) < 0.05) continue;
        const Ray r = ray(origin, target - DVec3(Vec3(origin)));
        const auto hit = intersect(mesh, r);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 1, 1e-5);
        EXPECT_NEAR(hit->u, u, 1e-4);
        EXPECT_NEAR(hit->v, v, 1e-4);
        TriangleMesh oneSided = mesh;
        oneSided.doubleSided = false;
        EXPECT_EQ(intersect(oneSided, r).has_value(), facing < 0);
    }
}

TEST(Triangle, EdgesAndVerticesBelongToIt) {
    for (const DVec3& p :
         {DVec3(0, 0, 0), DVec3(1, 0, 0), DVec3(0, 1, 0), DVec3(0.5, 0.5, 0), DVec3(0.5, 0, 0)})
        EXPECT_TRUE(intersect(kUnit, ray(p + DVec3(0, 0, 2), {0, 0, -1})));
    EXPECT_FALSE(intersect(kUnit, ray({0.5, -1e-30, 2}, {0, 0, -1})));
    EXPECT_FALSE(intersect(kUnit, ray({0.5, std::nextafter(0.5F, 1.0F), 2}, {0, 0, -1})));
}

TEST(Triangle, LimitsOfTheRayAreExclusive) {
    const Vec3 o(0.25F, 0.25F, 3), d(0, 0, -1);
    EXPECT_FALSE(intersect(kUnit, Ray{o, d, 0, 3}));
    EXPECT_FALSE(intersect(kUnit, Ray{o, d, 3, kInfinity}));
    EXPECT_TRUE(intersect(kUnit, Ray{o, d, std::nextafter(3.0F, 0.0F), std::nextafter(3.0F, 4.0F)}));
    EXPECT_FALSE(intersect(kUnit, Ray{o, -d, 0, kInfinity})) << "behind";
}

TEST(Triangle, RayInItsPlaneOrNoneHitsNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(intersect(kUnit, ray({-1, 0.25, 0}, {1, 0, 0})));
    EXPECT_FALSE(intersect(kUnit, ray({0.25, 0.25, 1}, {0, 0, 0})));
    EXPECT_FALSE(intersect(kUnit, ray({0.25, 0.25, 1}, {nan, 0, -1})));
    EXPECT_FALSE(intersect(kUnit, ray({nan, 0.25, 1}, {0, 0, -1})));
    EXPECT_FALSE(intersect(kUnit, ray({0.25, 0.25, 1}, {0, 0, -inf})));
    EXPECT_FALSE(intersect(kUnit, ray({0.25, 0.25, inf}, {0, 0, -1})));
    EXPECT_FALSE(intersect(triangle({nan, 0, 0}, {1, 0, 0}, {0, 1, 0}), ray({0.25, 0.25, 1}, {0, 0, -1})));
}

TEST(Triangle, AnySizeIsHit) {
    const FloatEnvironment tracing; // products of the smallest are flushed to zero
    for (int exponent = -120; exponent <= 120; exponent += 4) {
        const double size = std::exp2(exponent);
        const TriangleMesh mesh = triangle({0, 0, 0}, {size, 0, 0}, {0, size, 0});
        const auto hit = intersect(mesh, ray({0.25 * size, 0.25 * size, size}, {0, 0, -1}));
        ASSERT_TRUE(hit) << exponent;
        EXPECT_EQ(hit->t, static_cast<float>(size));
        EXPECT_EQ(hit->u, 0.25F);
        const SurfacePoint point = surfaceAt(mesh, Vec3(0, 0, -1), *hit);
        EXPECT_EQ(point.geometricNormal, Vec3(0, 0, 1));
        EXPECT_EQ(point.position, Vec3(0.25 * size, 0.25 * size, 0));
    }
}

TEST(Triangle, SmallOneIsHitFromTenMetres) {
    for (const double leg : {0.9e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const TriangleMesh mesh = triangle({0, 0, 0}, {leg, 0, 0}, {0, leg, 0});
        EXPECT_TRUE(intersect(mesh, ray({0.25 * leg, 0.25 * leg, 10}, {0, 0, -1}))) << leg;
        EXPECT_FALSE(intersect(mesh, ray({0.75 * leg, 0.75 * leg, 10}, {0, 0, -1}))) << leg;
    }
}

// Triangle.BadCases of pbrt: three points on a line, which the test by signs alone calls a hit at 0.99586.
TEST(Triangle, PointsOnALineAreNoTriangle) {
    const TriangleMesh mesh =
        triangle({-1113.45459, -79.049614, -56.2431908}, {-1113.45459, -87.0922699, -56.2431908},
                 {-1113.45459, -79.2090149, -56.2431908});
    Ray r = ray({-1081.47925, 99.9999542, 87.7701111}, {-32.1072998, -183.355865, -144.607635});
    r.tMax = 0.9999F;
    EXPECT_FALSE(intersect(mesh, r));
    EXPECT_FALSE(intersect(triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), ray({1, 1, 5}, {0, 0, -1})));
    EXPECT_FALSE(intersect(triangle({0, 0, 0}, {1, 0, 0}, {1, 0, 0}), ray({0.5, 0, 5}, {0, 0, -1})));
}

TEST(Triangle, TIsThatOfThePlaneInLongDouble) {
    Random random(2);
    using Real = long double;
    for (const double distance : {1.0, 1e3, 1e5}) {
        for (int i = 0; i < 20'000; ++i) {
            const TriangleMesh mesh = triangle(random.inCube(1), random.inCube(1), random.inCube(1));
            const Vec3 a = mesh.positions[0];
            const DVec3 e1 = DVec3(mesh.positions[1]) - DVec3(a), e2 = DVec3(mesh.positions[2]) - DVec3(a);
            const Ray eye = ray(distance * 3 * random.direction(), DVec3(0));
            const DVec3 origin(eye.origin), target = DVec3(a) + 0.3 * e1 + 0.3 * e2;
            const Ray r = ray(origin, target - origin);
            const auto hit = intersect(mesh, r);
            if (!hit) continue;
            const DVec3 n = glm::cross(e1, e2);
            Real above = 0, along = 0;
            for (int k = 0; k < 3; ++k) {
                above += static_cast<Real>(n[k]) * (static_cast<Real>(a[k]) - r.origin[k]);
                along += static_cast<Real>(n[k]) * r.direction[k];
            }
            const double facing = std::fabs(glm::dot(glm::normalize(n), glm::normalize(DVec3(r.direction))));
            if (facing < 0.1) continue;
            ASSERT_NEAR(static_cast<double>(hit->t / (above / along)), 1, 6.1e-8) << distance;
        }
    }
}

TEST(Triangle, SliversAndExtremeSizesHaveUnitNormals) {
    Random random(3);
    for (int i = 0; i < 50'000; ++i) {
        const double size = std::exp2(random.below(100) - 50), width = std::exp2(-random.below(24));
        const DVec3 a = random.inCube(size), along = size * random.direction();
        const TriangleMesh mesh = triangle(a, a + along, a + 0.5 * along + width * random.inCube(size));
        const SurfacePoint point = surfaceAt(mesh, Vec3(0, 0, -1), Hit{.t = 1, .u = 0.3F, .v = 0.3F});
        const double length = glm::length(DVec3(point.geometricNormal));
        const DVec3 b(mesh.positions[1]), c(mesh.positions[2]), o(mesh.positions[0]);
        const bool line = glm::cross(b - o, c - o) == DVec3(0);
        ASSERT_NEAR(length, line ? 0 : 1, 1e-6);
        ASSERT_TRUE(isFinite(point.position));
    }
}

TEST(Triangle, PositionLiesInItsPlaneWithinTheErrorBound) {
    Random random(4);
    for (int i = 0; i < 50'000; ++i) {
        const double scale = std::pow(10, random.uniform(-3, 3));
        const DVec3 at = random.inCube(10 * scale);
        const TriangleMesh mesh =
            triangle(at + random.inCube(scale), at + random.inCube(scale), at + random.inCube(scale));
        const auto u = static_cast<float>(random.uniform(0, 0.5)),
                   v = static_cast<float>(random.uniform(0, 0.5));
        const SurfacePoint point = surfaceAt(mesh, Vec3(0, 0, -1), Hit{.t = 1, .u = u, .v = v});
        const DVec3 a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
        const DVec3 n = glm::normalize(glm::cross(b - a, c - a));
        const double off = std::fabs(glm::dot(n, DVec3(point.position) - a));
        ASSERT_LE(off, glm::dot(glm::abs(n), DVec3(point.error)) + 1e-14 * scale);
    }
}

TEST(Triangle, ShadingNormalUvAndColourAreInterpolated) {
    TriangleMesh mesh = kUnit;
    mesh.normals = {Vec3(0, 0, 1), Vec3(0.6F, 0, 0.8F), Vec3(0, 0.6F, 0.8F)};
    mesh.uvs[1] = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 2)};
    mesh.colors = {Vec4(1, 0, 0, 1), Vec4(0, 1, 0, 1), Vec4(0, 0, 1, 0)};
    const Hit hit{.t = 1, .u = 0.25F, .v = 0.5F};
    const DVec3 expected = glm::normalize(DVec3(0.15, 0.3, 0.85));
    EXPECT_LT(glm::length(DVec3(surfaceAt(mesh, Vec3(0, 0, -1), hit).shadingNormal) - expected), 1e-7);
    EXPECT_EQ(textureCoordinates(mesh, hit, 1), Vec2(0.25F, 1));
    EXPECT_EQ(textureCoordinates(mesh, hit, 0), Vec2(0));
    EXPECT_EQ(vertexColor(mesh, hit), Vec4(0.25F, 0.25F, 0.5F, 0.5F));
    EXPECT_EQ(vertexColor(kUnit, hit), Vec4(1));
}

TEST(Triangle, UselessVertexNormalsGiveWayToTheGeometricOne) {
    TriangleMesh mesh = kUnit;
    const Hit hit{.t = 1, .u = 0.25F, .v = 0.5F};
    mesh.normals.assign(3, Vec3(0));
    EXPECT_EQ(surfaceAt(mesh, Vec3(0, 0, -1), hit).shadingNormal, Vec3(0, 0, 1));
    mesh.normals.assign(3, Vec3(std::nanf("")));
    EXPECT_EQ(surfaceAt(mesh, Vec3(0, 0, -1), hit).shadingNormal, Vec3(0, 0, 1));
    mesh.normals.assign(3, Vec3(0, 0, -1));
    EXPECT_EQ(surfaceAt(mesh, Vec3(0, 0, -1), hit).shadingNormal, Vec3(0, 0, 1))
        << "on the triangle's own side";
}

// Contracted to fused multiply-add, neither would hold, and neighbours would disagree about their edge (F19).
TEST(FloatArithmetic, IsNotContracted) {
    Random random(5);
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec3 a(random.inCube(1)), b(random.inCube(1));
        ASSERT_EQ(glm::cross(a, a), Vec3(0));
        ASSERT_EQ(a.x * b.y - a.y * b.x, -(b.x * a.y - b.y * a.x));
    }
}

}
}
