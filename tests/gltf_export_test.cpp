// labels: unit
#include <filesystem>
#include <fstream>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/scene/gltf.h"
#include "tests/gltf_builder.h"
#include "tests/same_scene.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

using test::expectSame;

Scene reread(const Scene& scene, const std::string& name = "scene.glb") {
    const TemporaryFolder folder;
    exportGltf(scene, folder / name);
    ImportReport report;
    Scene result = importGltf(folder / name, report);
    for (const auto& line : report.lines)
        if (line.kind != ImportReport::Kind::Doubtful) ADD_FAILURE() << line.text;
    return result;
}

/// The least that a scene can be.
Scene plain() {
    Scene scene;
    scene.materials = {{"plain", TaughtMaterial{}}};
    scene.cameras = {Camera{}};
    scene.cameras[0].name = "camera";
    return scene;
}

TriangleMesh meshWithEverything() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1.5F, 0}, {0.1F, 0.2F, 0.3F}};
    mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    mesh.uvs[0] = {{0, 0}, {1, 0}, {0, 1}, {0.3F, 0.7F}};
    mesh.uvs[2] = {{5, 5}, {1, 0}, {0, 1}, {0.3F, 0.7F}};
    mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5F}, {1, 1, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
    mesh.doubleSided = false;
    return mesh;
}

void addMesh(Scene& scene, const std::string& name, TriangleMesh mesh) {
    scene.meshes.push_back({name, std::make_shared<const TriangleMesh>(std::move(mesh))});
}

const DMat4 kAnywhere = glm::scale(
    glm::rotate(glm::translate(DMat4(1), DVec3(1.1, -2.2, 1e6 / 3)), 0.7, DVec3(1, 2, 3)), DVec3(1, 2, -0.3));

TEST(GltfExport, KeepsTheSceneItself) {
    Scene scene = plain();
    scene.whatToLookAt = "the “shadow”";
    scene.settings = {"set max-depth=8", "set exposure=0.5"};
    scene.statesExposure = true;
    scene.ambient = {0.1F, 0.2F, 0.3F};
    scene.environment = {{1, 2, 3}, {0.4F, 0.5F, 0.6F}, {7, 8, 9}};
    expectSame(scene, reread(scene));
    expectSame(scene, reread(scene, "scene.gltf"));
}

TEST(GltfExport, KeepsADarkSceneDark) {
    Scene scene = plain();
    scene.shapes = {Sphere{1}};
    scene.objects = {{"ball", ShapeId{0}, 0, DMat4(1), true}};
    const Scene back = reread(scene);
    EXPECT_TRUE(back.lights.empty());
    EXPECT_TRUE(back.environment.black());
}

TEST(GltfExport, KeepsShapes) {
    Scene scene = plain();
    scene.shapes = {Sphere{0.3F}, Plane{}, Plane{2, 3, true}, Box{{1, 2, 3}}, Cylinder{2, 0, 0.7F}};
    for (int i = 0; i < 5; ++i) scene.objects.push_back({"shape", ShapeId{4 - i}, 0, kAnywhere, i != 2});
    expectSame(scene, reread(scene));
    expectSame(scene, reread(scene, "scene.gltf"));
}

TEST(GltfExport, KeepsMeshesAndSharesThem) {
    Scene scene = plain();
    scene.materials.push_back({"other", GltfMaterial{}});
    addMesh(scene, "full", meshWithEverything());
    TriangleMesh bare;
    bare.positions = meshWithEverything().positions;
    bare.triangles = {{0, 1, 2}};
    addMesh(scene, "bare", bare);
    scene.objects = {{"b", MeshId{1}, 0, DMat4(1), true},
                     {"f", MeshId{0}, 1, kAnywhere, true},
                     {"f again", MeshId{0}, 1, DMat4(1), false}};
    scene.objects.push_back({"other material", MeshId{1}, 1, DMat4(1), true});
    for (const char* const name : {"scene.glb", "scene.gltf", "SCENE.GLB"}) {
        const Scene back = reread(scene, name);
        expectSame(scene, back);
        EXPECT_EQ(back.meshes.size(), 2U);
    }
}

