// labels: unit
// Files, nodes, shapes, and the scene as a whole.
#include "core/scene/gltf.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/gltf_builder.h"
#include "tests/temporary_folder.h"

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

GltfBuilder withShape(const json& shape) {
    GltfBuilder b;
    b.doc["extensions"]["KHR_implicit_shapes"]["shapes"] = json::array({shape});
    b.push("materials", json::object());
    b.root({{"extras", eyeray({{"shape", 0}, {"material", 0}})}});
    return b;
}

TEST(GltfFile, IsTheSameAsTextBinaryAndWithItsBufferBeside) {
    GltfBuilder b;
    b.triangle();
    const TemporaryFolder folder;
    writeText(folder / "the buffer+1.bin", {reinterpret_cast<const char*>(b.buffer.data()), b.buffer.size()});
    writeText(folder / "beside.gltf", b.gltf("the%20buffer+1.bin"));
    ImportReport report;
    const Scene beside = importGltf(folder / "beside.gltf", report);
    EXPECT_EQ(beside.name, "beside");
    for (const Scene& scene : {import(b.gltf()).scene, import(b.glb()).scene, beside}) {
        ASSERT_EQ(scene.objects.size(), 1U);
        EXPECT_EQ(test::meshOf(scene).positions[2], Vec3(0, 1, 0));
        EXPECT_EQ(test::meshOf(scene).triangles.size(), 1U);
    }
}

TEST(GltfFile, FromMemoryReachesForNoOtherFile) {
    GltfBuilder b;
    b.triangle();
    EXPECT_THROW(import(b.gltf("buffer.bin")), InputError);
}

TEST(GltfFile, StopsWhenAsked) {
    GltfBuilder b;
    b.triangle();
    const std::stop_source source;
    source.request_stop();
    ImportReport report;
    const std::string text = b.gltf();
    const Scene scene = importGltf(std::as_bytes(std::span(text)), "test.gltf", report, source.get_token());
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_TRUE(scene.cameras.empty());
}

TEST(GltfNodes, MultiplyTranslationRotationAndScaleFromParentToChild) {
    GltfBuilder b;
    const int mesh = b.triangle();
    const double half = std::sqrt(0.5);
    const int child = b.push("nodes", {{"mesh", mesh}, {"scale", {2, 3, 4}}, {"translation", {1, 0, 0}}});
    b.root({{"rotation", {0, 0, half, half}},
            {"translation", {10, 20, 30}},
            {"children", {child}}}); // 90° about z
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 2U);
    const DMat4& m = scene.objects[1].transform;
    expectNear(transformPoint(m, {0, 0, 0}), {10, 21, 30});
    expectNear(transformVector(m, {1, 0, 0}), {0, 2, 0});
    expectNear(transformVector(m, {0, 1, 0}), {-3, 0, 0});
    expectNear(transformVector(m, {0, 0, 1}), {0, 0, 4});
}

TEST(GltfNodes, TakeAMatrixColumnByColumn) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.root({{"mesh", mesh}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1}}});
    const DMat4 m = import(b).scene.objects[1].transform;
    expectNear(transformPoint(m, {1, 0, 0}), {5, 7, 7});
    expectNear(transformPoint(m, {0, 1, 1}), {4, 6, 9});
}

TEST(GltfNodes, KeepFullDoublePrecision) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.root({{"mesh", mesh}, {"translation", {148376.123456789, 0.1, -1e9 / 3}}});
    EXPECT_EQ(DVec3(import(b).scene.objects[1].transform[3]), DVec3(148376.123456789, 0.1, -1e9 / 3));
}

TEST(GltfNodes, GiveObjectsInTheOrderOfTheFileWhateverTheTreeSays) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.push("nodes", {{"name", "one"}, {"mesh", mesh}});
    b.push("nodes", {{"name", "two"}, {"mesh", mesh}, {"children", {1}}});
    b.push("nodes", {{"name", "three"}, {"mesh", mesh}});
    b.doc["scenes"][0]["nodes"] = {3, 2};
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 3U); // node 0 is not in the scene
    EXPECT_EQ(scene.objects[0].name, "one");
    EXPECT_EQ(scene.objects[1].name, "two");
    EXPECT_EQ(scene.objects[2].name, "three");
}

