// labels: unit
// Cylinders, cones and capped cones.

#include <gtest/gtest.h>

#include "core/geometry/shapes.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

constexpr Cylinder kCylinder{.height = 4, .radiusTop = 1, .radiusBottom = 1};
constexpr Cylinder kCone{.height = 4, .radiusTop = 0, .radiusBottom = 2};
constexpr Cylinder kFunnel{.height = 4, .radiusTop = 2, .radiusBottom = 0};
constexpr Cylinder kCapped{.height = 4, .radiusTop = 1, .radiusBottom = 2};
constexpr std::uint32_t kSide = 0, kTop = 1, kBottom = 2;

void expectHit(const Cylinder& cylinder, const Ray& r, double t, std::uint32_t face, const DVec3& normal) {
    const auto hit = intersect(cylinder, r);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, t, 1e-6 * t);
    EXPECT_EQ(hit->primitive, face);
    const SurfacePoint point = surfaceAt(cylinder, r, *hit);
    EXPECT_LT(glm::length(DVec3(point.geometricNormal) - normal), 1e-6);
    const DVec3 onRay = DVec3(r.origin) + t * DVec3(r.direction);
    EXPECT_LT(glm::length(DVec3(point.position) - onRay), 1e-6 * (1 + glm::length(onRay)));
}

TEST(Cylinder, SideAndCapsAreHitFromOutsideAndInside) {
    expectHit(kCylinder, ray({5, 1, 0}, {-1, 0, 0}), 4, kSide, {1, 0, 0});
    expectHit(kCylinder, ray({0.5, 9, 0}, {0, -1, 0}), 7, kTop, {0, 1, 0});
    expectHit(kCylinder, ray({0.5, -9, 0}, {0, 1, 0}), 7, kBottom, {0, -1, 0});
    expectHit(kCylinder, ray({0, 0, 0}, {0, 0, 1}), 1, kSide, {0, 0, 1});
    expectHit(kCylinder, ray({0, 0, 0}, {0, 1, 0}), 2, kTop, {0, 1, 0});
    expectHit(kCylinder, ray({0, 0, 0}, {0, -2, 0}), 1, kBottom, {0, -1, 0});
}

TEST(Cylinder, RayPastItOrAwayFromItHitsNothing) {
    EXPECT_FALSE(intersect(kCylinder, ray({5, 2.001, 0}, {-1, 0, 0}))) << "over the top";
    EXPECT_FALSE(intersect(kCylinder, ray({5, 0, 1.001}, {-1, 0, 0}))) << "beside it";
    EXPECT_FALSE(intersect(kCylinder, ray({1.001, 9, 0}, {0, -1, 0}))) << "along the axis";
    EXPECT_FALSE(intersect(kCylinder, ray({5, 0, 0}, {1, 0, 0}))) << "behind";
}

TEST(Cylinder, TangentTouches) {
    EXPECT_EQ(intersect(kCylinder, ray({5, 0, 1}, {-1, 0, 0}))->t, 5);
    EXPECT_FALSE(intersect(kCylinder, ray({5, 0, std::nextafter(1.0F, 2.0F)}, {-1, 0, 0})));
    EXPECT_EQ(intersect(kCylinder, ray({1, 9, 0}, {0, -1, 0}))->t, 7) << "down the side";
}

TEST(Cylinder, LimitsOfTheRayAreExclusive) {
    const Vec3 o(5, 0, 0), d(-1, 0, 0);
    EXPECT_FALSE(intersect(kCylinder, Ray{o, d, 0, 4}));
    EXPECT_EQ(intersect(kCylinder, Ray{o, d, 4, kInfinity})->t, 6);
    EXPECT_FALSE(intersect(kCylinder, Ray{o, d, 6, kInfinity}));
}

TEST(Cylinder, NothingIsHitByARayThatIsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Cylinder& c : {kCylinder, kCone, kFunnel, kCapped}) {
        EXPECT_FALSE(intersect(c, ray({0, 0, 0}, {0, 0, 0})));
        EXPECT_FALSE(intersect(c, ray({nan, 0, 0}, {0, 0, -1})));
        EXPECT_FALSE(intersect(c, ray({0, nan, 5}, {0, 0, -1})));
        EXPECT_FALSE(intersect(c, ray({0, 0, 5}, {0, nan, -1})));
    }
    EXPECT_FALSE(intersect(Cylinder{std::nanf(""), 1, 1}, ray({0, 0, 5}, {0, 0, -1})));
}

