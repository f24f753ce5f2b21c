// labels: unit
// What a scene does not need is left out, says why, and would not have changed a pixel.

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr const char* kNoLamp = "no shadow rays: no lamp shines";
constexpr const char* kNoObject = "no shadow rays: there is no object";
constexpr const char* kNoMirror = "no reflection rays: no material is a mirror or a dielectric";
constexpr const char* kNoGlass = "no refraction rays: no material transmits light";
constexpr const char* kNoTexture = "no texture reads: no material has a texture";

using Reasons = std::vector<std::string>;

Scene ballOf(const MaterialModel& material) {
    Scene scene = underSky({0.4F, 0.5F, 0.6F});
    add(scene, Sphere{1}, material, at({0, 0, -3}));
    return scene;
}

TEST(Needs, OfAnEmptySceneAreNone) {
    const SceneNeeds needs = analyseNeeds(underSky(Color(1)));
    EXPECT_EQ(needs.reasons, (Reasons{kNoLamp, kNoMirror, kNoGlass, kNoTexture}));
    EXPECT_FALSE(needs.shadows || needs.reflections || needs.refractions || needs.textures);
}

TEST(Needs, ForShadowRaysAreALampThatShinesAndAnObject) {
    Scene scene = ballOf(matte(Color(1)));
    EXPECT_EQ(analyseNeeds(scene).reasons.front(), kNoLamp);
    scene.lights = {taughtLampAt({0, 3, 0})};
    EXPECT_TRUE(analyseNeeds(scene).shadows);
    EXPECT_EQ(analyseNeeds(scene).reasons, (Reasons{kNoMirror, kNoGlass, kNoTexture}));
    for (const auto darken : std::initializer_list<void (*)(Light&)>{[](Light& l) { l.enabled = false; },
                                                                     [](Light& l) { l.intensity = 0; },
                                                                     [](Light& l) { l.color = Color(0); }}) {
        Scene dark = scene;
        darken(dark.lights[0]);
        EXPECT_EQ(analyseNeeds(dark).reasons.front(), kNoLamp);
    }
    scene.objects[0].visible = false;
    EXPECT_EQ(analyseNeeds(scene).reasons.front(), kNoObject);
}

TEST(Needs, OfMirrorsAndGlassAreTheirRays) {
    const SceneNeeds ofMirror = analyseNeeds(ballOf(mirror(Color(0, 0, 0.1F))));
    EXPECT_TRUE(ofMirror.reflections && !ofMirror.refractions);
    const SceneNeeds ofGlass = analyseNeeds(ballOf(glass(1.5F)));
    EXPECT_TRUE(ofGlass.reflections && ofGlass.refractions);
    Scene hidden = ballOf(glass(1.5F));
    hidden.objects[0].visible = false;
    EXPECT_FALSE(analyseNeeds(hidden).refractions);
}

TEST(Needs, ForTexturesAreThoseOfVisibleMaterialsAndVertices) {
    Scene scene = ballOf(matte(Color(1)));
    EXPECT_FALSE(analyseNeeds(scene).textures);
    std::get<TaughtMaterial>(scene.materials[0].model).diffuseTexture.texture = 0;
    EXPECT_TRUE(analyseNeeds(scene).textures);

    Scene colored = underSky(Color(0));
    TriangleMesh mesh = cases::closedMesh(4, 6, 1);
    mesh.colors.assign(mesh.positions.size(), Vec4(1, 0, 0, 1));
    add(colored, mesh, matte(Color(1)));
    EXPECT_TRUE(analyseNeeds(colored).textures);
}

/// A scene with each of these materials on a ball of its own.
Scene manyBalls(const std::vector<MaterialModel>& materials) {
    Scene scene = underSky({0.4F, 0.5F, 0.6F});
    scene.textures = {{"", CheckerTexture{Color(1), Color(0)}}};
    scene.lights = {taughtLampAt({2, 5, 3})};
    add(scene, Plane{20, 20, true}, matte(Color(0.5F)), at({0, -1, -6}));
    for (std::size_t i = 0; i < materials.size(); ++i)
        add(scene, Sphere{0.4F}, materials[i], at({static_cast<double>(i) - 2, -0.3, -6}));
    return scene;
}

GltfMaterial gltf(float metallic, float roughness, float transmission = 0) {
    GltfMaterial m;
    m.metallic = metallic;
    m.roughness = roughness;
    m.transmission = transmission;
    return m;
}