TEST(GltfNodes, ShowTheDefaultSceneAndReportTheOthers) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.push("nodes", {{"name", "shown"}, {"mesh", mesh}});
    b.push("scenes", {{"nodes", {1}}});
    b.doc["scene"] = 1;
    const Imported imported = import(b);
    ASSERT_EQ(imported.scene.objects.size(), 1U);
    EXPECT_EQ(imported.scene.objects[0].name, "shown");
    EXPECT_EQ(imported.ignored("other scenes are not shown (1)"), 1);
}

TEST(GltfNodes, AreAllShownInAFileWithoutScenes) {
    GltfBuilder b;
    b.triangle();
    b.doc.erase("scene");
    b.doc.erase("scenes");
    EXPECT_EQ(import(b).scene.objects.size(), 1U);
}

TEST(GltfNodes, HideAndNameTheirObjects) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.root({{"mesh", mesh},
            {"name", "red\n\x1b[31m" + std::string(500, 'x')},
            {"extras", eyeray({{"visible", false}})}});
    const Scene scene = import(b).scene;
    EXPECT_TRUE(scene.objects[0].visible);
    EXPECT_EQ(scene.objects[0].name, "node 0");
    EXPECT_FALSE(scene.objects[1].visible);
    EXPECT_TRUE(scene.objects[1].name.starts_with("red\\x0a\\x1b[31mxxx"));
    EXPECT_LT(scene.objects[1].name.size(), 250U);
}

TEST(GltfNodes, ThatAreFlattenedAreLeftOutAndReported) {
    GltfBuilder b;
    const int mesh = b.triangle();
    b.root({{"mesh", mesh}, {"scale", {1, 0, 1}}});
    const Imported imported = import(b);
    EXPECT_EQ(imported.scene.objects.size(), 1U);
    EXPECT_EQ(imported.repaired("nodes[1]"), 1);
}

TEST(GltfShapes, AreReadWithTheirSizes) {
    const auto shapeOf = [](const json& shape) { return import(withShape(shape)).scene.shapes.at(0); };
    EXPECT_EQ(std::get<Sphere>(shapeOf({{"type", "sphere"}, {"sphere", {{"radius", 2.5}}}})).radius, 2.5F);
    EXPECT_EQ(std::get<Sphere>(shapeOf({{"type", "sphere"}, {"sphere", json::object()}})).radius, 0.5F);
    EXPECT_EQ(std::get<Box>(shapeOf({{"type", "box"}, {"box", {{"size", {1, 2, 3}}}}})).size, Vec3(1, 2, 3));
    const auto cone = std::get<Cylinder>(shapeOf(
        {{"type", "cylinder"}, {"cylinder", {{"height", 2}, {"radiusTop", 0}, {"radiusBottom", 1}}}}));
    EXPECT_EQ(cone.height, 2);
    EXPECT_EQ(cone.radiusTop, 0);
    EXPECT_EQ(cone.radiusBottom, 1);
    const auto plane =
        std::get<Plane>(shapeOf({{"type", "plane"}, {"plane", {{"sizeX", 4}, {"doubleSided", true}}}}));
    EXPECT_EQ(plane.sizeX, 4);
    EXPECT_EQ(plane.sizeZ, kInfinity);
    EXPECT_TRUE(plane.doubleSided);
}

TEST(GltfShapes, OfAnUnknownKindAreReportedAndTheOthersKeepTheirPlaces) {
    GltfBuilder b = withShape({{"type", "capsule"}, {"capsule", json::object()}});
    b.doc["extensions"]["KHR_implicit_shapes"]["shapes"].push_back({{"type", "sphere"}});
    b.root({{"extras", eyeray({{"shape", 1}})}});
    const Imported imported = import(b);
    ASSERT_EQ(imported.scene.objects.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<Sphere>(imported.scene.shapes.at(0)));
    EXPECT_EQ(imported.ignored("shapes[0]"), 1);
}

