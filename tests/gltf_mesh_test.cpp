// labels: unit
// Accessors and primitives.
#include <functional>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/gltf_builder.h"

namespace eyeray {
namespace {

using test::GltfBuilder;
using test::import;
using test::Imported;
using test::json;
using test::meshOf;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::vector<float> kQuad{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

/// A square of four vertices with more attributes and members of its primitive.
GltfBuilder quad(const std::function<void(GltfBuilder&, json&)>& change) {
    GltfBuilder b;
    json primitive{{"attributes", {{"POSITION", b.floats(kQuad, "VEC3")}}}};
    change(b, primitive);
    b.mesh(primitive);
    return b;
}

TEST(GltfIndices, OfAllTypesMeanTheSame) {
    const std::vector<std::uint32_t> wanted{0, 1, 2, 2, 3, 0};
    const auto with = [&]<class T>(T, test::ComponentType component) {
        return meshOf(import(quad([&](GltfBuilder& b, json& primitive) {
                          primitive["indices"] =
                              b.accessor(std::vector<T>(wanted.begin(), wanted.end()), component, "SCALAR");
                      })).scene)
            .triangles;
    };
    const Triangles triangles{{0, 1, 2}, {2, 3, 0}};
    EXPECT_EQ(with(std::uint8_t{}, test::UnsignedByte), triangles);
    EXPECT_EQ(with(std::uint16_t{}, test::UnsignedShort), triangles);
    EXPECT_EQ(with(std::uint32_t{}, test::UnsignedInt), triangles);
}

TEST(GltfIndices, MayBeLeftOut) {
    GltfBuilder b;
    b.mesh({{"attributes",
             {{"POSITION", b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0}, "VEC3")}}}});
    EXPECT_EQ(meshOf(import(b).scene).triangles, (Triangles{{0, 1, 2}, {3, 4, 5}}));
}

TEST(GltfPrimitive, StripsKeepTheirFrontsTogether) {
    const Scene scene = import(quad([](GltfBuilder& b, json& primitive) {
                            primitive["mode"] = 5;
                            primitive["indices"] = b.accessor(std::vector<std::uint16_t>{0, 1, 3, 2},
                                                              test::UnsignedShort, "SCALAR");
                        })).scene;
    EXPECT_EQ(meshOf(scene).triangles, (Triangles{{0, 1, 3}, {1, 2, 3}}));
}

TEST(GltfPrimitive, FansTurnAboutTheirFirstVertex) {
    const Scene scene = import(quad([](GltfBuilder&, json& primitive) { primitive["mode"] = 6; })).scene;
    EXPECT_EQ(meshOf(scene).triangles, (Triangles{{1, 2, 0}, {2, 3, 0}}));
}

TEST(GltfPrimitive, PointsAndLinesAreReported) {
    GltfBuilder b;
    const int positions = b.floats(kQuad, "VEC3");
    for (const int mode : {0, 1, 2, 3}) b.mesh({{"mode", mode}, {"attributes", {{"POSITION", positions}}}});
    const Imported imported = import(b);
    EXPECT_TRUE(imported.scene.objects.empty());
    EXPECT_EQ(imported.ignored("points of 1 mesh primitive"), 1);
    EXPECT_EQ(imported.ignored("lines of 3 mesh primitives"), 1);
}

TEST(GltfPrimitive, EachOfAMeshIsAnObjectWithItsMaterial) {
    GltfBuilder b;
    b.push("materials", {{"name", "a"}});
    b.push("materials", {{"name", "b"}});
    const int p = b.floats(kQuad, "VEC3"), q = b.floats(kQuad, "VEC3");
    b.push("meshes", {{"name", "both"},
                      {"primitives",
                       {{{"attributes", {{"POSITION", p}}}, {"material", 1}},
                        {{"attributes", {{"POSITION", q}}}, {"material", 0}}}}});
    b.root({{"name", "thing"}, {"mesh", 0}});
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[0].name, "thing [0]");
    EXPECT_EQ(scene.objects[0].material, 1);
    EXPECT_EQ(scene.objects[1].material, 0);
    EXPECT_EQ(scene.meshes.size(), 2U);
    EXPECT_EQ(scene.meshes[0].name, "both");
}