TEST(GltfExport, KeepsBothSidesOfAMaterialThatIsSeenBothWays) {
    Scene scene = plain();
    TriangleMesh mesh = meshWithEverything();
    addMesh(scene, "one side", mesh);
    mesh.doubleSided = true;
    addMesh(scene, "both sides", mesh);
    scene.objects = {{"a", MeshId{0}, 0, DMat4(1), true},
                     {"b", MeshId{1}, 0, DMat4(1), true},
                     {"c", MeshId{1}, 0, DMat4(1), true}};
    expectSame(scene, reread(scene));
}

TEST(GltfExport, KeepsMaterialsWithTheirTextures) {
    Scene scene = plain();
    ByteImage pixels(2, 1);
    pixels.at(0, 0) = {1, 2, 3, 255};
    pixels.at(1, 0) = {250, 251, 252, 128};
    const auto encoded = encodeDisplayed(pixels, ImageFormat::Png, {});
    scene.images = {{"made here", std::make_shared<const ByteImage>(pixels), nullptr},
                    {"from a file", std::make_shared<const ByteImage>(pixels),
                     std::make_shared<const std::vector<std::byte>>(encoded)}};
    scene.textures = {{"checker", CheckerTexture{{1, 0, 0.5F}, {0, 0.25F, 0}}},
                      {"tiles", ImageTexture{1, Wrap::Clamp, Wrap::Mirror, true}},
                      {"made", ImageTexture{0, Wrap::Repeat, Wrap::Repeat, false}}};

    TaughtMaterial taught;
    taught.ambient = {0.1F, 0.2F, 0.3F};
    taught.diffuse = {0.4F, 0.5F, 0.6F};
    taught.diffuseTexture = {0, 0, {0.5F, 0}, {4, 8}, 0.25F};
    taught.specular = Color(0.7F);
    taught.shininess = 99;
    taught.specularModel = SpecularModel::BlinnPhong;
    taught.reflectivity = Color(0.15F);
    taught.transmission = {0.8F, 0.9F, 1};
    taught.ior = 2.42F;
    taught.attenuation = {0.01F, 2, 0};
    taught.emission = {3, 0, 20};
    TaughtMaterial pictured;
    pictured.diffuseTexture.texture = 1;

    GltfMaterial physical;
    physical.baseColor = {0.1F, 0.9F, 0.3F};
    physical.baseColorTexture = {1, 2, {0.1F, 0.2F}, {3, 4}, 0.5F};
    physical.metallic = 0.25F;
    physical.roughness = 0.125F;
    physical.metallicRoughnessTexture.texture = 2;
    physical.emissive = {1, 0.5F, 0};
    physical.emissiveStrength = 7;
    physical.emissiveTexture.texture = 2;
    physical.transmission = 0.75F;
    physical.transmissionTexture = {1, 1, {0, 0}, {1, 1}, 0};
    physical.ior = 1.33F;
    physical.specular = 0.5F;
    physical.specularColor = {2, 1, 0};
    physical.thickness = 0.1F;
    physical.attenuationDistance = 0.7F;
    physical.attenuationColor = {0.9F, 0.8F, 0.1F};
    GltfMaterial checkered;
    checkered.baseColorTexture = {0, 0, {0, 0}, {2, 2}, 0};

    scene.materials = {{"taught", taught},
                       {"pictured", pictured},
                       {"physical", physical},
                       {"checkered", checkered},
                       {"default", GltfMaterial{}}};
    scene.shapes = {Sphere{1}};
    for (int i = 0; i < 5; ++i) scene.objects.push_back({"ball", ShapeId{0}, i, DMat4(1), true});
    const Scene back = reread(scene);
    expectSame(scene, back);
    expectSame(scene, reread(back, "again.gltf"));
    EXPECT_EQ(
        *back.images.at(static_cast<std::size_t>(std::get<ImageTexture>(back.textures.at(1).source).image))
             .encoded,
        encoded);
}

