// labels: unit
// Streams of rays, several at once, against the same samples traced one ray after the other.

#include <gtest/gtest.h>

#include "app/document/scene_files.h"
#include "tests/geometry_cases.h"
#include "tests/instruction_sets.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

/// One tile of the picture by streams and by single rays: the same bits, the same number of rays.
void expectTheSame(const Tracing& tracing, int pass, int step = 1) {
    const FloatEnvironment environment;
    const TraceContext& context = tracing.context();
    const Tile tile{0, 0, context.width, context.height, step};
    const TileResult streams = tracing.integrator().renderTile(context, tile, pass);
    ASSERT_TRUE(streams.complete);
    std::vector<Color> single;
    const auto keep = [&](int x, int y, const SampleRecord&, const Color& radiance) {
        if (x % step == step / 2 && y % step == step / 2) single.push_back(radiance);
    };
    const auto counts = tracing.integrator().retraceTile(context, tile, pass, keep);
    ASSERT_TRUE(counts);
    ASSERT_EQ(streams.radiance.size(), single.size());
    for (std::size_t i = 0; i < single.size(); ++i)
        ASSERT_TRUE(streams.radiance[i] == single[i])
            << "sample " << i << ": " << streams.radiance[i].r << " " << single[i].r;
    if (step > 1) return;
    EXPECT_EQ(streams.counts.rays, counts->rays);
    EXPECT_EQ(streams.counts.deepest, counts->deepest);
    EXPECT_EQ(streams.counts.invalidSamples, counts->invalidSamples);
}

/// Glass of all shapes, solid and thin, one in the other, coloured, textured, scaled and turned; mirrors; all
/// lamps.
Scene allKinds() {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    scene.environment.nadir = Color(0.2F);
    scene.environment.zenith = {0.1F, 0.2F, 0.7F};
    scene.ambient = Color(0.1F);
    scene.textures.push_back({"", CheckerTexture{{0.9F, 0.8F, 0.7F}, {0.2F, 0.1F, 0.3F}}});
    TaughtMaterial floor = matte(Color(0.7F), Color(0.5F));
    floor.diffuseTexture.texture = 0;
    floor.reflectivity = Color(0.2F);
    TaughtMaterial shiny = matte({0.5F, 0.2F, 0.1F});
    shiny.specular = Color(0.5F);
    TaughtMaterial blinn = shiny;
    blinn.specularModel = SpecularModel::BlinnPhong;
    GltfMaterial clear;
    clear.baseColor = {0.8F, 0.9F, 1}, clear.metallic = 0, clear.roughness = 0, clear.transmission = 0.9F;
    clear.attenuationColor = {0.4F, 0.9F, 0.6F}, clear.attenuationDistance = 0.5F;
    GltfMaterial brushed;
    brushed.baseColor = {1, 0.8F, 0.4F}, brushed.roughness = 0.3F;
    const DMat4 turned = glm::rotate(DMat4(1), 0.7, DVec3(1, 2, 3)),
                squeezed = glm::scale(turned, {1, 0.4, 0.7});
    add(scene, Plane{}, floor, at({0, -1, 0}));
    add(scene, Plane{1.5F, 1.5F, true}, glass(1.4F, {0.9F, 0.5F, 0.4F}), at({-1.2, 0, -2.5}) * turned);
    add(scene, Sphere{0.8F}, glass(1.5F, {0.95F, 0.9F, 0.95F}, {0.2F, 0.1F, 0}), at({-1, -0.2, -4}));
    add(scene, Sphere{0.7F}, glass(1), at({-1, -0.2, -4}));
    add(scene, Sphere{0.8F}, mirror({0.9F, 0.8F, 0.7F}), at({1, -0.2, -5}));
    add(scene, Sphere{0.9F}, shiny, at({2.2, 0.4, -6}) * squeezed);
    add(scene, Sphere{0.6F}, clear, at({0.2, 0.9, -3.5}) * squeezed);
    add(scene, Box{{1, 1, 1}}, glass(1.33F, Color(0.9F)), at({0.2, -0.45, -3}));
    add(scene, Cylinder{1, 0.2F, 0.5F}, brushed, at({1.3, 0, -3}));
    add(scene, Cylinder{1, 0, 0.4F}, blinn, at({-2, 0, -6}));
    Light spot = lampAt({0, 3, -3}, SpotLamp{.innerCone = 0.3, .outerCone = 0.6}, 30);
    spot.transform = spot.transform * facing({0, -1, -0.3});
    Light window = lampAt({-3, 2, -3}, RectangleLamp{1, 1}, 10);
    window.transform = window.transform * facing({1, -0.5, 0});
    Light disc = lampAt({0.8, 1.6, -4}, DiscLamp{0.3}, 5);
    disc.transform = disc.transform * facing({0.1, -0.2, 1});
    Light sun;
    sun.shape = DirectionalLamp{};
    sun.transform = facing({-0.2, -1, -0.4});
    scene.lights = {taughtLampAt({3, 4, 0}, Color(0.6F)),
                    lampAt({-2, 3, -3}, SphereLamp{0.3}, 20),
                    spot,
                    window,
                    disc,
                    sun};
    return scene;
}

