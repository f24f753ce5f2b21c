// labels: unit
// Mirrors and glass over many bounces, under bent normals, and face to face (stability F31, F35, F36).

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TEST(Directions, StayOfUnitLengthOverAllBounces) {
    Scene scene = underSky(Color(1));
    add(scene, Box{{4, 5, 6}}, mirror(Color(1)));
    look(scene, {0.3, 0.2, 1.9}, {0.1, -0.4, 0}, 90);
    const Retrace sample = Tracing(scene, toDepth(kMaxDepth)).retrace();
    EXPECT_EQ(sample.rays.size(), 1U + kMaxDepth);
    for (const RayRecord& ray : sample.rays) ASSERT_NEAR(glm::length(ray.direction), 1, 1e-4) << ray.depth;
}

// A mirror whose normals are bent inward at its edges would send rays through itself.
TEST(ClosedRoomOfBentNormals, StaysDarkUnderABrightSky) {
    for (const int facets : {6, 8, 12}) {
        TriangleMesh room = cases::closedMesh(facets, 2 * facets, 2, 0.4);
        for (const Vec3& p : room.positions) room.normals.push_back(glm::normalize(p));
        Scene scene = underSky(Color(1000));
        add(scene, room, mirror(Color(1)));
        look(scene, {0.1, 0.2, 0.3}, {0.4, 0.1, -1}, 100);
        for (const Color& c : Tracing(scene, toDepth(20), 64, 64).radiance())
            ASSERT_EQ(c, Color(0)) << facets;
    }
}

/// Degrees from the vertical in each medium that a ray from above goes through.
std::vector<double> anglesThrough(const Scene& scene, double degreesAbove) {
    Scene seen = scene;
    const DVec3 down(std::sin(radians(degreesAbove)), -std::cos(radians(degreesAbove)), 0);
    look(seen, DVec3(0, 1.5, 0) - 0.5 * down, DVec3(0, 1.5, 0));
    const Retrace sample = Tracing(seen, toDepth(6)).retrace();
    std::vector<double> angles;
    int parent = -1;
    for (std::size_t i = 0; i < sample.rays.size(); ++i) {
        const RayRecord& ray = sample.rays[i];
        if (ray.parent != parent || (ray.kind != RayKind::Refraction && ray.kind != RayKind::Eye)) continue;
        angles.push_back(degrees(std::acos(std::fabs(static_cast<double>(ray.direction.y)))));
        parent = static_cast<int>(i);
    }
    return angles;
}

/// Glass from y = 0 to 1 over water from −1 to `top`.
Scene glassOverWater(double top, bool glassFirst) {
    Scene scene = underSky(Color(1));
    const auto addGlass = [&] { add(scene, Box{{99, 1, 99}}, glass(1.5F), at({0, 0.5, 0})); };
    if (glassFirst) addGlass();
    add(scene, Box{{99, static_cast<float>(top + 1), 99}}, glass(1.33F), at({0, (top - 1) / 2, 0}));
    if (!glassFirst) addGlass();
    return scene;
}

TEST(WaterAgainstGlass, BendsByTheirRatioModelledOverlapping) {
    const double outside = 48.590378; // 30° in glass
    for (const bool glassFirst : {true, false}) {
        const auto angles = anglesThrough(glassOverWater(0.01, glassFirst), outside);
        ASSERT_EQ(angles.size(), 5U);
        EXPECT_NEAR(angles[1], 30, 0.01);
        EXPECT_NEAR(angles[2], 30, 0.01) << "the face of the water within the glass bends nothing";
        EXPECT_NEAR(angles[3], 34.33, 0.01) << "glass to water, not by way of air";
        EXPECT_NEAR(angles[4], outside, 0.01);
    }
}

TEST(WaterAgainstGlass, BendsByTheirRatioWhereTheirFacesCoincide) {
    const double outside = 48.590378;
    for (const bool glassFirst : {true, false}) {
        const auto angles = anglesThrough(glassOverWater(0, glassFirst), outside);
        ASSERT_EQ(angles.size(), 5U);
        EXPECT_NEAR(angles[1], 30, 0.01);
        EXPECT_NEAR(angles[3], 34.33, 0.01) << "glass to water";
        EXPECT_NEAR(angles.back(), outside, 0.01);
    }
}

/// A hollow ball of glass, full of water whose facets are those of the glass, or reach a little `into` it.
Scene fullBall(float into, bool glassFirst) {
    TriangleMesh shell = cases::closedMesh(20, 30, 1);
    const TriangleMesh inner = cases::closedMesh(20, 30, 0.8);
    const auto first = static_cast<std::uint32_t>(shell.positions.size());
    shell.positions.insert(shell.positions.end(), inner.positions.begin(), inner.positions.end());
    for (const auto& [a, b, c] : inner.triangles)
        shell.triangles.push_back({first + a, first + c, first + b});

    Scene scene = underSky(Color(1));
    scene.environment = {Color(0.2F, 0.3F, 0.4F), Color(0.9F, 0.8F, 0.6F), Color(0.1F, 0.6F, 0.2F)};
    const auto addGlass = [&] { add(scene, shell, glass(1.5F, Color(0.95F, 1, 0.97F))); };
    if (glassFirst) addGlass();
    add(scene, inner, glass(1.33F, Color(0.9F, 0.95F, 1), Color(0.3F, 0.1F, 0.05F)),
        glm::scale(DMat4(1), DVec3(1 + into)));
    if (!glassFirst) addGlass();
    look(scene, {0, 0.3, 4}, {0, 0, 0}, 35);
    return scene;
}

TEST(WaterAgainstGlass, LooksTheSameCoincidingAndOverlapping) {
    for (const bool glassFirst : {true, false}) {
        const auto coinciding = Tracing(fullBall(0, glassFirst), toDepth(8), 64, 64).radiance();
        const auto overlapping = Tracing(fullBall(1e-4F, glassFirst), toDepth(8), 64, 64).radiance();
        double difference = 0, sum = 0;
        for (std::size_t i = 0; i < coinciding.size(); ++i) {
            difference += glm::length(DVec3(coinciding[i]) - DVec3(overlapping[i]));
            sum += glm::length(DVec3(overlapping[i]));
        }
        EXPECT_LT(difference, 0.01 * sum) << glassFirst;
    }
}

}
}
