// Where light is bent, lost or found too often.

#include <fmt/format.h>

#include "core/study/lab_kit.h"
#include "core/study/lab_scenes.h"

namespace eyeray::lab {
namespace {

void addRoom(Scene& scene) {
    const TaughtMaterial wall = matte({0.70F, 0.68F, 0.64F});
    add(scene, "floor", Plane{6, 6, true}, wall);
    add(scene, "back", Plane{6, 4, true}, wall, at({0, 2, -3}) * upright());
}

std::string samplesSetting(double samples) {
    return fmt::format("set samples={} error=0", static_cast<int>(samples));
}

}

Scene insideGlass(double angle) {
    Scene scene = underDaySky();
    add(scene, "ground", Plane{190, 190, true},
        checkered(scene, {0.85F, 0.82F, 0.75F}, {0.15F, 0.30F, 0.20F}),
        at({0, -1.9, 0})); // in the glass, just above its lower face
    add(scene, "glass", Box{{200, 4, 200}}, glass());
    add(scene, "ball", Sphere{1.5F}, matte({0.8F, 0.2F, 0.12F}), at({-1.5, 6, -5}));
    scene.ambient = Color(0.8F);
    const double theta = radians(angle);
    look(scene, {0, -1.2, 0}, {0, -1.2 + std::cos(theta), -std::sin(theta)}, 30);
    scene.cameras.front().up = DVec3(0, 1, 0);
    scene.settings = {"set method=whitted max-depth=6 shadows=off"};
    return scene;
}

Scene smoothBall(double segments) {
    Scene scene = underSky({0.04F, 0.05F, 0.08F}, {0.06F, 0.07F, 0.10F});
    add(scene, "ball", ballMesh(std::max(3, static_cast<int>(segments) / 2)), matte({0.80F, 0.72F, 0.60F}));
    addLamp(scene, {-8, 2, -3});
    look(scene, {0, 0, 5}, {0, 0, 0}, 30);
    scene.settings = {"set method=cast"};
    return scene;
}

Scene mirrorTunnel(double /*depth*/) {
    Scene scene = underSky(Color(0), Color(0));
    constexpr float kLength = 30;
    const DMat4 below = at({0, -1, -kLength / 2});
    for (int side = 0; side < 4; ++side)
        add(scene, "mirror", Plane{2, kLength}, mirror(Color(0.9F)),
            glm::rotate(DMat4(1), side * kPiD / 2, DVec3(0, 0, 1)) * below);
    add(scene, "end", Plane{2, 2, true}, glowing({0.75F, 0.40F, 0.12F}), at({0, 0, -kLength}) * upright());
    add(scene, "disc", Sphere{0.45F}, glowing({0.25F, 0.55F, 1.0F}), at({0.3, 0.2, -kLength}));
    look(scene, {0.2, 0.1, 0}, {0.2, 0.1, -1}, 62);
    scene.settings = {"set method=whitted max-depth=64 cutoff=0 samples=16"};
    return scene;
}

Scene faintRays(double /*cutoff*/) { return mirrorTunnel(0); }

Scene whiteRoom(double albedo) {
    Scene scene = underSky(Color(0), Color(0));
    const TaughtMaterial wall = matte(Color(static_cast<float>(albedo)));
    for (int side = 0; side < 4; ++side)
        add(scene, "wall", Plane{4, 6}, wall,
            glm::rotate(DMat4(1), side * kPiD / 2, DVec3(0, 0, 1)) * at({0, -2, 0}));
    for (const double end : {-3.0, 3.0})
        add(scene, "end", Plane{4, 4, true}, wall, at({0, 0, end}) * upright());
    add(scene, "ball", Sphere{0.9F}, matte({0.75F, 0.25F, 0.18F}), at({-0.7, -1.1, -0.8}));
    add(scene, "block", Box{{1, 1.8F, 1}}, wall,
        at({1, -1.1, -0.4}) * glm::rotate(DMat4(1), radians(25), DVec3(0, 1, 0)));
    Light lamp;
    lamp.name = "lamp";
    lamp.shape = RectangleLamp{1.2, 1.2};
    lamp.intensity = 3;
    lamp.transform = at({0, 1.99, -0.5}) * glm::rotate(DMat4(1), -kPiD / 2, DVec3(1, 0, 0));
    scene.lights.push_back(lamp);
    look(scene, {0, 0, 2.9}, {0, -0.1, -3}, 62);
    scene.settings = {"set method=path max-depth=16 samples=8 error=0"};
    return scene;
}

Scene caustic(double /*clamp*/) {
    constexpr double kRadius = 0.1;
    Scene scene = underSky(Color(0), Color(0));
    addRoom(scene);
    add(scene, "glass ball", Sphere{0.8F}, glass(), at({-0.5, 1.0, 0}));
    add(scene, "metal ball", Sphere{0.5F}, mirror({0.9F, 0.75F, 0.45F}), at({1.3, 0.5, 0.4}));
    Light lamp;
    lamp.name = "lamp";
    lamp.shape = SphereLamp{kRadius};
    lamp.intensity = 6 / (kRadius * kRadius);
    lamp.transform = at({-1.8, 3.4, 0.6});
    scene.lights.push_back(lamp);
    look(scene, {0.3, 3.4, 5.6}, {0.3, 0.2, 0.2}, 36);
    scene.settings = {"set method=path max-depth=8 samples=64 error=0"};
    return scene;
}

Scene softShadow(double samples) {
    Scene scene = underSky(Color(0.02F), Color(0.02F));
    addRoom(scene);
    add(scene, "ball", Sphere{0.8F}, matte({0.75F, 0.25F, 0.18F}), at({-0.6, 0.8, 0}));
    add(scene, "block", Box{{0.9F, 1.4F, 0.9F}}, matte({0.25F, 0.45F, 0.70F}),
        at({1.2, 0.7, -0.4}) * glm::rotate(DMat4(1), radians(25), DVec3(0, 1, 0)));
    Light lamp;
    lamp.name = "lamp";
    lamp.shape = RectangleLamp{1.6, 1.6};
    lamp.intensity = 5;
    lamp.transform = at({-0.6, 4, 1.4}) * glm::rotate(DMat4(1), -kPiD / 2, DVec3(1, 0, 0));
    scene.lights.push_back(lamp);
    look(scene, {0.3, 2.6, 6}, {0.2, 0.5, 0}, 36);
    scene.settings = {"set method=distributed", samplesSetting(samples)};
    return scene;
}

Scene checkerPlain(double samples) {
    Scene scene = underDaySky();
    add(scene, "plain", Plane{}, checkered(scene, Color(0.9F), Color(0.04F)));
    scene.ambient = Color(1);
    look(scene, {0.31, 1.5, 0}, {0.2, 0.9, -3}, 45);
    scene.settings = {"set method=cast", samplesSetting(samples)};
    return scene;
}

}
