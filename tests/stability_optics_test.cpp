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
        EXPECT_NEAR(angles[2], 34.33, 0.01) << "glass to water, not by way of air";
        EXPECT_NEAR(angles[3], 34.33, 0.01) << "the face of the glass within the water bends nothing";
        EXPECT_NEAR(angles[4], outside, 0.01);
    }
}

}
}
