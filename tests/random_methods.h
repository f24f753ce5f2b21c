#pragma once
// Scenes and estimates for the methods that draw at random.

#include <array>

#include <gtest/gtest.h>

#include "tests/scenes.h"

namespace eyeray::scenes {

inline TraceSettings by(Method method, int depth = 5) {
    TraceSettings settings = toDepth(depth);
    settings.method = method;
    return settings;
}
inline constexpr std::array kPhysical = {Method::Distributed, Method::Path};

/// Mean of the first pixel over passes, with the standard error of its red.
struct Estimate {
    DVec3 mean{0};
    double error = 0;
};
inline Estimate estimate(const Tracing& tracing, int passes) {
    DVec3 sum(0);
    double squares = 0;
    for (int pass = 0; pass < passes; ++pass) {
        const DVec3 c(tracing.tile(pass).radiance.front());
        sum += c;
        squares += c.x * c.x;
    }
    const DVec3 mean = sum / static_cast<double>(passes);
    return {mean, std::sqrt(std::max(0.0, squares / passes - mean.x * mean.x) / passes)};
}

inline void expectMean(const Estimate& e, double truth, double tolerance, const std::string& what = {}) {
    EXPECT_NEAR(e.mean.x, truth, 3.5 * e.error + tolerance) << what << " ± " << e.error;
    EXPECT_LT(e.error, 0.02 * truth + tolerance) << what << ": too noisy to tell";
}

/// A large floor of the albedo seen from straight above.
inline Scene floorBelow(float albedo, const Color& sky = Color(0)) {
    Scene scene = underSky(sky);
    add(scene, Plane{}, matte(Color(albedo)));
    look(scene, {0, 0.5, 0}, {0, 0, 0}, 0.01);
    return scene;
}

/// A box with a lamp in its ceiling, a red wall and two blocks, one of them a rough metal.
inline Scene cornell(const Color& sky = Color(0)) {
    Scene scene = underSky(sky);
    const auto wall = [&](const DVec3& size, const DVec3& center, const Color& color) {
        add(scene, Box{Vec3(size)}, matte(color), at(center));
    };
    wall({2, 0.1, 2}, {0, -1.05, 0}, Color(0.7F));
    wall({2, 0.1, 2}, {0, 1.05, 0}, Color(0.7F));
    wall({0.1, 2, 2}, {-1.05, 0, 0}, {0.7F, 0.1F, 0.1F});
    wall({0.1, 2, 2}, {1.05, 0, 0}, {0.1F, 0.6F, 0.1F});
    wall({2, 2, 0.1}, {0, 0, -1.05}, Color(0.7F));
    wall({0.6, 0.6, 0.6}, {0.4, -0.7, 0.2}, Color(0.8F));
    wall({0.5, 1.2, 0.5}, {-0.4, -0.4, -0.4}, {0.3F, 0.3F, 0.7F});
    Light lamp = lampAt({0, 0.99, 0}, RectangleLamp{0.8, 0.8}, 5);
    lamp.transform = lamp.transform * facing({0, -1, 0});
    scene.lights = {lamp};
    look(scene, {0, 0, 3.6}, {0, 0, 0}, 38);
    return scene;
}

/// Everything at once: rough metal and glass, coats, lamps of all kinds, sky.
inline Scene showroom() {
    Scene scene = cornell({0.1F, 0.2F, 0.4F});
    GltfMaterial metal;
    metal.baseColor = {0.9F, 0.7F, 0.3F};
    metal.roughness = 0.3F;
    GltfMaterial frosted;
    frosted.metallic = 0;
    frosted.roughness = 0.3F;
    frosted.transmission = 1;
    frosted.attenuationColor = {0.5F, 0.9F, 0.9F};
    frosted.attenuationDistance = 0.5F;
    GltfMaterial plastic;
    plastic.baseColor = {0.6F, 0.1F, 0.2F};
    plastic.metallic = 0;
    plastic.roughness = 0.2F;
    add(scene, Sphere{0.3F}, metal, at({-0.5, -0.7, 0.5}));
    add(scene, Sphere{0.25F}, frosted, at({0.4, -0.15, 0.2}));
    add(scene, Sphere{0.2F}, plastic, at({0, -0.8, 0.7}));
    scene.lights.push_back(taughtLampAt({0.5, 0.5, 0.8}, Color(0.2F)));
    scene.lights.push_back(lampAt({-0.7, 0.3, 0.5}, SphereLamp{0.08}, 20));
    return scene;
}

}
