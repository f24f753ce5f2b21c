// labels: unit
// Spheres: closed forms, and the same formula in long double where the textbook's fails (stability F01 to
// F03).

#include <gtest/gtest.h>

#include "core/geometry/shapes.h"
#include "core/geometry/solid.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;
using Real = long double;

struct Truth {
    Real discriminant; // of the unit-length direction: r² − distance²
    Real near, far;
};

Truth truth(const Sphere& sphere, const Ray& ray) {
    const Real o[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const Real d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const Real a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const Real b = (o[0] * d[0] + o[1] * d[1] + o[2] * d[2]) / a;
    Real distance2 = 0;
    for (int i = 0; i < 3; ++i) distance2 += (o[i] - b * d[i]) * (o[i] - b * d[i]);
    const Real r = sphere.radius, discriminant = r * r - distance2;
    const Real half = discriminant > 0 ? std::sqrt(discriminant / a) : 0;
    return {discriminant, -b - half, -b + half};
}

TEST(Sphere, IsHitFromOutsideAtTheNearSide) {
    const auto hit = intersect(Sphere{2}, ray({0, 0, 10}, {0, 0, -1}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 8);
    EXPECT_EQ(hit->primitive, 0U);
}

TEST(Sphere, IsHitFromInsideAtTheFarSide) {
    EXPECT_EQ(intersect(Sphere{2}, ray({0, 0, 0}, {1, 0, 0}))->t, 2);
    EXPECT_EQ(intersect(Sphere{2}, ray({0, 1, 0}, {0, -1, 0}))->t, 3);
}

TEST(Sphere, BehindTheOriginIsNotHit) { EXPECT_FALSE(intersect(Sphere{2}, ray({0, 0, 10}, {0, 0, 1}))); }

TEST(Sphere, TangentTouchesAndTheNextFloatMisses) {
    EXPECT_EQ(intersect(Sphere{1}, ray({1, 0, 5}, {0, 0, -1}))->t, 5);
    EXPECT_FALSE(intersect(Sphere{1}, ray({std::nextafter(1.0F, 2.0F), 0, 5}, {0, 0, -1})));
}

TEST(Sphere, LimitsOfTheRayAreExclusive) {
    Ray r = ray({0, 0, 10}, {0, 0, -1});
    r.tMax = 8;
    EXPECT_FALSE(intersect(Sphere{2}, r));
    r.tMax = std::nextafter(8.0F, 9.0F);
    EXPECT_EQ(intersect(Sphere{2}, r)->t, 8);
    r = {.origin = r.origin, .direction = r.direction, .tMin = 8};
    EXPECT_EQ(intersect(Sphere{2}, r)->t, 12) << "the far side, once the near one is excluded";
    r.tMin = 12;
    EXPECT_FALSE(intersect(Sphere{2}, r));
}

TEST(Sphere, LengthOfTheDirectionScalesT) {
    EXPECT_EQ(intersect(Sphere{2}, ray({0, 0, 10}, {0, 0, -4}))->t, 2);
    EXPECT_EQ(intersect(Sphere{2}, ray({0, 0, 10}, {0, 0, -0x1p-30}))->t, 0x1p33F);
}

TEST(Sphere, NothingIsHitByARayThatIsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const DVec3& bad : {DVec3(0), DVec3(nan), DVec3(nan, 0, -1), DVec3(inf, 0, 0)})
        EXPECT_FALSE(intersect(Sphere{2}, ray({0, 0, 10}, bad)));
    EXPECT_FALSE(intersect(Sphere{2}, ray({nan, 0, 0}, {0, 0, -1})));
    EXPECT_FALSE(intersect(Sphere{0}, ray({0, 0, 10}, {0, 0, -1})));
    EXPECT_FALSE(intersect(Sphere{std::nanf("")}, ray({0, 0, 10}, {0, 0, -1})));
}

TEST(Sphere, FarRaysAreClassifiedLikeInLongDouble) {
    Random random(1);
    for (const double distance : {10.0, 100.0, 1000.0, 4096.0, 1e4, 1e5}) {
        int wrong = 0, hits = 0;
        Real worst = 0;
        for (int i = 0; i < 30'000; ++i) {
            const Ray r = ray({random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), distance}, {0, 0, -1});
            const Truth exact = truth(Sphere{1}, r);
            const auto hit = intersect(Sphere{1}, r);
            if (hit.has_value() != (exact.discriminant >= 0)) ++wrong;
            if (!hit) continue;
            ++hits;
            worst = std::fmax(worst, std::fabs(hit->t - exact.near) / exact.near);
        }
        EXPECT_EQ(wrong, 0) << distance;
        EXPECT_LT(worst, 1e-7L) << distance;
        EXPECT_GT(hits, 15'000);
    }
}

TEST(Sphere, HugeOneServesAsGround) {
    Random random(2);
    for (const float radius : {1e4F, 1e5F, 1e6F, 1e7F}) {
        const DVec3 eye(0, static_cast<double>(radius) + 1, 0);
        for (int i = 0; i < 1000; ++i) {
            const Ray r = ray(eye, {random.uniform(-1, 1), random.uniform(-1, -0.1), random.uniform(-1, 1)});
            const auto hit = intersect(Sphere{radius}, r);
            ASSERT_TRUE(hit);
            const Real exact = truth(Sphere{radius}, r).near;
            EXPECT_NEAR(static_cast<double>(hit->t / exact), 1, 6e-8) << "half a unit in the last place";
        }
    }
}

TEST(Sphere, PointsLieOnItWithinTheirErrorBound) {
    Random random(3);
    for (const double scale : {1e-3, 1.0, 1e3})
        for (int i = 0; i < 10'000; ++i) {
            const Sphere sphere{static_cast<float>(scale)};
            const Ray r = ray(scale * 1000.0 * random.direction(), {0, 0, 0});
            const Ray aimed = ray(DVec3(r.origin), random.inCube(0.5 * scale) - DVec3(r.origin));
            const auto hit = intersect(sphere, aimed);
            ASSERT_TRUE(hit);
            const SurfacePoint point = surfaceAt(sphere, aimed, *hit);
            const double off = std::fabs(glm::length(DVec3(point.position)) - sphere.radius);
            EXPECT_LE(off, glm::dot(glm::abs(DVec3(point.geometricNormal)), DVec3(point.error)));
            EXPECT_NEAR(glm::length(DVec3(point.geometricNormal)), 1, 1e-6);
            EXPECT_GT(glm::dot(point.geometricNormal, point.position), 0) << "outward";
            const DVec3 onRay = DVec3(aimed.origin) + static_cast<double>(hit->t) * DVec3(aimed.direction);
            EXPECT_LT(glm::length(DVec3(point.position) - onRay), 2e-4 * scale);
        }
}

TEST(QuadraticRoots, AreWithinFourUnitsOfLongDouble) {
    Random random(4);
    for (int i = 0; i < 1'000'000; ++i) {
        const double b = random.uniform(-1, 1) * std::exp2(random.below(40) - 20), c = random.uniform(-1, 1);
        const Real exactD = static_cast<Real>(b) * b - c;
        const double d = static_cast<double>(exactD);
        if (!(d >= 0)) continue;
        const Roots roots = quadraticRoots(1, b, c, d);
        const Real q = -(b + std::copysign(std::sqrt(exactD), static_cast<Real>(b)));
        const Real lower = std::fmin(q, c / q), upper = std::fmax(q, c / q);
        ASSERT_LE(std::fabs(roots.lower - lower),
                  4 * std::numeric_limits<double>::epsilon() * std::fabs(lower));
        ASSERT_LE(std::fabs(roots.upper - upper),
                  4 * std::numeric_limits<double>::epsilon() * std::fabs(upper));
    }
}

TEST(QuadraticRoots, SmallOneIsNotLost) {
    const Roots roots = quadraticRoots(1, -5000, 1, 5000.0 * 5000.0 - 1); // x² − 10⁴x + 1
    EXPECT_NEAR(roots.lower, 1.00000001e-4, 1e-19);
}

}
}
