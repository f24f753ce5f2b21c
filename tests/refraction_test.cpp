// labels: unit
// Where refracted rays go: blocks, pools, balls, prisms, bubbles, and eyes inside of them (stability 2.6 and
// F36).

#include <gtest/gtest.h>

#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

double angleBetween(const DVec3& a, const DVec3& b) {
    return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// Direction in the xy plane, so many degrees from straight down.
DVec3 downwards(double degreesFromVertical) {
    return {std::sin(radians(degreesFromVertical)), -std::cos(radians(degreesFromVertical)), 0};
}

/// The rays of one sample that looks from `eye` along `direction`.
std::vector<RayRecord> raysFrom(Scene scene, const DVec3& eye, const DVec3& direction, int depth = 6) {
    look(scene, eye, eye + direction);
    const Tracing tracing(scene, toDepth(depth));
    std::vector<RayRecord> rays = tracing.retrace().rays;
    for (RayRecord& ray : rays) ray.origin += Vec3(tracing.world().origin);
    return rays;
}

/// The child of the given kind, or nullptr.
const RayRecord* childOf(const std::vector<RayRecord>& rays, const RayRecord& parent, RayKind kind) {
    for (const RayRecord& ray : rays)
        if (ray.parent == &parent - rays.data() && ray.kind == kind) return &ray;
    return nullptr;
}

/// The eye ray and then the child of each kind in turn; shorter where there is none.
std::vector<RayRecord> path(const std::vector<RayRecord>& rays, const std::vector<RayKind>& kinds) {
    std::vector<RayRecord> result{rays.front()};
    const RayRecord* ray = rays.data();
    for (const RayKind kind : kinds) {
        ray = childOf(rays, *ray, kind);
        if (ray == nullptr) break;
        result.push_back(*ray);
    }
    return result;
}

constexpr RayKind kIn = RayKind::Refraction, kOut = RayKind::Refraction, kBack = RayKind::Reflection;

TEST(Refraction, BlockShiftsARayAndKeepsItsDirection) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{100, 1, 100}}, glass(1.5F));
    const auto rays = path(raysFrom(scene, -2.0 * downwards(45), downwards(45)), {kIn, kOut});
    ASSERT_EQ(rays.size(), 3U);
    const DVec3 in(rays[0].direction), out(rays[2].direction);
    EXPECT_LT(glm::length(in - out), 1e-6);
    const DVec3 between = DVec3(rays[2].origin) - DVec3(rays[0].origin);
    EXPECT_NEAR(glm::length(between - glm::dot(between, in) * in), 0.329142308, 1e-6);
}

TEST(Refraction, PoolIsMetWhereTheMarkOnItsGroundIsSeen) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{100, 2, 100}}, glass(1.33F), at({0, -1, 0}));
    add(scene, Box{{90, 1, 90}}, matte(Color(1)), at({0, -2.5, 0}));
    const auto rays = path(raysFrom(scene, {0, 1, 0}, downwards(22.185589)), {kIn});
    ASSERT_EQ(rays.size(), 2U);
    EXPECT_NEAR(rays[1].origin.x, 0.407799059, 1e-6);
    const Vec3 mark = rays[1].origin + rays[1].t * rays[1].direction;
    EXPECT_NEAR(mark.x, 1, 1e-5);
    EXPECT_NEAR(mark.y, -2, 1e-5);
}

TEST(Refraction, PoolSeenFromAboveIsShallowerByItsIndex) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{100, 2, 100}}, glass(1.33F), at({0, -1, 0}));
    add(scene, Box{{90, 1, 90}}, matte(Color(1)), at({0, -2.5, 0}));
    constexpr double kAngle = 0.3; // degrees: nearly vertical
    const auto rays = path(raysFrom(scene, {0, 1, 0}, downwards(kAngle)), {kIn});
    ASSERT_EQ(rays.size(), 2U);
    const double across = rays[1].t * static_cast<double>(rays[1].direction.x);
    EXPECT_NEAR(across / std::tan(radians(kAngle)), 1.503759399, 1e-4);
}

