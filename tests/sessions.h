#pragma once
// Scenes and settings for tests of progressive rendering.

#include "core/render/render_session.h"
#include "tests/scenes.h"

namespace eyeray::sessions {

using namespace scenes;
using namespace std::chrono_literals;
using Phase = RenderStatus::Phase;

inline constexpr int kWidth = 80, kHeight = 60;

inline std::shared_ptr<const World> worldOf(const Scene& scene) {
    return buildWorld(std::make_shared<const Scene>(scene), {});
}

/// A ball of glass and one of mirror over a checkered ground: noise at every edge.
inline Scene balls() {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    scene.textures = {{"", CheckerTexture{Color(0.9F), Color(0.1F)}}};
    TaughtMaterial checkered = matte(Color(0.8F), Color(0.8F));
    checkered.diffuseTexture.texture = 0;
    add(scene, Plane{}, checkered, at({0, -1, 0}));
    add(scene, Sphere{1}, glass(1.5F, Color(0.9F)), at({-0.7, 0, -4}));
    add(scene, Sphere{1}, mirror(Color(0.8F)), at({1.2, 0, -5}));
    scene.lights = {taughtLampAt({2, 4, 0})};
    return scene;
}

/// Takes minutes a pixel: mirrors and glass without loss, to the greatest depth.
inline Scene endless() {
    Scene scene = underSky(Color(1));
    add(scene, Box{{4, 4, 4}}, mirror(Color(1)));
    TaughtMaterial both = glass(1.5F);
    both.reflectivity = Color(1);
    add(scene, Sphere{1}, both);
    look(scene, {0.3, 0.2, 1.9}, {0, 0, 0}, 90);
    return scene;
}

inline RenderSettings settingsFor(int samples, int width = kWidth, int height = kHeight) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.stop.samples = samples;
    return settings;
}

inline RenderSettings endlessSettings() {
    RenderSettings settings = settingsFor(4);
    settings.trace = toDepth(kMaxDepth);
    return settings;
}

inline void start(RenderSession& session, const Scene& scene, const RenderSettings& settings) {
    session.start(worldOf(scene), scene.cameras.front(), settings);
}

/// Fails a test that would hang.
inline RenderStatus finished(RenderSession& session) {
    const RenderStatus status = session.wait(120s);
    EXPECT_EQ(status.phase, Phase::Finished) << status.failure;
    return status;
}

inline ColorImage rendered(const Scene& scene, const RenderSettings& settings, int threads = 1) {
    RenderSession session(threads);
    start(session, scene, settings);
    finished(session);
    return session.image();
}

}