TEST(GltfExport, KeepsLamps) {
    Scene scene = plain();
    const std::vector<LampShape> shapes{PointLamp{},           DirectionalLamp{}, SpotLamp{0.1, 0.7},
                                        RectangleLamp{2, 3.5}, DiscLamp{0.75},    SphereLamp{0.125}};
    for (const LampShape& shape : shapes)
        for (const bool taught : {false, true}) {
            Light light;
            light.name = "lamp";
            light.shape = shape;
            light.color = {1, 0.3F, 2};
            light.intensity = 123.456;
            light.falloff = !taught;
            light.enabled = !taught;
            light.followsCamera = taught;
            light.transform = kAnywhere;
            if (taught) light.range = 12.5;
            scene.lights.push_back(light);
        }
    expectSame(scene, reread(scene));
}

TEST(GltfExport, KeepsCameras) {
    Scene scene = plain();
    scene.cameras = {{"level", {1, 2, 3}, {4, 2.5, -6}, {0, 1, 0}, 0.7, 1.5, 0.05, 3.5},
                     {"rolled", {1, 2, 3}, {4, 2.5, -6}, {1, 1, 0}, 1.2, 0, 0.1, 0},
                     {"from above", {0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 0.3, 0, 0, 0},
                     {"from below", {0, -5, 0}, {0, 0, 0}, {1, 0, 0}, 0.3, 0, 0, 0}};
    expectSame(scene, reread(scene));
}

TEST(GltfExport, WritesWhatOtherProgramsCanShowInsteadOfTaughtMaterials) {
    Scene scene = plain();
    TaughtMaterial mirror;
    mirror.diffuse = Color(0);
    mirror.reflectivity = Color(0.5F);
    scene.materials = {{"mirror", mirror}};
    const TemporaryFolder folder;
    exportGltf(scene, folder / "scene.gltf");
    std::ifstream file(folder / "scene.gltf");
    const auto document = test::json::parse(file);
    const auto& pbr = document["materials"][0]["pbrMetallicRoughness"];
    EXPECT_EQ(pbr["metallicFactor"], 1);
    EXPECT_EQ(pbr["roughnessFactor"], 0);
    EXPECT_EQ(pbr["baseColorFactor"], test::json::parse("[0.5, 0.5, 0.5, 1]"));
    EXPECT_FALSE(document.contains("extensionsRequired"));
}

TEST(GltfExport, RefusesOtherEndingsAndKeepsTheOldFileOnFailure) {
    const TemporaryFolder folder;
    EXPECT_THROW(exportGltf(plain(), folder / "scene.obj"), InputError);
    EXPECT_THROW(exportGltf(plain(), folder / "missing/scene.glb"), Failure);
    exportGltf(plain(), folder / "scene.glb");
    const auto before = readFile(folder / "scene.glb", 1'000'000);
    Scene broken = plain();
    broken.cameras.clear();
    EXPECT_THROW(exportGltf(broken, folder / "scene.glb"), InternalError);
    EXPECT_EQ(readFile(folder / "scene.glb", 1'000'000), before);
}

TEST(GltfExport, HoldsTheObjectsThatWereGenerated) {
    test::GltfBuilder b;
    b.root({{"extras", {{"eyeray", {{"generate", {{"type", "flake"}, {"levels", 1}}}}}}}});
    b.root({{"extras", {{"eyeray", {{"generate", {{"type", "knot"}, {"triangles", 100}}}}}}}});
    const Scene scene = test::import(b).scene;
    expectSame(scene, reread(scene));
}

TEST(GltfExport, KeepsEveryBuiltInScene) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(EYERAY_SOURCE_DIR "/assets/scenes")) {
        if (entry.path().extension() != ".gltf") continue;
        SCOPED_TRACE(entry.path().filename());
        ImportReport report;
        const Scene scene = importGltf(entry.path(), report);
        expectSame(scene, reread(scene));
        ++scenes;
    }
    EXPECT_GE(scenes, 14);
}

}
}
