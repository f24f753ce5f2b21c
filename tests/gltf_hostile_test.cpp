// labels: robustness
// Files that must be refused in one line, or repaired and reported; never a crash, a hang or unbounded
// memory.
#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/base/sampling.h"
#include "core/image/encode.h"
#include "tests/gltf_builder.h"

namespace eyeray {
namespace {

using test::GltfBuilder;
using test::json;

/// The message of the refusal; fails the test unless there is one of one line that names the file.
std::string refusal(std::string_view file) {
    try {
        test::import(file);
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos);
        EXPECT_TRUE(message.starts_with("test.gltf")) << message;
        return message;
    }
    ADD_FAILURE() << "was not refused: " << file.substr(0, 300);
    return "";
}
std::string refusal(const GltfBuilder& b) { return refusal(b.gltf()); }

::testing::AssertionResult refused(const GltfBuilder& b, std::string_view place) {
    const std::string message = refusal(b);
    if (message.find(place) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << message << " does not name " << place;
}

/// A triangle with everything that can point somewhere.
GltfBuilder full() {
    GltfBuilder b;
    const ByteImage pixel(1, 1);
    const int image = b.view(encodeDisplayed(pixel, ImageFormat::Png, {}));
    const int positions = b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const int indices = b.accessor(std::vector<std::uint16_t>{0, 1, 2}, test::UnsignedShort, "SCALAR");
    const int places = b.view(std::vector<std::uint8_t>{2}), values = b.view(std::vector<float>{0, 2, 0});
    b.doc["accessors"][0]["sparse"] = {{"count", 1},
                                       {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                                       {"values", {{"bufferView", values}}}};
    b.push("images", {{"bufferView", image}, {"mimeType", "image/png"}});
    b.push("samplers", json::object());
    b.push("textures", {{"source", 0}, {"sampler", 0}});
    b.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    b.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"material", 0}});
    b.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    b.doc["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}}}}}},
                           {"KHR_implicit_shapes", {{"shapes", {{{"type", "sphere"}}}}}}};
    const int child = b.push("nodes", {{"extras", {{"eyeray", {{"shape", 0}, {"material", 0}}}}}});
    b.root({{"camera", 0}, {"children", {child}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return b;
}

TEST(Hostile, TheFileThatTheOthersAreMadeFromIsFine) {
    const auto imported = test::import(full());
    EXPECT_TRUE(imported.report.lines.empty());
    EXPECT_EQ(imported.scene.objects.size(), 2U);
    EXPECT_EQ(imported.scene.textures.size(), 1U);
}

TEST(Hostile, WhatIsNoGltfIsRefused) {
    for (const std::string_view text :
         {"", "x", "hello world", "{", "[]", "{}", "null", "\"glTF\"", "{\"asset\": 2}", "{\"asset\": {}}",
          "{\"asset\": {\"version\": \"1.0\"}}", "{\"asset\": {\"version\": \"3.0\"}}",
          "{\"asset\": {\"version\": 2.0}}", "{\"asset\": {\"version\": \"2.0\", \"minVersion\": \"2.1\"}}",
          "{\"asset\": {\"version\": \"2.0\"}, \"a\": 1e999}",
          "{\"asset\": {\"version\": \"2.0\"}, \"\xff\": 1}", "{\"asset\": {\"version\": \"2.0\"}} trailing"})
        refusal(text);
}

TEST(Hostile, ContainersThatLieAboutTheirLengthsAreRefused) {
    const std::string text = R"({"asset": {"version": "2.0"}}   )", data(8, 'x'), bin("BIN\0", 4);
    const std::string good = GltfBuilder::container(2, {{"JSON", text}, {bin, data}});
    EXPECT_NO_THROW(test::import(good));
    const auto with = [&](std::size_t offset, std::uint32_t value) {
        std::string file = good;
        return file.replace(offset, 4, GltfBuilder::word(value));
    };
    const auto size = static_cast<std::uint32_t>(good.size());
    refusal(with(4, 1));        // version
    refusal(with(8, size + 1)); // whole length
    refusal(with(8, 11));
    refusal(with(12, 0xffffffffU)); // JSON chunk
    refusal(with(12, static_cast<std::uint32_t>(text.size() - 8)));
    refusal(with(20 + text.size(), static_cast<std::uint32_t>(data.size() + 8))); // counts its own header
    refusal(GltfBuilder::container(2, {{bin, data}, {"JSON", text}}));
    refusal(GltfBuilder::container(2, {}));
    for (std::size_t length = 0; length < good.size(); ++length) refusal(good.substr(0, length));
}

TEST(Hostile, JsonNestedTooDeepIsRefusedBeforeItIsParsed) {
    const auto nested = [](std::size_t levels) {
        return R"({"asset": {"version": "2.0"}, "extras": )" + std::string(levels, '[') +
               std::string(levels, ']') + "}";
    };
    EXPECT_NO_THROW(test::import(nested(60)));
    refusal(nested(64));
    refusal(nested(50'000));
    refusal(std::string(1'000'000, '['));
    EXPECT_NO_THROW(test::import(
        R"({"asset": {"version": "2.0"}, "extras": "\"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["})"));
}

TEST(Hostile, ExtensionsThatAreRequiredAndUnknownAreRefused) {
    GltfBuilder b = full();
    b.doc["extensionsRequired"] = {"KHR_lights_punctual", "KHR_draco_mesh_compression"};
    EXPECT_TRUE(refused(b, "KHR_draco_mesh_compression"));
}

TEST(Hostile, SectionsOfTheWrongFormAreRefused) {
    for (const char* const section : {"nodes", "meshes", "materials", "accessors", "bufferViews", "images",
                                      "textures", "cameras", "scenes"})
        for (const json& wrong : {json(5), json::object({{"a", 1}}), json("text"), json::array({5}),
                                  json::array({json::array()}), json::array({nullptr})}) {
            GltfBuilder b = full();
            b.doc[section] = wrong;
            EXPECT_TRUE(refused(b, section)) << wrong;
        }
    GltfBuilder b = full();
    b.doc["extensions"]["KHR_implicit_shapes"]["shapes"] =
        json::array({json::object(), {{"type", "sphere"}}});
    EXPECT_TRUE(refused(b, "shapes[0]"));
}

TEST(Hostile, EveryIndexThatPointsNowhereIsRefused) {
    const std::vector<std::string> indices{"/scene",
                                           "/scenes/0/nodes/0",
                                           "/nodes/0/mesh",
                                           "/nodes/2/camera",
                                           "/nodes/2/children/0",
                                           "/nodes/2/extensions/KHR_lights_punctual/light",
                                           "/nodes/1/extras/eyeray/shape",
                                           "/nodes/1/extras/eyeray/material",
                                           "/meshes/0/primitives/0/attributes/POSITION",
                                           "/meshes/0/primitives/0/indices",
                                           "/meshes/0/primitives/0/material",
                                           "/accessors/0/bufferView",
                                           "/accessors/0/sparse/indices/bufferView",
                                           "/accessors/0/sparse/values/bufferView",
                                           "/bufferViews/1/buffer",
                                           "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
                                           "/textures/0/source",
                                           "/textures/0/sampler"};
    for (const std::string& index : indices)
        for (const json& wrong : {json(99), json(-1), json(-2), json(1.5), json("0"), json(2147483647),
                                  json(4294967296), json(1e18), json(true)}) {
            GltfBuilder b = full();
            ASSERT_TRUE(b.doc.contains(json::json_pointer(index))) << index;
            b.doc[json::json_pointer(index)] = wrong;
            SCOPED_TRACE(index + " = " + wrong.dump());
            refusal(b);
        }
}

TEST(Hostile, AccessorsThatReachOutOfTheirViewsAreRefused) {
    const auto with = [](const char* pointer, const json& value) {
        GltfBuilder b = full();
        b.doc[json::json_pointer(pointer)] = value;
        return b;
    };
    EXPECT_TRUE(refused(with("/accessors/0/count", 4), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/count", 2147483647), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/byteOffset", 4), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/byteOffset", 2147483644), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/byteOffset", -12), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/componentType", 5124), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/componentType", 5130), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/type", "VEC4"), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/type", "MAT4"), "accessors[0]"));
    refusal(with("/accessors/0/type", "VEC9"));
    EXPECT_TRUE(refused(with("/accessors/1/componentType", 5126), "accessors[1]"));
    EXPECT_TRUE(refused(with("/accessors/1/type", "VEC3"), "accessors[1]"));
    EXPECT_TRUE(refused(with("/accessors/0/sparse/count", 2), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/sparse/count", -1), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/sparse/indices/byteOffset", 1), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/sparse/indices/componentType", 5126), "accessors[0]"));
    EXPECT_TRUE(refused(with("/accessors/0/sparse/values/byteOffset", 8), "accessors[0]"));
    EXPECT_TRUE(refused(with("/bufferViews/1/byteLength", 1'000'000), "bufferViews[1]"));
    EXPECT_TRUE(refused(with("/bufferViews/1/byteOffset", 2147483647), "bufferViews[1]"));
    EXPECT_TRUE(refused(with("/bufferViews/1/byteStride", 8), "accessors[0]"));
    EXPECT_TRUE(refused(with("/bufferViews/1/byteStride", 252), "accessors[0]"));
    refusal(with("/bufferViews/1/byteStride", 256));
    refusal(with("/meshes/0/primitives/0/mode", 7));
    GltfBuilder sparse = full();
    sparse.buffer[sparse.doc["bufferViews"][3]["byteOffset"].get<std::size_t>()] = std::byte{3};
    EXPECT_TRUE(refused(sparse, "accessors[0]"));
}

TEST(Hostile, AttributesOfUnequalLengthAreRefused) {
    GltfBuilder b = full();
    b.doc["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = b.floats({0, 0, 1, 1}, "VEC2");
    EXPECT_TRUE(refused(b, "primitives[0]"));
}

TEST(Hostile, ElementsThatNoByteStandsForAreLimited) {
    GltfBuilder b = full();
    b.doc["accessors"][0].erase("bufferView");
    b.doc["accessors"][0]["count"] = 60'000'000; // 700 MB of zeros would fit the limit once
    for (int i = 0; i < 9; ++i)
        b.doc["meshes"][0]["primitives"][0]["attributes"]["_CUSTOM" + std::to_string(i)] = 0;
    EXPECT_TRUE(refused(b, "MB"));
}

TEST(Hostile, BuffersThatDoNotHoldWhatTheyClaimAreRefused) {
    const GltfBuilder b = full();
    const auto with = [&](const json& change) {
        json whole = json::parse(b.gltf());
        whole["buffers"][0].merge_patch(change);
        return whole.dump();
    };
    for (const json& change :
         {json{{"byteLength", b.buffer.size() + 1}}, json{{"byteLength", nullptr}}, json{{"byteLength", -1}},
          json{{"byteLength", 1e12}}, json{{"uri", nullptr}},
          json{{"uri", "data:application/octet-stream;base64,====="}}, json{{"uri", "data:,text"}},
          json{{"uri", "data:application/octet-stream;base64,AAAA"}},
          json{{"uri", "data:application/octet-stream;base64,A"}}, json{{"uri", 5}}})
        EXPECT_NE(refusal(with(change)).find("buffers[0]"), std::string::npos) << change;
    json many = json::parse(b.gltf());
    for (int i = 0; i < 3; ++i) many["buffers"].push_back({{"byteLength", 500'000'000}});
    refusal(many.dump());
}

TEST(Hostile, NodesThatFormNoTreeAreRefused) {
    const auto with = [](const std::vector<json>& nodes, const json& roots) {
        GltfBuilder b;
        b.doc["nodes"] = nodes;
        b.doc["scenes"][0]["nodes"] = roots;
        return b;
    };
    const auto children = [](const json& list) { return json{{"children", list}}; };
    EXPECT_TRUE(refused(with({children({0})}, {0}), "nodes[0]"));
    EXPECT_TRUE(refused(with({children({1}), children({0})}, {0}), "nodes[0]"));
    EXPECT_TRUE(
        refused(with({json::object(), children({2}), children({1})}, {0}), "nodes[1]")); // out of the scene
    EXPECT_TRUE(refused(with({children({2}), children({2}), json::object()}, {0, 1}), "nodes[2]"));
    EXPECT_TRUE(refused(with({children({1, 1}), json::object()}, {0}), "nodes[1]"));
    EXPECT_TRUE(refused(with({json::object()}, {0, 0}), "nodes[0]"));
    EXPECT_TRUE(refused(with({children({1}), json::object()}, {0, 1}), "nodes[1]"));
    const auto chain = [&](int length) {
        std::vector<json> nodes;
        for (int i = 1; i < length; ++i) nodes.push_back(children({i}));
        nodes.push_back(json::object());
        return with(nodes, {0});
    };
    EXPECT_NO_THROW(test::import(chain(512)));
    EXPECT_TRUE(refused(chain(513), "nodes[512]"));
}

TEST(Hostile, TransformsThatAreNoneAreRefused) {
    for (const json& node : {json{{"translation", {1, 2}}}, json{{"translation", {1, "2", 3}}},
                             json{{"translation", {1e16, 0, 0}}}, json{{"scale", {1, 1, 1, 1}}},
                             json{{"rotation", {0, 0, 0, 0}}}, json{{"rotation", {0, 0, 1}}},
                             json{{"rotation", {1e200, 1e200, 1e200, 1e200}}}, json{{"matrix", {1, 0, 0, 0}}},
                             json{{"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
                             json{{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}}}}) {
        GltfBuilder b;
        b.root(node);
        EXPECT_TRUE(refused(b, "nodes[0]")) << node;
    }
}

TEST(Hostile, OurOwnExtrasAreReadWithTheSameCare) {
    const auto with = [](const json& extras) {
        GltfBuilder b = full();
        b.root({{"extras", {{"eyeray", extras}}}});
        return b;
    };
    for (const json& extras :
         {json{{"shape", "0"}}, json{{"shape", 0}, {"material", 4294967296}}, json{{"visible", 1}},
          json{{"lamp", 1}}, json{{"lamp", {{"type", "ring"}}}}, json{{"lamp", {{"color", {1, 2}}}}},
          json{{"distance", "far"}}, json{{"generate", {{"type", "city"}}}},
          json{{"generate", json::array({1})}}, json{{"generate", {{"type", "knot"}, {"p", 2}, {"q", 4}}}},
          json{{"generate", {{"type", "spheres"}, {"materials", {7}}}}},
          json{{"generate", {{"type", "spheres"}, {"count", 1.5}}}}})
        EXPECT_TRUE(refused(with(extras), "eyeray")) << extras;
    const auto repaired =
        test::import(with({{"lamp", {{"type", "sphere"}, {"radius", -1}, {"intensity", 1e300}}}}));
    EXPECT_EQ(repaired.repaired("radius"), 1);
    EXPECT_EQ(repaired.repaired("intensity"), 1);
}

TEST(Hostile, TooManyThingsAreRefused) {
    GltfBuilder nodes;
    nodes.doc["nodes"] = json::array();
    for (int i = 0; i <= 100'000; ++i) nodes.doc["nodes"].push_back(json::object());
    EXPECT_TRUE(refused(nodes, "100001 nodes"));
    GltfBuilder images = full();
    for (int i = 0; i < 256; ++i) images.push("images", {{"uri", "a.png"}});
    EXPECT_TRUE(refused(images, "257 images"));
}

TEST(Hostile, ImagesThatAreTooLargeOrBrokenAreLeftOutAndReported) {
    auto png = encodeDisplayed(ByteImage(1, 1), ImageFormat::Png, {});
    auto bomb = png;
    for (const std::size_t offset : {16U, 20U}) { // width and height in the header
        bomb[offset] = std::byte{0};
        bomb[offset + 1] = std::byte{0};
        bomb[offset + 2] = std::byte{0x75};
        bomb[offset + 3] = std::byte{0x30};
    }
    auto cut = png;
    cut.resize(png.size() / 2);
    for (const auto& bytes : {bomb, cut, std::vector<std::byte>(100, std::byte{7})}) {
        GltfBuilder b = full();
        b.doc["images"][0] = {{"bufferView", b.view(bytes)}};
        const auto imported = test::import(b);
        EXPECT_EQ(imported.repaired("images[0]"), 1);
        EXPECT_EQ(imported.scene.objects.size(), 2U);
    }
    GltfBuilder outside = full();
    outside.doc["bufferViews"][0]["byteLength"] = 1'000'000; // the image's: tinygltf would read there
    EXPECT_EQ(test::import(outside).repaired("bufferViews[0]"), 1);
}

TEST(Hostile, MessagesShowControlCharactersAsText) {
    GltfBuilder b = full();
    b.doc["extensionsRequired"] = {"bell\a and\nnew line"};
    EXPECT_NE(refusal(b).find("bell\\x07 and\\x0anew line"), std::string::npos);
}

/// Whatever comes out is whole: importGltf validates it. Whatever does not is refused in one line.
void expectNoCrash(std::string_view file) {
    try {
        test::import(file);
    } catch (const InputError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    }
}

TEST(Hostile, EveryCutOfAFileIsRefusedOrRead) {
    const std::string glb = full().glb(), gltf = full().gltf();
    for (std::size_t length = 0; length < glb.size(); ++length)
        expectNoCrash(std::string_view(glb).substr(0, length));
    for (std::size_t length = 0; length < gltf.size(); ++length) refusal(gltf.substr(0, length));
}

TEST(Hostile, FilesWithBytesChangedAtRandomAreRefusedOrRead) {
    const std::string glb = full().glb();
    for (std::uint32_t round = 0; round < 4000; ++round) {
        std::string file = glb;
        const std::uint32_t changes = 1 + hash32(round) % 4;
        for (std::uint32_t i = 0; i < changes; ++i) {
            const std::uint32_t hash = hashCombine(round, i);
            file[hash % file.size()] = static_cast<char>(hashCombine(hash, 1) & 0xffU);
        }
        expectNoCrash(file);
    }
}

TEST(Hostile, FilesWithValuesChangedAtRandomAreRefusedOrRead) {
    const GltfBuilder original = full();
    const json flat = original.doc.flatten();
    std::vector<std::string> places;
    for (const auto& entry : flat.items()) places.push_back(entry.key());
    const std::vector<json> values{nullptr,
                                   true,
                                   -1,
                                   0,
                                   1,
                                   3,
                                   1e300,
                                   -1e300,
                                   2147483647,
                                   -2147483648LL,
                                   4294967296,
                                   0.5,
                                   "",
                                   "x",
                                   json::array(),
                                   json::object(),
                                   json::array({0, 0, 0}),
                                   5126,
                                   5120};
    for (const std::string& place : places)
        for (const json& value : values) {
            GltfBuilder b = original;
            b.doc[json::json_pointer(place)] = value;
            expectNoCrash(b.gltf());
        }
}

}
}