std::vector<std::vector<MaterialModel>> materialCases() {
    GltfMaterial blackMetal = gltf(1, 0.1F), noSpecular = gltf(0, 0), textured = gltf(1, 1),
                 window = gltf(1, 1, 1);
    blackMetal.baseColor = Color(0);
    noSpecular.specular = 0;
    textured.metallicRoughnessTexture.texture = 0;
    window.metallicRoughnessTexture.texture = 0;
    GltfMaterial noSpecularColor = gltf(0, 0.2F);
    noSpecularColor.specularColor = Color(0);
    TaughtMaterial checkered = matte(Color(0.7F));
    checkered.diffuseTexture.texture = 0;
    return {{matte(Color(0.6F)), glowing(Color(2))},
            {matte(Color(0.6F)), checkered},
            {mirror(Color(0.5F)), glass(1.5F, Color(0.8F))},
            {gltf(0, 1), gltf(1, 1)},
            {gltf(0, 0.5F), gltf(1, 0)},
            {blackMetal},
            {noSpecular},
            {noSpecularColor},
            {textured},
            {window, checkered},
            {gltf(0, 0, 1), gltf(0.5F, 0.2F, 0.5F)}};
}

TEST(Needs, LeaveOutOnlyWhatChangesNoPixel) {
    constexpr int kWidth = 48, kHeight = 32;
    for (std::size_t i = 0; i < materialCases().size(); ++i) {
        const Tracing lean(manyBalls(materialCases()[i]), toDepth(4), kWidth, kHeight);
        World all = lean.world();
        all.needs.shadows = all.needs.reflections = all.needs.refractions = all.needs.textures = true;
        const Tracing full(std::make_shared<const World>(all), toDepth(4), kWidth, kHeight);
        const TileResult leanTile = lean.tile(), fullTile = full.tile();
        EXPECT_EQ(leanTile.radiance, fullTile.radiance) << "case " << i;
        EXPECT_EQ(leanTile.counts.rays, fullTile.counts.rays) << "case " << i;
        const SceneNeeds& needs = lean.world().needs;
        EXPECT_TRUE(needs.reflections || leanTile.counts[RayKind::Reflection] == 0);
        EXPECT_TRUE(needs.refractions || leanTile.counts[RayKind::Refraction] == 0);
    }
}

TEST(Needs, OfPhysicalMethodsLeaveOutOnlyWhatChangesNoPixel) {
    constexpr int kWidth = 48, kHeight = 32;
    for (const Method method : {Method::Distributed, Method::Path})
        for (std::size_t i = 0; i < materialCases().size(); ++i) {
            TraceSettings settings = toDepth(4);
            settings.method = method;
            const Tracing lean(manyBalls(materialCases()[i]), settings, kWidth, kHeight);
            World all = lean.world();
            all.needs.refractions = all.needs.textures = true;
            all.needs.physical = {true, true, true, {}};
            const Tracing full(std::make_shared<const World>(all), settings, kWidth, kHeight);
            const TileResult leanTile = lean.tile(), fullTile = full.tile();
            EXPECT_EQ(leanTile.radiance, fullTile.radiance) << "case " << i;
            EXPECT_EQ(leanTile.counts.rays, fullTile.counts.rays) << "case " << i;
        }
}

TEST(Needs, OfPhysicalMethodsAreLightCoatAndBody) {
    const auto reasonsOf = [](const Scene& scene) { return analyseNeeds(scene).physical.reasons; };
    const char* const noGloss = "no reflection rays: every material is matte";
    const char* const noBody = "no diffuse rays: no material is matte";
    EXPECT_EQ(reasonsOf(ballOf(matte(Color(1)))), (Reasons{noGloss, kNoGlass, kNoTexture})) << "under a sky";
    EXPECT_EQ(reasonsOf(ballOf(mirror(Color(1)))), (Reasons{kNoGlass, noBody, kNoTexture}));
    EXPECT_EQ(reasonsOf(ballOf(gltf(0, 1))), (Reasons{kNoGlass, kNoTexture})) << "its coat reflects";

    Scene dark = ballOf(matte(Color(1)));
    dark.environment = {};
    EXPECT_EQ(reasonsOf(dark).front(), "no shadow rays: no lamp, sky or object shines");
    add(dark, Sphere{1}, glowing(Color(1)), at({3, 0, -3}));
    EXPECT_TRUE(analyseNeeds(dark).physical.shadows);
    for (Object& object : dark.objects) object.visible = false;
    EXPECT_FALSE(analyseNeeds(dark).physical.shadows);
}

TEST(Needs, OfTexturedGlassLetShadowRaysThrough) {
    // The factor says metal all over, its texture says glass in every other cell.
    GltfMaterial window = gltf(1, 1, 1);
    window.metallicRoughnessTexture.texture = 0;
    Scene scene = underSky(Color(0));
    scene.textures = {{"", CheckerTexture{Color(0), Color(1)}}};
    scene.lights = {taughtLampAt({0.5, 3, 0.5})};
    add(scene, Plane{}, matte(Color(1)));
    add(scene, Plane{10, 10, true}, window, at({0, 1, 0}));
    const auto floorAt = [&](double x) {
        look(scene, {x, 0.5, 0.5}, {x, 0, 0.5});
        return Tracing(scene).pixel().g;
    };
    EXPECT_NEAR(floorAt(0.5), 1, 1e-5) << "glass";
    EXPECT_EQ(floorAt(2), 0) << "metal";
}

}
}
