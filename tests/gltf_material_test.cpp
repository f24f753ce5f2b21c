// labels: unit
// Materials, textures and images.
#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "tests/gltf_builder.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

using test::GltfBuilder;
using test::import;
using test::Imported;
using test::json;

json eyeray(json content) { return {{"eyeray", std::move(content)}}; }

Imported withMaterial(const json& material) {
    GltfBuilder b;
    b.push("materials", material);
    return import(b);
}

GltfMaterial physical(const json& material) {
    return std::get<GltfMaterial>(withMaterial(material).scene.materials.at(0).model);
}

TaughtMaterial taught(const json& material) {
    return std::get<TaughtMaterial>(withMaterial(material).scene.materials.at(0).model);
}

/// A PNG of 2 × 1 pixels, one red and one half-transparent green.
std::vector<std::byte> png() {
    ByteImage image(2, 1);
    image.at(0, 0) = {255, 0, 0, 255};
    image.at(1, 0) = {0, 255, 0, 128};
    return encodeDisplayed(image, ImageFormat::Png, {});
}

/// One material whose base colour is texture 0.
GltfBuilder textured(const json& image) {
    GltfBuilder b;
    b.doc["images"] = json::array({image});
    b.doc["textures"] = json::array({{{"source", 0}}});
    b.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    return b;
}

std::string dataUri(const std::vector<std::byte>& bytes) {
    return "data:image/png;base64," + encodeBase64(bytes);
}

TextureRef baseColorTexture(const Scene& scene) {
    return std::get<GltfMaterial>(scene.materials.at(0).model).baseColorTexture;
}

TEST(GltfMaterials, HaveTheDefaultsOfTheFormat) {
    const GltfMaterial m = physical(json::object());
    EXPECT_EQ(m.baseColor, Color(1));
    EXPECT_EQ(m.metallic, 1);
    EXPECT_EQ(m.roughness, 1);
    EXPECT_TRUE(isBlack(m.emissive));
    EXPECT_EQ(m.transmission, 0);
    EXPECT_EQ(m.ior, 1.5F);
    EXPECT_EQ(m.attenuationDistance, kInfinity);
    EXPECT_FALSE(m.baseColorTexture.used());
}

TEST(GltfMaterials, AreReadWithTheirExtensions) {
    const GltfMaterial m = physical(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}, {"metallicFactor", 0.4}, {"roughnessFactor", 0.5}}},
         {"emissiveFactor", {0.6, 0.7, 0.8}},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 9}}},
           {"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
           {"KHR_materials_volume",
            {{"thicknessFactor", 2}, {"attenuationDistance", 3}, {"attenuationColor", {0.9, 0.8, 0.7}}}},
           {"KHR_materials_specular", {{"specularFactor", 0.25}, {"specularColorFactor", {2, 1, 0.5}}}}}}});
    EXPECT_EQ(m.baseColor, Color(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(m.metallic, 0.4F);
    EXPECT_EQ(m.roughness, 0.5F);
    EXPECT_EQ(m.emissive, Color(0.6F, 0.7F, 0.8F));
    EXPECT_EQ(m.emissiveStrength, 9);
    EXPECT_EQ(m.ior, 1.33F);
    EXPECT_EQ(m.transmission, 0.9F);
    EXPECT_EQ(m.thickness, 2);
    EXPECT_EQ(m.attenuationDistance, 3);
    EXPECT_EQ(m.attenuationColor, Color(0.9F, 0.8F, 0.7F));
    EXPECT_EQ(m.specular, 0.25F);
    EXPECT_EQ(m.specularColor, Color(2, 1, 0.5F));
}

TEST(GltfMaterials, OutOfRangeAreMovedIntoItAndReported) {
    const Imported imported =
        withMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}, {"roughnessFactor", -1}}},
                      {"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}});
    const auto m = std::get<GltfMaterial>(imported.scene.materials[0].model);
    EXPECT_EQ(m.metallic, 1);
    EXPECT_EQ(m.roughness, 0);
    EXPECT_EQ(m.ior, 1);
    EXPECT_EQ(imported.repaired("materials[0].metallicFactor is 1.5, taken as 1"), 1);
    EXPECT_EQ(imported.repaired("roughnessFactor"), 1);
    EXPECT_EQ(imported.repaired("ior"), 1);
}