TEST(Cone, SideNormalLeansByItsSlope) {
    const DVec3 leaning = glm::normalize(DVec3(2, 1, 0)); // radius falls by 1 on 2 of height
    expectHit(kCone, ray({9, 0, 0}, {-1, 0, 0}), 8, kSide, leaning);
    expectHit(kCone, ray({0, 0, 0}, {1, 0, 0}), 1, kSide, leaning);
    expectHit(kFunnel, ray({9, 0, 0}, {-1, 0, 0}), 8, kSide, {leaning.x, -leaning.y, 0});
}

TEST(Cone, SteepRayMeetsSideAndBaseButNotTheMirrorImage) {
    expectHit(kCone, ray({0.5, 9, 0}, {0, -1, 0}), 8, kSide, glm::normalize(DVec3(2, 1, 0)));
    expectHit(kCone, ray({0.5, 0, 0}, {0, 1, 0}), 1, kSide, glm::normalize(DVec3(2, 1, 0)));
    expectHit(kCone, ray({0.5, -9, 0}, {0, 1, 0}), 7, kBottom, {0, -1, 0});
    EXPECT_FALSE(intersect(kCone, ray({0.5, 9, 0}, {0, 1, 0})));
    EXPECT_FALSE(intersect(kCone, ray({5, 3, 0}, {-1, 0, 0}))) << "through the mirror image";
}

TEST(Cone, RayAlongItsSideTouchesOrPasses) {
    const DVec3 down(1, -2, 0); // the slope of the side
    EXPECT_FALSE(intersect(kCone, ray({0.25, 2, 0}, down))) << "beside it";
    expectHit(kCone, ray({-1.5, 4, 0}, down), 1.25, kSide, glm::normalize(DVec3(-2, 1, 0)));
    expectHit(kCone, ray({-0.25, 1, 0}, down), 1.5, kBottom, {0, -1, 0});
}

TEST(Cone, ApexHasAFiniteSurface) {
    const Ray axis = ray({0, 9, 0}, {0, -1, 0}), across = ray({5, 2, 0}, {-1, 0, 0});
    expectHit(kCone, axis, 7, kSide, {0, 1, 0});
    if (const auto hit = intersect(kCone, across)) {
        EXPECT_EQ(hit->t, 5);
        EXPECT_NEAR(glm::length(surfaceAt(kCone, across, *hit).geometricNormal), 1, 1e-6F);
    }
    expectHit(kFunnel, ray({0, -9, 0}, {0, 1, 0}), 7, kSide, {0, -1, 0});
}

// All crossings of side and caps one by one, in long double; none if the choice hangs on rounding.
struct Crossings {
    std::vector<std::pair<long double, std::uint32_t>> found;
    bool doubtful = false;
};

Crossings bruteForce(const Cylinder& c, const Ray& r) {
    using Real = long double;
    const Real h = 0.5L * c.height, slope = (static_cast<Real>(c.radiusTop) - c.radiusBottom) / c.height;
    const Real middle = 0.5L * (static_cast<Real>(c.radiusTop) + c.radiusBottom);
    const Real ox = r.origin.x, oy = r.origin.y, oz = r.origin.z;
    const Real dx = r.direction.x, dy = r.direction.y, dz = r.direction.z;
    Crossings result;
    const auto keep = [&](Real t, Real margin, std::uint32_t face) {
        if (std::fabs(margin) < 1e-9L * h || std::fabs(t) < 1e-9L * h) result.doubtful = true;
        if (margin >= 0 && t > 0) result.found.emplace_back(t, face);
    };
    for (const int side : {1, -1}) {
        const Real t = (static_cast<Real>(side) * h - oy) / dy, x = ox + t * dx, z = oz + t * dz;
        const Real radius = side > 0 ? c.radiusTop : c.radiusBottom;
        keep(t, radius - std::hypot(x, z), side > 0 ? kTop : kBottom);
    }
    const Real w = middle + slope * oy, dw = slope * dy;
    const Real A = dx * dx + dz * dz - dw * dw, B = 2 * (ox * dx + oz * dz - w * dw);
    const Real C = ox * ox + oz * oz - w * w, D = B * B - 4 * A * C;
    if (std::fabs(D) < 1e-9L * B * B) result.doubtful = true;
    if (D < 0) return result;
    for (const int sign : {1, -1}) {
        const Real t = (-B + static_cast<Real>(sign) * std::sqrt(D)) / (2 * A);
        keep(t, h - std::fabs(oy + t * dy), kSide);
    }
    return result;
}