TEST(GltfShapes, HideTheMeshThatOtherProgramsShowInstead) {
    GltfBuilder b = withShape({{"type", "sphere"}});
    b.triangle();
    b.doc["scenes"][0]["nodes"] = {0};
    b.doc["nodes"][0]["mesh"] = 0;
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<ShapeId>(scene.objects[0].geometry));
}

TEST(GltfScene, SaysItsAmbientItsSkyAndItsSettings) {
    GltfBuilder b;
    b.doc["scenes"][0]["extras"] =
        eyeray({{"version", 1},
                {"lookAt", "the shadow"},
                {"ambient", {0.1, 0.2, 0.3}},
                {"environment", {{"zenith", {1, 2, 3}}, {"horizon", {4, 5, 6}}, {"nadir", {7, 8, 9}}}},
                {"settings", {"set max-depth=8", "set exposure=0.5"}},
                {"colour", "blue"}});
    const Imported imported = import(b);
    const Scene& scene = imported.scene;
    EXPECT_EQ(scene.name, "test");
    EXPECT_EQ(scene.whatToLookAt, "the shadow");
    EXPECT_EQ(scene.ambient, Color(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(scene.environment.zenith, Color(1, 2, 3));
    EXPECT_EQ(scene.environment.horizon, Color(4, 5, 6));
    EXPECT_EQ(scene.environment.nadir, Color(7, 8, 9));
    EXPECT_EQ(scene.settings, (std::vector<std::string>{"set max-depth=8", "set exposure=0.5"}));
    EXPECT_TRUE(scene.statesExposure);
    EXPECT_EQ(imported.ignored("colour is not known"), 1);
    EXPECT_TRUE(scene.lights.empty());
}

TEST(GltfScene, MaySetItsStateAndDoNothingElse) {
    GltfBuilder b;
    b.doc["scenes"][0]["extras"] =
        eyeray({{"settings",
                 {"screenshot path=/tmp/x.png", "set max-depth=2\nscreenshot", "setup", "set cutoff=0.1"}}});
    const Imported imported = import(b);
    EXPECT_EQ(imported.scene.settings, (std::vector<std::string>{"set cutoff=0.1"}));
    EXPECT_EQ(imported.ignored("only set commands"), 3);
}

TEST(GltfScene, OfANewerEyerayIsRefused) {
    GltfBuilder b;
    b.doc["scenes"][0]["extras"] = eyeray({{"version", 2}});
    EXPECT_THROW(import(b), InputError);
}

TEST(GltfDefaults, LightAndFrameAFileThatHasNeither) {
    GltfBuilder b;
    b.triangle();
    const Imported imported = import(b);
    const Scene& scene = imported.scene;
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_TRUE(scene.lights[0].followsCamera);
    EXPECT_EQ(scene.lights[0].name, "headlight (added)");
    const DVec3 shines = transformVector(scene.lights[0].transform, {0, 0, -1});
    EXPECT_GT(shines.x, 0); // from the left
    EXPECT_LT(shines.y, 0); // from above
    EXPECT_LT(shines.z, 0); // forwards
    EXPECT_FALSE(scene.environment.black());
    ASSERT_EQ(scene.cameras.size(), 1U);
    EXPECT_NEAR(scene.cameras[0].verticalFov, radians(45), 1e-12);
    EXPECT_FALSE(scene.statesExposure);
    EXPECT_EQ(imported.added("headlight"), 1);
    EXPECT_EQ(imported.added("sky"), 1);
    EXPECT_EQ(imported.added("45°"), 1);
    EXPECT_EQ(scene.materials.size(), 1U);
}

TEST(GltfDefaults, AddNoLightToALampAGlowOrASceneThatIsDarkOnPurpose) {
    GltfBuilder lamp;
    lamp.root({{"extras", eyeray({{"lamp", {{"type", "sphere"}}}})}});
    lamp.triangle();
    GltfBuilder glow;
    glow.push("materials", {{"emissiveFactor", {1, 1, 1}}});
    glow.triangle();
    glow.doc["meshes"][0]["primitives"][0]["material"] = 0;
    GltfBuilder dark;
    dark.triangle();
    dark.doc["scenes"][0]["extras"] = eyeray({{"version", 1}, {"environment", {{"zenith", {0, 0, 0}}}}});
    for (const GltfBuilder& b : {lamp, glow, dark}) {
        const Imported imported = import(b);
        EXPECT_EQ(imported.added("light"), 0);
        EXPECT_TRUE(imported.scene.environment.black());
    }
}

TEST(GltfGenerated, MeshesAreMadeAtLoad) {
    GltfBuilder b;
    b.push("materials", {{"name", "grass"}});
    b.root({{"name", "hills"},
            {"extras", eyeray({{"generate", {{"type", "terrain"}, {"triangles", 1000}}}, {"material", 0}})}});
    b.root({{"extras", eyeray({{"generate", {{"type", "knot"}, {"triangles", 2000}}}, {"material", 0}})}});
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[0].name, "hills");
    EXPECT_GE(test::meshOf(scene, 0).triangles.size(), 1000U);
    EXPECT_GE(test::meshOf(scene, 1).triangles.size(), 2000U);
}

TEST(GltfGenerated, BallsTakeTheirMaterialsInTurnAndTheirPlacesFromTheNode) {
    GltfBuilder b;
    for (const char* const name : {"red", "green", "blue"}) b.push("materials", {{"name", name}});
    b.root({{"translation", {0, 5, 0}},
            {"extras", eyeray({{"generate", {{"type", "spheres"}, {"count", 5}, {"materials", {2, 0}}}}})}});
    b.root({{"extras", eyeray({{"generate", {{"type", "flake"}, {"levels", 2}}}, {"material", 1}})}});
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 5U + 1 + 9 + 81);
    EXPECT_EQ(scene.objects[0].material, 2);
    EXPECT_EQ(scene.objects[1].material, 0);
    EXPECT_EQ(scene.objects[2].material, 2);
    EXPECT_GT(scene.objects[0].transform[3].y, 5);
    EXPECT_EQ(scene.objects[5].material, 1);
    expectNear(DVec3(scene.objects[5].transform[3]), {0, 0, 0});
}

