// labels: unit robustness
// F34: a facet turned away from the lamp shades what its normals call lit. A lamp beside a ball of facets,
// where the light ends amid facets; its smooth surface shades itself nowhere.

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

constexpr int kSize = 256;
constexpr std::array kFacets = {8, 16, 32, 64, 128};

TriangleMesh smoothBall(int facets) {
    TriangleMesh mesh = cases::closedMesh(facets / 2, facets, 1);
    for (const Vec3& position : mesh.positions) mesh.normals.push_back(glm::normalize(position));
    return mesh;
}

Scene litFromTheSide(int facets, const MaterialModel& material) {
    Scene scene = scenes::underSky(Color(0));
    scenes::look(scene, DVec3(0, 0.5, 10), DVec3(0), 12.5);
    scenes::add(scene, smoothBall(facets), material, glm::rotate(DMat4(1), kPiD / facets, DVec3(0, 1, 0)));
    scene.lights.push_back(scenes::taughtLampAt(DVec3(1e4, 0, 0)));
    return scene;
}

std::vector<Color> picture(const Scene& scene, Method method, bool shadows) {
    TraceSettings settings = scenes::toDepth(1);
    settings.method = method;
    settings.shadows = shadows;
    settings.diffuse = false; // no light from one facet to the other
    return scenes::Tracing(scene, settings, kSize, kSize).tile().radiance;
}

TEST(ShadowTerminator, NoFacetOfAConvexMeshIsBlackThatItsNormalsCallLit) {
    for (const int facets : kFacets) {
        const Scene scene = litFromTheSide(facets, scenes::matte(Color(1)));
        EXPECT_EQ(picture(scene, Method::Cast, true), picture(scene, Method::Cast, false)) << facets;
    }
}

TEST(ShadowTerminator, NorIsOneByThePhysicalMethods) {
    for (const int facets : kFacets) {
        const Scene scene = litFromTheSide(facets, scenes::matte(Color(1)));
        EXPECT_EQ(picture(scene, Method::Path, true), picture(scene, Method::Path, false)) << facets;
    }
}

TEST(ShadowTerminator, LightFallsOffWithoutAStep) {
    for (const int facets : kFacets) {
        const Scene scene = litFromTheSide(facets, scenes::matte(Color(1)));
        const std::vector<Color> pixels = picture(scene, Method::Cast, true);
        const std::size_t row = static_cast<std::size_t>(kSize) * (kSize / 2);
        for (std::size_t x = kSize / 4; x < 3 * kSize / 4; ++x) {
            const float step = pixels[row + x + 1].r - pixels[row + x].r;
            EXPECT_GE(step, 0) << facets << " facets, pixel " << x;
            EXPECT_LT(step, 0.02F) << facets << " facets, pixel " << x;
        }
    }
}

// Those of a ball of half a facet's angle: 48, 25, 12 % of the half of the disc that is lit.
TEST(ShadowTerminator, FacetsThatFaceAwayAreManyInACoarseMesh) {
    for (const int facets : {8, 16, 32}) {
        const double angle = kPiD / facets;
        const double share = 2 / kPiD * (std::sin(angle) * std::cos(angle) + angle);
        const Scene scene = litFromTheSide(facets, scenes::matte(Color(1)));
        const scenes::Tracing tracing(scene, scenes::casting(), kSize, kSize);
        int lit = 0, facingAway = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const Retrace sample = tracing.retrace(x, y);
                if (sample.lamps.empty() || isBlack(sample.lamps[0].diffuse)) continue;
                ++lit;
                if (glm::dot(sample.rays[0].hit.geometricNormal, sample.lamps[0].wi) <= 0) ++facingAway;
            }
        EXPECT_NEAR(facingAway, share * lit, 0.15 * share * lit) << facets;
    }
}

}
}