TEST(Cylinder, HitsAreThoseOfTheCrossingsOneByOne) {
    Random random(1);
    for (const double scale : {1e-3, 1.0, 1e3}) {
        int hits = 0;
        for (int i = 0; i < 60'000; ++i) {
            const double kind = random.uniform(0, 3);
            const auto radius = [&](bool zero) {
                return zero ? 0.0F : static_cast<float>(scale * random.uniform(0.2, 1.5));
            };
            Cylinder c{static_cast<float>(scale * random.uniform(0.5, 3)), radius(kind > 2), 0};
            c.radiusBottom = kind < 1 ? c.radiusTop : radius(false);
            const Ray r = ray(random.inCube(2 * scale), random.inCube(1));
            const Crossings truth = bruteForce(c, r);
            if (truth.doubtful) continue;
            const auto hit = intersect(c, r);
            ASSERT_EQ(hit.has_value(), !truth.found.empty()) << scale << " " << i;
            if (!hit) continue;
            ++hits;
            const auto first = *std::ranges::min_element(truth.found);
            ASSERT_NEAR(static_cast<double>(hit->t / first.first), 1, 1e-6) << scale << " " << i;
            ASSERT_EQ(hit->primitive, first.second);
        }
        EXPECT_GT(hits, 8'000);
    }
}

TEST(Cylinder, RayFromInsideAlwaysFindsAWayOutAlsoAtTheRim) {
    Random random(2);
    for (const Cylinder& c : {kCylinder, kCone, kFunnel, kCapped})
        for (int i = 0; i < 50'000; ++i) {
            const double phi = random.uniform(0, 2 * kPiD), top = random.below(2);
            const double radius = top > 0 ? c.radiusTop : c.radiusBottom;
            const DVec3 rim(radius * std::cos(phi), (top - 0.5) * c.height, radius * std::sin(phi));
            const DVec3 inside = 0.1 * random.inCube(1);
            ASSERT_TRUE(intersect(c, ray(inside, rim - DVec3(Vec3(inside)))));
        }
}

TEST(Cylinder, PointsLieOnItWithinTheirErrorBound) {
    Random random(3);
    for (const double scale : {1e-3, 1.0, 1e3})
        for (int i = 0; i < 20'000; ++i) {
            const auto s = static_cast<float>(scale);
            const Cylinder c{2 * s, i % 2 == 0 ? s : 0, s};
            const Ray eye = ray(1000 * scale * random.direction(), DVec3(0));
            const Ray r = ray(DVec3(eye.origin), random.inCube(0.3 * scale) - DVec3(eye.origin));
            const auto hit = intersect(c, r);
            if (!hit) continue;
            const SurfacePoint point = surfaceAt(c, r, *hit);
            const DVec3 p(point.position), n(point.geometricNormal);
            ASSERT_NEAR(glm::length(n), 1, 1e-6);
            const double slope = (static_cast<double>(c.radiusTop) - c.radiusBottom) / c.height;
            const double middle = 0.5 * (static_cast<double>(c.radiusTop) + c.radiusBottom);
            const double off = hit->primitive == kSide
                                   ? (std::hypot(p.x, p.z) - middle - slope * p.y) / std::hypot(1, slope)
                                   : std::fabs(p.y) - 0.5 * c.height;
            ASSERT_LE(std::fabs(off), glm::dot(glm::abs(n), DVec3(point.error)) + 1e-15 * scale);
        }
}

}
}