TEST(GltfReport, ListsWhatIsNotShown) {
    GltfBuilder b;
    b.triangle();
    b.doc["animations"] = json::array({{{"channels", json::array()}, {"samplers", json::array()}}});
    b.doc["skins"] = json::array({{{"joints", {0}}}});
    b.doc["extensionsUsed"] = {"KHR_lights_punctual", "EXT_texture_webp"};
    b.doc["nodes"][0]["extras"] = {{"eyeray", {{"glitter", 1}}}, {"vendor", {{"anything", nullptr}}}};
    const Imported imported = import(b);
    EXPECT_EQ(imported.ignored("animations are not shown (1)"), 1);
    EXPECT_EQ(imported.ignored("skins are not shown (1)"), 1);
    EXPECT_EQ(imported.ignored("EXT_texture_webp"), 1);
    EXPECT_EQ(imported.ignored("KHR_lights_punctual"), 0);
    EXPECT_EQ(imported.ignored("glitter"), 1);
    EXPECT_EQ(imported.ignored("vendor"), 0);
}

TEST(GltfReport, StaysShortForAFileWithThousandsOfFaults) {
    GltfBuilder b;
    for (int i = 0; i < 1000; ++i) b.root({{"scale", {0, 0, 0}}});
    const Imported imported = import(b);
    EXPECT_LT(imported.report.lines.size(), 300U);
    EXPECT_EQ(imported.ignored("more lines like these"), 1);
}

}
}