TEST(GltfPrimitive, InstancesShareTheirTriangles) {
    GltfBuilder b;
    b.push("materials", json::object());
    b.push("materials", json::object());
    const int p = b.floats(kQuad, "VEC3");
    for (const int material : {0, 1}) b.mesh({{"attributes", {{"POSITION", p}}}, {"material", material}});
    b.root({{"mesh", 0}});
    const Scene scene = import(b).scene;
    EXPECT_EQ(scene.objects.size(), 3U);
    EXPECT_EQ(scene.meshes.size(), 1U);
}

TEST(GltfPrimitive, IsDoubleSidedIfItsMaterialSaysSoOrLightPassesIt) {
    GltfBuilder b;
    b.push("materials", {{"doubleSided", true}});
    b.push("materials", {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}});
    b.push("materials", json::object());
    const int p = b.floats(kQuad, "VEC3");
    for (const int material : {0, 1, 2}) b.mesh({{"attributes", {{"POSITION", p}}}, {"material", material}});
    const Scene scene = import(b).scene;
    EXPECT_TRUE(meshOf(scene, 0).doubleSided);
    EXPECT_TRUE(meshOf(scene, 1).doubleSided);
    EXPECT_FALSE(meshOf(scene, 2).doubleSided);
}

TEST(GltfAttributes, WithoutNormalsStayFlat) {
    GltfBuilder b;
    b.triangle();
    EXPECT_TRUE(meshOf(import(b).scene).normals.empty());
}

TEST(GltfAttributes, InterleavedAreReadByTheirStride) {
    GltfBuilder b;
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) interleaved.push_back(kQuad[3 * i + c]);
        for (const float v : {0.0F, 0.0F, 2.0F, static_cast<float>(i), 0.5F}) interleaved.push_back(v);
    }
    const int view = b.view(interleaved, 32);
    const auto accessor = [&](int offset, const char* type) {
        return b.push("accessors", {{"bufferView", view},
                                    {"byteOffset", offset},
                                    {"componentType", 5126},
                                    {"count", 4},
                                    {"type", type}});
    };
    b.mesh({{"mode", 6},
            {"attributes",
             {{"POSITION", accessor(0, "VEC3")},
              {"NORMAL", accessor(12, "VEC3")},
              {"TEXCOORD_0", accessor(24, "VEC2")}}}});
    const Scene scene = import(b).scene;
    const TriangleMesh& mesh = meshOf(scene);
    EXPECT_EQ(mesh.positions[2], Vec3(1, 1, 0));
    EXPECT_EQ(mesh.normals[2], Vec3(0, 0, 1)); // made unit
    EXPECT_EQ(mesh.uvs[0][3], Vec2(3, 0.5F));
}

TEST(GltfAttributes, NormalisedIntegersStandForZeroToOne) {
    const Scene scene =
        import(quad([](GltfBuilder& b, json& primitive) {
            auto& attributes = primitive["attributes"];
            attributes["TEXCOORD_0"] =
                b.accessor(std::vector<std::uint16_t>{0, 65535, 65535, 0, 32768, 1, 0, 0},
                           test::UnsignedShort, "VEC2", true);
            attributes["TEXCOORD_1"] = b.accessor(std::vector<std::uint8_t>{0, 255, 51, 0, 0, 0, 0, 0},
                                                  test::UnsignedByte, "VEC2", true);
            attributes["COLOR_0"] =
                b.accessor(std::vector<std::uint8_t>{255, 0, 51, 102, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                           test::UnsignedByte, "VEC4", true);
            attributes["NORMAL"] =
                b.accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, -128, 127, 0, 0, 0, 127, 0}, test::Byte,
                           "VEC3", true);
        })).scene;
    const TriangleMesh& mesh = meshOf(scene);
    EXPECT_EQ(mesh.uvs[0][0], Vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.uvs[0][2].x, 32768.0F / 65535);
    EXPECT_FLOAT_EQ(mesh.uvs[1][1].x, 0.2F);
    EXPECT_FLOAT_EQ(mesh.colors[0].z, 0.2F);
    EXPECT_FLOAT_EQ(mesh.colors[0].w, 0.4F);
    EXPECT_EQ(mesh.normals[1], Vec3(0, 0, -1)); // −128 is −1 too
}

