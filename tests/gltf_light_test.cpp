// labels: unit
// Lamps and cameras.
#include <gtest/gtest.h>

#include "tests/gltf_builder.h"

namespace eyeray {
namespace {

using test::GltfBuilder;
using test::import;
using test::Imported;
using test::json;

void expectNear(const DVec3& a, const DVec3& b, double tolerance = 1e-12) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

json eyeray(json content) { return {{"eyeray", std::move(content)}}; }

GltfBuilder withLamp(const json& lamp) {
    GltfBuilder b;
    b.doc["extensions"]["KHR_lights_punctual"]["lights"] = json::array({lamp});
    b.root({{"name", "lamp node"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return b;
}

GltfBuilder withCamera(json node, const json& perspective = {{"yfov", 0.8}, {"znear", 0.1}}) {
    GltfBuilder b;
    b.push("cameras", {{"type", "perspective"}, {"perspective", perspective}});
    node["camera"] = 0;
    b.root(node);
    return b;
}

TEST(GltfLamps, ArePhotometricInTheFileAndRadiometricInside) {
    const Light point =
        import(withLamp({{"type", "point"}, {"intensity", 683}, {"color", {1, 0.5, 0.25}}, {"range", 7}}))
            .scene.lights.at(0);
    EXPECT_TRUE(std::holds_alternative<PointLamp>(point.shape));
    EXPECT_DOUBLE_EQ(point.intensity, 1);
    EXPECT_EQ(point.color, Color(1, 0.5, 0.25));
    EXPECT_EQ(point.range, 7);
    EXPECT_EQ(point.name, "lamp node");
    EXPECT_TRUE(point.falloff && point.enabled && !point.followsCamera);

    const Light sun = import(withLamp({{"type", "directional"}})).scene.lights.at(0);
    EXPECT_TRUE(std::holds_alternative<DirectionalLamp>(sun.shape));
    EXPECT_DOUBLE_EQ(sun.intensity, 1.0 / 683);
    EXPECT_EQ(sun.range, std::numeric_limits<double>::infinity());
}

TEST(GltfLamps, WithoutFalloffHavePlainNumbers) {
    const Light lamp =
        import(
            withLamp({{"type", "point"},
                      {"intensity", 2},
                      {"extras", eyeray({{"falloff", false}, {"enabled", false}, {"followsCamera", true}})}}))
            .scene.lights.at(0);
    EXPECT_EQ(lamp.intensity, 2);
    EXPECT_TRUE(!lamp.falloff && !lamp.enabled && lamp.followsCamera);
}

TEST(GltfLamps, SpotsKeepTheirConesInOrder) {
    const auto spotOf = [](const json& cones) {
        return std::get<SpotLamp>(
            import(withLamp({{"type", "spot"}, {"spot", cones}})).scene.lights.at(0).shape);
    };
    EXPECT_DOUBLE_EQ(spotOf({{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}).innerCone, 0.2);
    EXPECT_DOUBLE_EQ(spotOf({{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}).outerCone, 0.6);
    EXPECT_NEAR(spotOf(json::object()).outerCone, kPiD / 4, 1e-9);
    EXPECT_LT(spotOf({{"innerConeAngle", 1.2}, {"outerConeAngle", 0.6}}).innerCone, 0.6);
    EXPECT_LE(spotOf({{"outerConeAngle", 9}}).outerCone, kPiD / 2);
}

TEST(GltfLamps, WithAnAreaStandInExtras) {
    GltfBuilder b;
    b.root({{"extras", eyeray({{"lamp",
                                {{"type", "rectangle"},
                                 {"width", 2},
                                 {"height", 3},
                                 {"color", {1, 2, 3}},
                                 {"intensity", 5}}}})},
            {"translation", {0, 4, 0}}});
    b.root({{"extras", eyeray({{"lamp", {{"type", "sphere"}, {"radius", 0.25}, {"falloff", false}}}})}});
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(std::get<RectangleLamp>(scene.lights[0].shape).width, 2);
    EXPECT_EQ(std::get<RectangleLamp>(scene.lights[0].shape).height, 3);
    EXPECT_EQ(scene.lights[0].color, Color(1, 2, 3));
    EXPECT_EQ(scene.lights[0].intensity, 5); // radiance, not candela
    expectNear(DVec3(scene.lights[0].transform[3]), {0, 4, 0});
    EXPECT_EQ(std::get<SphereLamp>(scene.lights[1].shape).radius, 0.25);
    EXPECT_FALSE(scene.lights[1].falloff);
}

TEST(GltfCameras, LookAlongMinusZOfTheirNode) {
    const double half = std::sqrt(0.5);
    const Camera camera = import(withCamera({{"name", "view"},
                                             {"translation", {1, 2, 3}},
                                             {"rotation", {0, half, 0, half}}, // 90° about y
                                             {"extras", eyeray({{"distance", 4}})}},
                                            {{"yfov", 0.8}, {"znear", 0.1}, {"aspectRatio", 1.5}}))
                              .scene.cameras.at(0);
    EXPECT_EQ(camera.name, "view");
    EXPECT_EQ(camera.verticalFov, 0.8);
    EXPECT_EQ(camera.aspect, 1.5);
    expectNear(camera.eye, {1, 2, 3});
    expectNear(camera.target, {-3, 2, 3});
    expectNear(camera.up, {0, 1, 0});
}

TEST(GltfCameras, KeepTheirRoll) {
    const double half = std::sqrt(0.5);
    const Camera camera =
        import(withCamera({{"rotation", {0, 0, half, half}}})).scene.cameras.at(0); // 90° about z
    expectNear(camera.up, {-1, 0, 0});
    expectNear(axesOf(camera).right, {0, 1, 0});
}

TEST(GltfCameras, AimLevelWithTheMiddleOfTheScene) {
    GltfBuilder b = withCamera({{"translation", {0.5, 0.5, 10}}});
    b.triangle();
    expectNear(import(b).scene.cameras.at(0).target, {0.5, 0.5, 0});
}

TEST(GltfCameras, ThatLookAwayStillHaveATargetAhead) {
    GltfBuilder b = withCamera({{"translation", {0, 0, -10}}});
    b.triangle();
    const Camera camera = import(b).scene.cameras.at(0);
    EXPECT_LT(camera.target.z, -10.01);
}

TEST(GltfCameras, WithoutPerspectiveAreReported) {
    GltfBuilder b;
    b.push("cameras", {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 10}, {"znear", 0}}}});
    b.root({{"camera", 0}});
    const Imported imported = import(b);
    EXPECT_EQ(imported.ignored("orthographic projection of 1 camera"), 1);
    EXPECT_EQ(imported.scene.cameras.size(), 1U); // the added one
}

}
}
