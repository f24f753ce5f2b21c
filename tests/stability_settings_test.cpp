// labels: unit
// Degenerate scenes and settings: nothing that shines, nothing that reflects, normals that cancel, things
// very far away, the widest fields of view (stability F64).

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TileResult seenBy(const Scene& scene, Method method) {
    TraceSettings settings = toDepth(5);
    settings.method = method;
    TileResult tile = Tracing(scene, settings, 24, 18).tile();
    EXPECT_EQ(tile.counts.invalidSamples, 0U);
    EXPECT_TRUE(std::ranges::all_of(tile.radiance, [](const Color& c) { return isFinite(c); }));
    return tile;
}

class EachMethod : public testing::TestWithParam<std::size_t> {
protected:
    Method method() const { return static_cast<Method>(GetParam()); }
};

TEST_P(EachMethod, ShowsASceneWithoutLampsOrSkyInBlack) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, matte(Color(1)), at({0, 0, -4}));
    add(scene, Sphere{1}, glass(1.5F), at({1, 0, -3}));
    for (const Color& c : seenBy(scene, method()).radiance) EXPECT_EQ(c, Color(0));
}

TEST_P(EachMethod, ShowsAMaterialWithoutAnyWeightInBlack) {
    Scene scene = underSky(Color(0.5F));
    add(scene, Box{{9, 9, 1}}, matte(Color(0)), at({0, 0, -4}));
    scene.lights = {lampAt({0, 2, 0}), lampAt({0, 2, 1}, SphereLamp{0.2}),
                    lampAt({1, 2, 0}, RectangleLamp{1, 1})};
    scene.lights[2].transform *= facing({0, -1, -1});
    for (const Color& c : seenBy(scene, method()).radiance) EXPECT_EQ(c, Color(0));
    GltfMaterial nothing;
    nothing.baseColor = Color(0);
    nothing.specular = 0;
    scene.materials[0].model = nothing;
    seenBy(scene, method());
}

TEST_P(EachMethod, ShowsLampsOfNoLightInBlack) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, matte(Color(1)), at({0, -1, 0}));
    scene.lights = {lampAt({0, 2, 0}, PointLamp{}, 0), lampAt({0, 2, 0}, SphereLamp{0.2}, 0),
                    lampAt({1, 2, 0}, RectangleLamp{1, 1}, 0), lampAt({0, 0, 0}, DirectionalLamp{}, 0)};
    for (const Color& c : seenBy(scene, method()).radiance) EXPECT_EQ(c, Color(0));
}

TEST_P(EachMethod, SeesWhatIsVeryFarAway) {
    for (const double distance : {1e2, 1e4, 1e6, 1e9}) { // a start value of 10⁴ for t would hide it
        Scene scene = underSky(Color(0));
        add(scene, Sphere{static_cast<float>(distance)}, glowing(Color(2)), at({0, 0, -2 * distance}));
        look(scene, {0, 0, 0}, {0, 0, -1}, 30);
        for (const Color& c : seenBy(scene, method()).radiance) EXPECT_EQ(c, Color(2)) << distance;
    }
}

TEST_P(EachMethod, SurvivesNormalsThatCancel) {
    TriangleMesh mesh;
    mesh.positions = {{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}};
    mesh.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}; // opposed along the lower edge
    mesh.triangles = {{0, 1, 2}};
    Scene scene = underSky(Color(0.5F));
    add(scene, mesh, mirror(Color(0.5F)));
    scene.lights = {taughtLampAt({0, 2, 2})};
    look(scene, {0, 0, 0}, {0, -1, -3});
    seenBy(scene, method());
}

TEST_P(EachMethod, SurvivesTheWidestAndTheNarrowestFieldOfView) {
    Scene scene = underSky(Color(0.5F));
    add(scene, Sphere{1}, glass(1.5F), at({0, 0, -4}));
    for (const double degrees : {1e-6, 0.01, 179.0, 179.999}) {
        look(scene, {0, 0, 0}, {0, 0, -1}, degrees);
        seenBy(scene, method());
    }
}

TEST_P(EachMethod, SurvivesLampsAndEyesInsideOfThings) {
    Scene scene = underSky(Color(0.5F));
    add(scene, Sphere{1}, glass(1.5F));
    add(scene, Sphere{0.5F}, matte(Color(0.5F)), at({0, 0, -3}));
    scene.lights = {lampAt({0, 0, 0}), lampAt({0, 0, -3}), lampAt({0, 0, 0.001}, SphereLamp{0.1})};
    look(scene, {0, 0, 0}, {0, 0, -3}); // in a lamp that is in glass
    seenBy(scene, method());
    look(scene, {0, 0, -3}, {0, 1, -3});
    seenBy(scene, method());
    look(scene, {1, 0, 0}, {0, 0, 0}); // on a surface
    seenBy(scene, method());
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod, testing::Range(std::size_t{0}, kMethodNames.size()),
                         [](const auto& method) { return std::string(kMethodNames[method.param]); });

}
}