TEST(GltfAttributes, QuantisedPositionsKeepTheirNumbers) {
    GltfBuilder b;
    b.doc["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int p =
        b.accessor(std::vector<std::int16_t>{0, 0, 0, 0, 300, 0, 0, 0, 0, -200, 5, 0}, test::Short, "VEC3");
    b.doc["bufferViews"][0]["byteStride"] = 8;
    b.doc["accessors"][static_cast<std::size_t>(p)]["count"] = 3;
    b.mesh({{"attributes", {{"POSITION", p}}}});
    const Scene scene = import(b).scene;
    EXPECT_EQ(meshOf(scene).positions[1], Vec3(300, 0, 0));
    EXPECT_EQ(meshOf(scene).positions[2], Vec3(0, -200, 5));
}

TEST(GltfAttributes, ColoursOfThreeComponentsAreOpaque) {
    const Scene scene = import(quad([](GltfBuilder& b, json& primitive) {
                            primitive["attributes"]["COLOR_0"] =
                                b.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5F, 2, 0}, "VEC3");
                        })).scene;
    EXPECT_EQ(meshOf(scene).colors[1], Vec4(0, 1, 0, 1));
    EXPECT_EQ(meshOf(scene).colors[3], Vec4(0.5F, 1, 0, 1)); // at most 1
}

TEST(GltfAttributes, TextureCoordinatesComeInFourSets) {
    const Imported imported = import(quad([](GltfBuilder& b, json& primitive) {
        for (int set = 0; set < 5; ++set)
            primitive["attributes"]["TEXCOORD_" + std::to_string(set)] =
                b.floats(std::vector<float>(8, static_cast<float>(set)), "VEC2");
    }));
    for (std::size_t set = 0; set < 4; ++set)
        EXPECT_EQ(meshOf(imported.scene).uvs[set][0], Vec2(static_cast<float>(set)));
    EXPECT_EQ(imported.ignored("fourth set"), 1);
}

json sparse(int indices, int values, int count) {
    return {{"count", count},
            {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
            {"values", {{"bufferView", values}}}};
}

TEST(GltfSparse, ElementsReplaceThoseOfTheBase) {
    GltfBuilder b;
    const int p = b.floats(kQuad, "VEC3");
    const int places = b.view(std::vector<std::uint8_t>{1, 3}),
              values = b.view(std::vector<float>{7, 8, 9, -1, -2, -3});
    b.doc["accessors"][static_cast<std::size_t>(p)]["sparse"] = sparse(places, values, 2);
    b.mesh({{"mode", 6}, {"attributes", {{"POSITION", p}}}});
    const Scene scene = import(b).scene;
    EXPECT_EQ(meshOf(scene).positions, (std::vector<Vec3>{{0, 0, 0}, {7, 8, 9}, {1, 1, 0}, {-1, -2, -3}}));
}

TEST(GltfSparse, ElementsWithoutABaseReplaceZeros) {
    GltfBuilder b;
    const int places = b.view(std::vector<std::uint8_t>{0, 2}),
              values = b.view(std::vector<float>{1, 0, 0, 0, 1, 0});
    const int p = b.push(
        "accessors",
        {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"sparse", sparse(places, values, 2)}});
    b.mesh({{"attributes", {{"POSITION", p}}}});
    EXPECT_EQ(meshOf(import(b).scene).positions, (std::vector<Vec3>{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}));
}