TEST(Refraction, SlabIsCrossedOnTheWayToAMarkBelowIt) {
    Scene scene = underSky(Color(1)); // 1 m of glass in 3 m of air
    add(scene, Box{{100, 1, 100}}, glass(1.5F), at({0, -1.5, 0}));
    add(scene, Box{{90, 1, 90}}, matte(Color(1)), at({0, -4.5, 0}));
    const auto rays = path(raysFrom(scene, {0, 0, 0}, downwards(15.308681)), {kIn, kOut});
    ASSERT_EQ(rays.size(), 3U);
    const Vec3 mark = rays[2].origin + rays[2].t * rays[2].direction;
    EXPECT_NEAR(mark.x, 1, 1e-5);
    EXPECT_NEAR(mark.y, -4, 1e-5);
}

// Of pictures of 512 rows and 45°: where the marks of the pool and under the slab are seen.
TEST(Refraction, MarksAreSeenInTheirPixels) {
    const Camera camera;
    const EyeRays eyeRays(camera, DVec3(0), 512, 512);
    for (const auto& [angle, pixels] : {std::pair{22.185589, 252.0356}, {15.308681, 169.1769}}) {
        const double x = 256 + pixels;
        const auto column = static_cast<int>(x);
        const Vec3 d = eyeRays.through(column, 256, {static_cast<float>(x - column), 0}).direction;
        EXPECT_NEAR(degrees(std::atan2(static_cast<double>(d.x), -static_cast<double>(d.z))), angle, 1e-4);
    }
}

TEST(Refraction, BallFocusesARay) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, glass(1.5F));
    const auto rays = path(raysFrom(scene, {-3, 0.5, 0}, {1, 0, 0}), {kIn, kOut});
    ASSERT_EQ(rays.size(), 3U);
    const DVec3 o(rays[2].origin), d(rays[2].direction);
    EXPECT_NEAR(angleBetween({1, 0, 0}, d), 21.057559, 1e-4);
    EXPECT_NEAR(o.x - o.y / d.y * d.x, 1.391572949, 1e-5) << "where it crosses the axis";
}

TEST(Refraction, RainbowStandsAtTheLeastDeviation) {
    double least = 180;
    Scene drop = underSky(Color(1));
    add(drop, Sphere{1}, glass(1.33F));
    for (double offset = 0.5; offset < 0.99; offset += 0.002) {
        const auto rays = path(raysFrom(drop, {-3, offset, 0}, {1, 0, 0}), {kIn, kBack, kOut});
        ASSERT_EQ(rays.size(), 4U);
        least = std::fmin(least, angleBetween({1, 0, 0}, DVec3(rays[3].direction)));
    }
    EXPECT_NEAR(least, 137.483618, 1e-3);
}

/// A prism whose cross-section is an equilateral triangle, its refracting edge up, along z.
TriangleMesh prism() {
    TriangleMesh mesh;
    const auto h = static_cast<float>(std::sqrt(0.75));
    for (const float z : {-5.0F, 5.0F})
        mesh.positions.insert(mesh.positions.end(), {{-0.5F, 0, z}, {0.5F, 0, z}, {0, h, z}});
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

/// Deviation in degrees of a ray that meets the left face at this angle of incidence.
double deviationByPrism(double incidence) {
    Scene scene = underSky(Color(1));
    add(scene, prism(), glass(1.5F));
    const DVec3 outward(-std::cos(radians(30)), std::sin(radians(30)), 0);
    const DVec3 spot(-0.25, std::sqrt(0.75) / 2, 0.1), along(outward.y, -outward.x, 0);
    const DVec3 from = std::cos(radians(incidence)) * outward - std::sin(radians(incidence)) * -along;
    const auto rays = path(raysFrom(scene, spot + 2.0 * from, -from), {kIn, kOut});
    return rays.size() == 3 ? angleBetween(-from, DVec3(rays[2].direction)) : -1;
}

TEST(Refraction, PrismDeviatesLeastInTheSymmetricPassage) {
    const double symmetric = degrees(std::asin(1.5 * std::sin(radians(30))));
    EXPECT_NEAR(deviationByPrism(symmetric), 37.180756, 1e-4);
    EXPECT_NEAR(deviationByPrism(45), 37.381306, 1e-4);
    EXPECT_GT(deviationByPrism(27.920490 + 1e-3), 0);
    EXPECT_EQ(deviationByPrism(27.920490 - 1e-3), -1) << "total reflection at the second face";
}

/// The eye in a medium looks up at its flat surface; 1 m under it.
std::vector<RayRecord> lookUpFromInside(float ior, double degreesFromVertical) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{1000, 100, 1000}}, glass(ior), at({0, -50, 0}));
    return raysFrom(scene, {0, -1, 0}, -downwards(degreesFromVertical), 1);
}

