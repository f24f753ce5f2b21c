// labels: unit
// Patterns and sums: stripes towards the horizon, a checkerboard on its own plane, millions of samples
// (stability F53, F54, F56, 2.8).

#include <gtest/gtest.h>

#include "core/render/film.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

/// A floor of cells of one metre, white where floor(u) + floor(v) is even.
Scene checkeredFloor(const Vec2& textureScale) {
    Scene scene = underSky(Color(0));
    scene.textures = {{"", CheckerTexture{Color(1), Color(0)}}};
    TaughtMaterial floor = matte(Color(0), Color(1));
    floor.ambient = Color(0);
    floor.diffuse = Color(1);
    floor.diffuseTexture.texture = 0;
    floor.diffuseTexture.scale = textureScale;
    add(scene, Plane{}, floor);
    scene.lights = {lampAt({0, 0, 0}, DirectionalLamp{}, kPiD)};
    scene.lights[0].transform = facing({0, -1, 1e-9});
    return scene;
}

// Exact shares of the stripes floor(z) of odd number in whole rows of pixels, from the row under the horizon.
TEST(Stripes, TowardsTheHorizonHaveTheirExactShares) {
    constexpr int kHeight = 512, kWidth = 8, kSamples = 1024;
    Scene scene = checkeredFloor({0, 1});
    look(scene, {0, 1.5, 0}, {0, 1.5, -1}, 45);
    const Tracing tracing(scene, casting(), kWidth, kHeight);
    for (const auto& [row, share] : {std::pair{5, 0.498946801}, {20, 0.447854110}, {50, 0.0}, {100, 1.0}}) {
        double sum = 0;
        for (int x = 0; x < kWidth; ++x)
            for (int pass = 1; pass <= kSamples; ++pass)
                sum += tracing.integrator()
                           .renderTile(tracing.context(),
                                       {x, kHeight / 2 + row, x + 1, kHeight / 2 + row + 1}, pass)
                           .radiance.front()
                           .r;
        EXPECT_NEAR(sum / (kWidth * kSamples), share, 0.002) << row;
    }
}

// A pattern in space, floor(x) + floor(y) + floor(z), flips in 11 % of such pixels: it asks on which side of
// the plane y = 0 rounding has put the point.
TEST(Checkerboard, OnItsOwnPlaneHasNoSpeckles) {
    constexpr int kWidth = 160, kHeight = 120;
    for (const double height : {0.0, 1.0, 1000.0}) {
        Scene scene = checkeredFloor({1, 1});
        scene.objects[0].transform = at({0, height, 0});
        look(scene, {0.37, height + 1.5, 0.21}, {0.5, height, -3}, 50);
        const Tracing tracing(scene, casting(), kWidth, kHeight);
        int pixels = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Retrace sample = tracing.retrace(x, y);
                const RayRecord& eye = sample.rays.front();
                if (eye.object < 0) continue;
                const double u = eye.hit.position.x + tracing.world().origin.x,
                             v = eye.hit.position.z + tracing.world().origin.z;
                const auto nearAnEdge = [](double c) {
                    return std::fabs(c - std::round(c)) < 1e-5 * (1 + std::fabs(c));
                };
                if (nearAnEdge(u) || nearAnEdge(v)) continue;
                const bool even = static_cast<int>(std::floor(u) + std::floor(v)) % 2 == 0;
                ASSERT_EQ(sample.radiance.r > 0.5F, even) << u << " " << v;
                ++pixels;
            }
        EXPECT_GT(pixels, 10'000);
    }
}

// In float, ones stop adding up at 16,777,216, and after a firefly of a million small samples add nothing.
TEST(Film, OfMillionsOfSamplesHasTheirExactMean) {
    constexpr int kPasses = 1 << 25;
    Film film(1, 1);
    TileResult sample{.tile = film.tile(0), .radiance = {Color(0)}, .counts = {}, .complete = true};
    for (int pass = 0; pass < kPasses; ++pass) {
        sample.radiance[0] = Color(1, pass == 0 ? 1e6F : 0.01F, pass % 2 == 0 ? 0.1F : 0.7F);
        film.add(0, sample, pass);
    }
    const Color mean = film.mean(kPasses).at(0, 0);
    EXPECT_EQ(mean.r, 1);
    EXPECT_NEAR(mean.g, 0.01 + 1e6 / kPasses, 1e-6 * 0.04);
    EXPECT_NEAR(mean.b, 0.4, 1e-6);
}

}
}