TEST(GltfMaterials, AsTaughtStandInExtras) {
    const TaughtMaterial m = taught({{"extras", eyeray({{"taught",
                                                         {{"ambient", {0.1, 0.1, 0.1}},
                                                          {"diffuse", {0.2, 0.3, 0.4}},
                                                          {"specular", {0.5, 0.5, 0.5}},
                                                          {"shininess", 77},
                                                          {"model", "blinn-phong"},
                                                          {"reflectivity", {0.6, 0.6, 0.6}},
                                                          {"transmission", {0.7, 0.7, 0.7}},
                                                          {"ior", 1.33},
                                                          {"attenuation", {1, 2, 3}},
                                                          {"emission", {4, 5, 6}}}}})}});
    EXPECT_EQ(m.ambient, Color(0.1F));
    EXPECT_EQ(m.diffuse, Color(0.2F, 0.3F, 0.4F));
    EXPECT_EQ(m.specular, Color(0.5F));
    EXPECT_EQ(m.shininess, 77);
    EXPECT_EQ(m.specularModel, SpecularModel::BlinnPhong);
    EXPECT_EQ(m.reflectivity, Color(0.6F));
    EXPECT_EQ(m.transmission, Color(0.7F));
    EXPECT_EQ(m.ior, 1.33F);
    EXPECT_EQ(m.attenuation, Color(1, 2, 3));
    EXPECT_EQ(m.emission, Color(4, 5, 6));
}

TEST(GltfMaterials, CheckerboardsColourBothKinds) {
    const json checker{{"even", {1, 0, 0}}, {"odd", {0, 0, 1}}, {"cells", {4, 8}}};
    for (const json& extras :
         {json{{"checker", checker}}, json{{"checker", checker}, {"taught", {{"ior", 2}}}}}) {
        const Scene scene = withMaterial({{"extras", eyeray(extras)}}).scene;
        const MaterialModel& model = scene.materials[0].model;
        const TextureRef ref = std::holds_alternative<GltfMaterial>(model)
                                   ? std::get<GltfMaterial>(model).baseColorTexture
                                   : std::get<TaughtMaterial>(model).diffuseTexture;
        ASSERT_TRUE(ref.used());
        EXPECT_EQ(ref.scale, Vec2(4, 8));
        const auto board =
            std::get<CheckerTexture>(scene.textures.at(static_cast<std::size_t>(ref.texture)).source);
        EXPECT_EQ(board.even, Color(1, 0, 0));
        EXPECT_EQ(board.odd, Color(0, 0, 1));
    }
}

TEST(GltfMaterials, SayWhatOfThemIsNotShown) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    for (int i = 0; i < 2; ++i)
        b.push("materials", {{"normalTexture", {{"index", 0}}},
                             {"alphaMode", "BLEND"},
                             {"extensions",
                              {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
                               {"KHR_materials_unlit", json::object()}}}});
    b.doc["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_unlit"};
    const Imported imported = import(b);
    EXPECT_EQ(imported.ignored("normalTexture of 2 materials is not shown"), 1);
    EXPECT_EQ(imported.ignored("alphaMode BLEND of 2 materials"), 1);
    EXPECT_EQ(imported.ignored("KHR_materials_clearcoat of 2 materials"), 1);
    EXPECT_EQ(imported.ignored("KHR_materials_clearcoat"), 1);
    EXPECT_EQ(imported.ignored("KHR_materials_unlit of 2 materials"), 1);
}

TEST(GltfTextures, ComeFromDataUrisBufferViewsAndFiles) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "my images");
    writeFileAtomically(folder / "my images/a.png", png());

    GltfBuilder inView = textured(json::object());
    inView.doc["images"][0] = {{"bufferView", inView.view(png())}, {"mimeType", "image/png"}};
    const std::string beside = textured({{"uri", "my%20images/a.png"}}).gltf();
    writeText(folder / "scene.gltf", beside);
    ImportReport report;
    const Scene fromFile = importGltf(folder / "scene.gltf", report);

    for (const Scene& scene :
         {import(textured({{"uri", dataUri(png())}})).scene, import(inView.glb()).scene, fromFile}) {
        ASSERT_EQ(scene.images.size(), 1U);
        EXPECT_EQ(scene.images[0].pixels->at(0, 0), (Rgba8{255, 0, 0, 255}));
        EXPECT_EQ(scene.images[0].pixels->at(1, 0), (Rgba8{0, 255, 0, 128}));
        EXPECT_EQ(*scene.images[0].encoded, png());
        EXPECT_EQ(baseColorTexture(scene).texture, 0);
    }
}