TEST(Refraction, WindowOfSnellEndsAtTheCriticalAngle) {
    for (const auto& [ior, critical] : {std::pair{1.33F, 48.753467}, {1.5F, 41.810315}}) {
        const auto within = lookUpFromInside(ior, critical - 0.01),
                   beyond = lookUpFromInside(ior, critical + 0.01);
        ASSERT_EQ(within.size(), 3U) << "a reflected and a refracted ray";
        EXPECT_FALSE(within[1].totalReflection);
        EXPECT_NEAR(angleBetween({0, 1, 0}, DVec3(within[2].direction)), 90, 3);
        ASSERT_EQ(beyond.size(), 2U);
        EXPECT_TRUE(beyond[1].totalReflection);
        EXPECT_EQ(beyond[1].kind, RayKind::Reflection);
        EXPECT_EQ(beyond[1].weight, Color(1)) << "all of the light";
    }
}

TEST(Refraction, EyeInAMediumSeesThroughItsHaze) {
    Scene scene = underSky(Color(0));
    add(scene, Box{{10, 10, 10}}, glass(1.33F, Color(1), {0.5F, 1, 2}));
    add(scene, Box{{1, 1, 1}}, glowing(Color(3)), at({0, 0, -2}));
    const Color seen = Tracing(scene).pixel();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 3 * std::exp(-1.5 * std::exp2(c - 1)), 1e-5);
}

TEST(Refraction, EyeInABallInWaterLooksIntoTheWater) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{10, 10, 10}}, glass(1.33F));
    add(scene, Sphere{1}, glass(1.5F));
    const double offset = std::sin(radians(30)); // so far from its centre a ray meets it at 30°
    const auto rays = path(raysFrom(scene, {offset, 0, 0}, {0, -1, 0}), {kOut});
    ASSERT_EQ(rays.size(), 2U);
    const DVec3 normal(offset, -std::cos(radians(30)), 0);
    EXPECT_NEAR(angleBetween(normal, DVec3(rays[1].direction)), 34.33, 0.01);
}

TEST(Refraction, BallInWaterTurnsTotalOnlyAtItsOwnCriticalAngle) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{10, 10, 10}}, glass(1.33F));
    add(scene, Sphere{1}, glass(1.5F));
    for (const auto& [degreesInside, total] : {std::pair{62.4, false}, {62.5, true}}) {
        const auto rays = raysFrom(scene, {std::sin(radians(degreesInside)), 0, 0}, {0, -1, 0}, 1);
        EXPECT_EQ(rays[1].totalReflection, total) << degreesInside;
    }
}

TEST(Refraction, AirBubbleInWaterBendsAwayFromTheNormal) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{10, 10, 10}}, glass(1.33F));
    add(scene, Sphere{1}, glass(1));
    for (const double incidence : {0.0, 20.0, 40.0, 48.0}) {
        const double offset = std::sin(radians(incidence));
        const auto rays = path(raysFrom(scene, {offset, 3, 0}, {0, -1, 0}), {kIn});
        ASSERT_EQ(rays.size(), 2U);
        const DVec3 inward(-offset, -std::cos(radians(incidence)), 0);
        EXPECT_NEAR(angleBetween(inward, DVec3(rays[1].direction)), degrees(std::asin(1.33 * offset)), 1e-3);
    }
    const auto beyond = raysFrom(scene, {std::sin(radians(49)), 3, 0}, {0, -1, 0}, 1);
    EXPECT_TRUE(beyond[1].totalReflection);
}

