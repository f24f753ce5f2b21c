// labels: unit
// Highlights of any shininess, and lit balls of known brightness (stability F33, 2.2).

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TEST(Highlight, OfAnyShininessIsFiniteAndDarkOnTheUnlitSide) {
    cases::Random random(1);
    int dark = 0;
    for (const SpecularModel model : {SpecularModel::Phong, SpecularModel::BlinnPhong})
        for (const float shininess : {0.0F, 0.5F, 1.0F, 10.5F, 1000.0F, 1e6F})
            for (int i = 0; i < 100; ++i) {
                TaughtMaterial material = matte(Color(0.5F));
                material.specular = Color(1);
                material.shininess = shininess;
                material.specularModel = model;
                Scene scene = underSky(Color(0));
                add(scene, Sphere{1}, material);
                const DVec3 eye = 3.0 * random.direction(), lamp = 3.0 * random.direction();
                scene.lights = {taughtLampAt(lamp)};
                look(scene, eye, 0.9 * random.direction());
                const Retrace sample = Tracing(scene, casting()).retrace();
                ASSERT_TRUE(isFinite(sample.radiance) && minComponent(sample.radiance) >= 0);
                const RayRecord& ray = sample.rays.front();
                if (ray.object < 0) continue;
                const DVec3 p = eye + static_cast<double>(ray.t) * DVec3(ray.direction);
                if (glm::dot(p, lamp - p) > -1e-5) continue;
                ASSERT_EQ(sample.radiance, Color(0)) << shininess;
                ++dark;
            }
    EXPECT_GT(dark, 200);
}

/// Mean over its silhouette of what a ball shows whose albedo is ½ under a distant lamp of irradiance π,
/// which stands `phase` degrees from the eye.
double meanOfDisk(double phase) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, matte(Color(0.5F)));
    scene.lights = {lampAt({0, 0, 0}, DirectionalLamp{}, kPiD)};
    scene.lights[0].transform = facing({-std::sin(radians(phase)), 0, -std::cos(radians(phase))});
    look(scene, {0, 0, 1e4}, {0, 0, 0}, degrees(2 * std::atan(1.02e-4)));
    constexpr int kSide = 400;
    const Tracing tracing(scene, casting(), kSide, kSide);
    double sum = 0;
    for (const Color& c : tracing.radiance()) sum += c.r;
    const double diskPixels = kPiD / 4 * kSide * kSide / (1.02 * 1.02);
    return sum / diskPixels;
}

TEST(LambertBall, HasTheBrightnessOfItsPhase) {
    const double full = meanOfDisk(0);
    EXPECT_NEAR(full, 1.0 / 3, 3e-4);
    EXPECT_NEAR(meanOfDisk(90) / full, 1 / kPiD, 1e-3);
    EXPECT_NEAR(meanOfDisk(180) / full, 0, 1e-9);
}

}
}