TEST(GltfTextures, WrapAndFilterAsTheirSamplerSays) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    b.doc["samplers"] = json::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}});
    b.doc["textures"][0]["sampler"] = 0;
    const auto texture = std::get<ImageTexture>(import(b).scene.textures.at(0).source);
    EXPECT_EQ(texture.wrapU, Wrap::Clamp);
    EXPECT_EQ(texture.wrapV, Wrap::Mirror);
    EXPECT_TRUE(texture.nearest);
    const auto plain =
        std::get<ImageTexture>(import(textured({{"uri", dataUri(png())}})).scene.textures.at(0).source);
    EXPECT_EQ(plain.wrapU, Wrap::Repeat);
    EXPECT_FALSE(plain.nearest);
}

TEST(GltfTextures, AreMovedTurnedAndScaled) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    b.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 0},
        {"texCoord", 1},
        {"extensions",
         {{"KHR_texture_transform", {{"offset", {0.1, 0.2}}, {"rotation", 0.3}, {"scale", {4, 5}}}}}}};
    const TextureRef ref = baseColorTexture(import(b).scene);
    EXPECT_EQ(ref.uvSet, 1);
    EXPECT_EQ(ref.offset, Vec2(0.1F, 0.2F));
    EXPECT_EQ(ref.rotation, 0.3F);
    EXPECT_EQ(ref.scale, Vec2(4, 5));
    b.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"]
         ["texCoord"] = 2;
    EXPECT_EQ(baseColorTexture(import(b).scene).uvSet, 2);
}

TEST(GltfTextures, OfAllSlotsAreRead) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    b.push("textures", {{"source", 0}});
    b.doc["materials"][0] = {
        {"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}},
        {"emissiveTexture", {{"index", 1}}},
        {"extensions",
         {{"KHR_materials_transmission", {{"transmissionTexture", {{"index", 1}, {"texCoord", 3}}}}}}}};
    const Scene scene = import(b).scene;
    const auto m = std::get<GltfMaterial>(scene.materials[0].model);
    EXPECT_EQ(m.metallicRoughnessTexture.texture, 0);
    EXPECT_EQ(m.emissiveTexture.texture, 1);
    EXPECT_EQ(m.transmissionTexture.texture, 1);
    EXPECT_EQ(m.transmissionTexture.uvSet, 3);
    EXPECT_EQ(scene.images.size(), 1U); // one image, decoded once
}

TEST(GltfTextures, ThatCannotBeHadAreReportedAndLeftOut) {
    std::vector<std::byte> cut = png();
    cut.resize(40);
    for (const json& image : {json{{"uri", dataUri(cut)}}, json{{"uri", "data:image/png;base64,????"}},
                              json{{"uri", "missing.png"}}}) {
        GltfBuilder b = textured(image);
        b.triangle();
        const Imported imported = import(b);
        EXPECT_FALSE(baseColorTexture(imported.scene).used());
        EXPECT_EQ(imported.repaired("images[0]"), 1) << image;
        EXPECT_EQ(imported.scene.objects.size(), 1U);
    }
}

TEST(GltfTextures, ThatNoMaterialUsesAreNotDecoded) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    b.doc["materials"][0] = {{"normalTexture", {{"index", 0}}}};
    EXPECT_TRUE(import(b).scene.images.empty());
}

TEST(GltfTextures, WithoutAnImageOfOursAreReported) {
    GltfBuilder b = textured({{"uri", dataUri(png())}});
    b.doc["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    const Imported imported = import(b);
    EXPECT_FALSE(baseColorTexture(imported.scene).used());
    EXPECT_EQ(imported.ignored("textures[0]"), 1);
}

}
}