TEST(Refraction, OverlappingSolidsAreLeftInAnyOrder) {
    // Two blocks of one glass that overlap are one block: a ray goes straight through the faces inside.
    Scene scene = underSky(Color(1));
    add(scene, Box{{100, 1, 100}}, glass(1.5F));
    add(scene, Box{{100, 1, 100}}, glass(1.5F), at({0, 0.6, 0}));
    const auto rays = path(raysFrom(scene, -4.0 * downwards(60), downwards(60)), {kIn, kIn, kOut, kOut});
    ASSERT_EQ(rays.size(), 5U);
    EXPECT_LT(glm::length(rays[1].direction - rays[2].direction), 1e-6F);
    EXPECT_LT(glm::length(rays[2].direction - rays[3].direction), 1e-6F);
    EXPECT_LT(glm::length(rays[4].direction - rays[0].direction), 1e-6F);
    const DVec3 in(rays[0].direction), between = DVec3(rays[4].origin) - DVec3(rays[0].origin);
    const double inner = std::asin(std::sin(radians(60)) / 1.5), thickness = 1.6;
    EXPECT_NEAR(glm::length(between - glm::dot(between, in) * in),
                thickness * std::sin(radians(60) - inner) / std::cos(inner), 1e-5);
}

TEST(Refraction, MediumOfSeveralPartsAttenuatesByEach) {
    Scene scene = underSky(Color(0));
    scene.environment.nadir = Color(1);
    add(scene, Box{{100, 1, 100}}, glass(1, Color(0.9F), Color(0.5F)));
    add(scene, Box{{100, 0.5F, 100}}, glass(1, Color(0.8F), Color(2)));
    look(scene, {0, 3, 0}, {0, 0, 0});
    EXPECT_NEAR(Tracing(scene).pixel().g, 0.81 * 0.64 * std::exp(-0.5 * 0.5 - 2 * 0.5), 1e-5);
}

TEST(Refraction, BallHalfInWaterIsGlassAllThroughWhicheverComesFirst) {
    const auto picture = [](bool waterFirst) {
        Scene scene = underSky(Color(0.2F));
        scene.environment.zenith = Color(1);
        const auto water = [&] { add(scene, Box{{20, 4, 20}}, glass(1.33F), at({0, -2, 0})); };
        if (waterFirst) water();
        add(scene, Sphere{1}, glass(1.5F));
        if (!waterFirst) water();
        return scene;
    };
    for (const bool waterFirst : {true, false}) {
        const Scene scene = picture(waterFirst);
        // down through the ball's top, straight on through the water's face in it, and out into the water
        const DVec3 from(0.3, 3, 0);
        const auto rays = path(raysFrom(scene, from, {0, -1, 0}), {kIn, kIn, kOut});
        ASSERT_EQ(rays.size(), 4U);
        EXPECT_LT(angleBetween(DVec3(rays[1].direction), DVec3(rays[2].direction)), 1e-4);
        EXPECT_NEAR(rays[2].origin.y, 0, 1e-5) << "where the water's face is";
        const DVec3 exit(rays[3].origin), normal = glm::normalize(exit);
        const auto sine = [&](const DVec3& direction) { return glm::length(glm::cross(direction, normal)); };
        EXPECT_NEAR(sine(DVec3(rays[3].direction)) / sine(DVec3(rays[2].direction)), 1.5 / 1.33, 1e-4);
        // and back again the same way
        const auto back =
            path(raysFrom(scene, exit + 0.5 * DVec3(rays[3].direction), -DVec3(rays[3].direction)),
                 {kIn, kIn, kOut});
        ASSERT_EQ(back.size(), 4U);
        EXPECT_LT(angleBetween(DVec3(back[3].direction), {0, 1, 0}), 1e-3);
    }
    EXPECT_EQ(Tracing(picture(true), toDepth(6), 48, 48).radiance(),
              Tracing(picture(false), toDepth(6), 48, 48).radiance());
}

}
}