Scene withMesh(Scene scene) {
    add(scene, cases::closedMesh(10, 20, 0.5), glass(1.6F, {0.9F, 1, 0.9F}), at({0, 0.8, -4}));
    add(scene, cases::closedMesh(10, 20, 0.5), matte({0.2F, 0.7F, 0.3F}), at({1, 1.2, -5}));
    return scene;
}

/// The usual settings, with a change.
template <class Change>
TraceSettings with(const Change& change) {
    TraceSettings settings;
    change(settings);
    return settings;
}

std::vector<TraceSettings> someSettings() {
    std::vector<TraceSettings> all;
    for (const Method method : {Method::Local, Method::Cast, Method::Whitted})
        for (const GlassShadows glassShadows :
             {GlassShadows::Straight, GlassShadows::OpaqueOnly, GlassShadows::AllBlock})
            all.push_back(with([&](TraceSettings& s) {
                s.method = method;
                s.maxDepth = 7;
                s.cutoff = 0.001F;
                s.glassShadows = glassShadows;
            }));
    all.push_back(toDepth(5));
    all.push_back(with([](TraceSettings& s) { s.maxDepth = 30, s.cutoff = 0.01F; }));
    all.push_back(with([](TraceSettings& s) { s.fresnel = FresnelMode::Constant; }));
    all.push_back(with([](TraceSettings& s) { s.shadows = s.reflections = false; }));
    all.push_back(with([](TraceSettings& s) { s.refractions = false; }));
    return all;
}

TEST(Streams, CarryTheLightOfSingleRaysUnderEverySetting) {
    withEachInstructionSet([] {
        for (const TraceSettings& settings : someSettings())
            for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh8})
                for (const int pass : {0, 3}) {
                    SCOPED_TRACE(static_cast<int>(accel));
                    expectTheSame(Tracing(allKinds(), settings, 24, 16, accel), pass);
                    expectTheSame(Tracing(withMesh(allKinds()), settings, 12, 8, accel), pass);
                }
    });
}

TEST(Streams, TakeTilesLargerThanTheyHaveRoomFor) {
    expectTheSame(Tracing(allKinds(), toDepth(4), 120, 90), 0);
}

TEST(Streams, TakeTilesOfWhichOnlySomePixelsAreAsked) {
    for (const int step : {2, 8, 16}) expectTheSame(Tracing(allKinds(), {}, 64, 48), 0, step);
}

TEST(Streams, CarryTheLightOfSingleRaysThatMeetObjectsOfOneMaterialByTurns) {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    add(scene, Box{{99, 99, 0.1F}}, matte(Color(0.7F)), at({0, 0, -9}));
    for (int i = -20; i <= 20; ++i)
        add(scene, Box{{0.1F, 9, 0.1F}}, matte(Color(0.7F)), at({0.2 * i, 0, -5}));
    for (Object& object : scene.objects) object.material = 0;
    scene.lights = {taughtLampAt({3, 4, 0}, Color(0.6F))};
    for (const int pass : {0, 1}) expectTheSame(Tracing(scene, {}, 48, 32), pass);
}

TEST(Streams, CarryTheLightOfSingleRaysFromInsideGlass) {
    Scene scene = allKinds();
    look(scene, {-1, -0.2, -4.1}, {1, 0, -5});
    expectTheSame(Tracing(scene, with([](TraceSettings& s) { s.maxDepth = 6; }), 40, 30), 0);
}

class EachScene : public testing::TestWithParam<std::string> {};

TEST_P(EachScene, IsTheSameByStreams) {
    const Document document = openScene(GetParam()).document;
    const auto world = buildWorld(document.scene, {});
    for (const int pass : {0, 1}) expectTheSame(Tracing(world, document.render.trace, 48, 32), pass);
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(OfTheProgram, EachScene, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return scene.param; });

}
}
