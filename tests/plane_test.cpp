// labels: unit
// Planes and rectangles.

#include <gtest/gtest.h>

#include "core/geometry/shapes.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::ray;

TEST(Plane, IsHitFromAbove) {
    EXPECT_EQ(intersect(Plane{}, ray({3, 2, -7}, {0, -1, 0}))->t, 2);
    EXPECT_EQ(intersect(Plane{}, ray({3, 2, -7}, {4, -0.5, 1}))->t, 4);
    EXPECT_FALSE(intersect(Plane{}, ray({3, 2, -7}, {0, 1, 0}))) << "behind";
}

TEST(Plane, IsHitFromBelowOnlyIfDoubleSided) {
    const Ray up = ray({0, -2, 0}, {0, 1, 0});
    EXPECT_FALSE(intersect(Plane{}, up));
    Plane both;
    both.doubleSided = true;
    const auto hit = intersect(both, up);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 2);
    EXPECT_EQ(surfaceAt(both, up, *hit).geometricNormal, Vec3(0, 1, 0)) << "its own side, not the ray's";
}

TEST(Plane, RayInItOrParallelToItHitsNothing) {
    for (const bool doubleSided : {false, true})
        for (const double y : {0.0, 1.0, -1.0})
            EXPECT_FALSE(intersect(Plane{.doubleSided = doubleSided}, ray({0, y, 0}, {1, 0, 1})));
    EXPECT_FALSE(intersect(Plane{.doubleSided = true}, ray({0, 1, 0}, {0, 0, 0})));
    EXPECT_FALSE(intersect(Plane{.doubleSided = true}, ray({0, std::nan(""), 0}, {0, -1, 0})));
}

TEST(Plane, RectangleEndsAtItsEdges) {
    const Plane plane{.sizeX = 2, .sizeZ = 6};
    const auto above = [&](double x, double z) {
        return intersect(plane, ray({x, 1, z}, {0, -1, 0})).has_value();
    };
    EXPECT_TRUE(above(1, 3) && above(-1, -3) && above(0, 0));
    EXPECT_FALSE(above(1.000001, 0) || above(-1.000001, 0) || above(0, 3.000001) || above(0, -3.000001));
    const Plane strip{.sizeX = 2};
    EXPECT_TRUE(intersect(strip, ray({1, 1, 1e30}, {0, -1, 0})));
    EXPECT_FALSE(intersect(strip, ray({1.5, 1, 0}, {0, -1, 0})));
    EXPECT_FALSE(intersect(Plane{.sizeX = std::nanf("")}, ray({0, 1, 0}, {0, -1, 0})));
}

TEST(Plane, RoundOneEndsAtItsRim) {
    const Plane disc{.sizeX = 2, .sizeZ = 6, .round = true};
    const auto above = [&](double x, double z) {
        return intersect(disc, ray({x, 1, z}, {0, -1, 0})).has_value();
    };
    for (double turn = 0; turn < 6.3; turn += 0.1) {
        EXPECT_TRUE(above(0.99999 * std::cos(turn), 2.99997 * std::sin(turn)));
        EXPECT_FALSE(above(1.00001 * std::cos(turn), 3.00003 * std::sin(turn)));
    }
}

TEST(Plane, LimitsOfTheRayAreExclusive) {
    const Ray down = ray({0, 2, 0}, {0, -1, 0});
    EXPECT_FALSE(intersect(Plane{}, Ray{down.origin, down.direction, 2, kInfinity}));
    EXPECT_FALSE(intersect(Plane{}, Ray{down.origin, down.direction, 0, 2}));
    EXPECT_FALSE(intersect(Plane{.doubleSided = true}, ray({0, 0, 0}, {0, -1, 0}))) << "starts on it";
}

TEST(Plane, GrazingRayMeetsItWhereLongDoubleSays) {
    cases::Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        const double angle = radians(random.uniform(0.001, 1));
        const Ray r = ray({0, 1.7, 0}, {std::cos(angle), -std::sin(angle), random.uniform(-1, 1)});
        const auto hit = intersect(Plane{}, r);
        ASSERT_TRUE(hit);
        using Real = long double;
        const Real t = static_cast<Real>(r.origin.y) / -static_cast<Real>(r.direction.y);
        EXPECT_NEAR(static_cast<double>(hit->t / t), 1, 6e-8);
        const SurfacePoint point = surfaceAt(Plane{}, r, *hit);
        EXPECT_LE(std::fabs(point.position.x - t * r.direction.x), point.error.x);
        EXPECT_LE(std::fabs(point.position.z - t * r.direction.z), point.error.z);
        EXPECT_EQ(point.position.y, 0);
    }
}

}
}