TEST(GltfSparse, IndicesAreReplacedToo) {
    GltfBuilder b;
    const int indices = b.accessor(std::vector<std::uint16_t>{0, 1, 1}, test::UnsignedShort, "SCALAR");
    const int places = b.view(std::vector<std::uint8_t>{2}), values = b.view(std::vector<std::uint16_t>{3});
    b.doc["accessors"][static_cast<std::size_t>(indices)]["sparse"] = sparse(places, values, 1);
    b.mesh({{"indices", indices}, {"attributes", {{"POSITION", b.floats(kQuad, "VEC3")}}}});
    EXPECT_EQ(meshOf(import(b).scene).triangles, (Triangles{{0, 1, 3}}));
}

TEST(GltfRepair, TrianglesWithoutTheirVerticesAreDroppedAndCounted) {
    const Imported imported = import(quad([](GltfBuilder& b, json& primitive) {
        primitive["indices"] = b.accessor(std::vector<std::uint16_t>{0, 1, 4, 0, 1, 2, 65535, 0, 1, 3, 2},
                                          test::UnsignedShort, "SCALAR");
    }));
    EXPECT_EQ(meshOf(imported.scene).triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(imported.repaired("2 of 3 triangles"), 1);
    EXPECT_EQ(imported.repaired("not whole"), 1);
}

TEST(GltfRepair, PositionsThatAreNotFiniteTakeTheirTrianglesAlong) {
    GltfBuilder b;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    b.mesh({{"attributes",
             {{"POSITION", b.floats({0, 0, 0, nan, 0,     0, 0, 1, 0, 0, 0, 0, 1, 0,
                                     0, 0, 1, 0,   1e16F, 0, 0, 1, 0, 0, 0, 1, 0},
                                    "VEC3")}}}});
    const Imported imported = import(b);
    EXPECT_EQ(meshOf(imported.scene).triangles, (Triangles{{3, 4, 5}}));
    EXPECT_EQ(imported.repaired("2 of 3 triangles"), 1);
    EXPECT_TRUE(boundsOf(meshOf(imported.scene)).finite());
}

TEST(GltfRepair, NormalsWithoutDirectionComeFromTheTriangles) {
    const Imported imported = import(quad([](GltfBuilder& b, json& primitive) {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        primitive["mode"] = 6;
        primitive["attributes"]["NORMAL"] = b.floats({0, 0, 0, nan, 0, 0, 1, 0, 0, 0, 1e30F, 0}, "VEC3");
    }));
    const auto& normals = meshOf(imported.scene).normals;
    EXPECT_EQ(normals, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(imported.repaired("2 normals"), 1);
}

TEST(GltfRepair, TextureCoordinatesAndColoursThatAreNotFiniteBecomeZero) {
    const Imported imported = import(quad([](GltfBuilder& b, json& primitive) {
        const float inf = std::numeric_limits<float>::infinity();
        primitive["attributes"]["TEXCOORD_0"] = b.floats({inf, 0, 0, 0, 0, 0, 1, 1}, "VEC2");
        primitive["attributes"]["COLOR_0"] = b.floats({1, 1, 1, -inf, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
    }));
    EXPECT_EQ(meshOf(imported.scene).uvs[0][0], Vec2(0));
    EXPECT_EQ(meshOf(imported.scene).colors[1], Vec4(0));
    EXPECT_EQ(imported.repaired("not finite"), 2);
}

TEST(GltfReport, SaysWhatOfMeshesIsNotShown) {
    const Imported imported = import(quad([](GltfBuilder& b, json& primitive) {
        primitive["targets"] = json::array({{{"POSITION", b.floats(kQuad, "VEC3")}}});
        primitive["attributes"]["JOINTS_0"] =
            b.accessor(std::vector<std::uint8_t>(16, 0), test::UnsignedByte, "VEC4");
    }));
    EXPECT_EQ(imported.ignored("morph targets of 1"), 1);
    EXPECT_EQ(imported.ignored("skin weights of 1"), 1);
}

}
}
