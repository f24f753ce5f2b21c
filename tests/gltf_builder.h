#pragma once
// Small glTF documents for tests.

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/scene/base64.h"
#include "core/scene/gltf.h"

namespace eyeray::test {

using nlohmann::json;

enum ComponentType : std::uint16_t {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

/// A document whose JSON the test may change as it likes, and one buffer behind it.
struct GltfBuilder {
    json doc =
        json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": []})");
    std::vector<std::byte> buffer;

    /// Appends the values and returns the index of a view of them.
    template <class T>
    int view(const std::vector<T>& values, std::size_t byteStride = 0) {
        const std::size_t offset = (buffer.size() + 3) / 4 * 4, bytes = values.size() * sizeof(T);
        buffer.resize(offset + bytes);
        if (bytes > 0) std::memcpy(buffer.data() + offset, values.data(), bytes);
        json entry{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}};
        if (byteStride > 0) entry["byteStride"] = byteStride;
        return push("bufferViews", entry);
    }

    /// An accessor of all values, tightly packed.
    template <class T>
    int accessor(const std::vector<T>& values, ComponentType component, const char* type,
                 bool normalized = false) {
        const std::size_t width =
            std::string_view(type) == "SCALAR" ? 1U : static_cast<std::size_t>(type[3] - '0');
        json entry{{"bufferView", view(values)},
                   {"componentType", static_cast<int>(component)},
                   {"count", values.size() / width},
                   {"type", type}};
        if (normalized) entry["normalized"] = true;
        return push("accessors", entry);
    }

    int floats(const std::vector<float>& values, const char* type) { return accessor(values, Float, type); }

    int push(const char* section, json entry) {
        doc[section].push_back(std::move(entry));
        return static_cast<int>(doc[section].size()) - 1;
    }

    /// A node of the scene itself.
    int root(json node) {
        const int index = push("nodes", std::move(node));
        doc["scenes"][0]["nodes"].push_back(index);
        return index;
    }

    /// A mesh of one primitive on a node of its own; returns the mesh.
    int mesh(json primitive) {
        const int index = push("meshes", {{"primitives", json::array({std::move(primitive)})}});
        root({{"mesh", index}});
        return index;
    }

    /// One triangle in the plane z = 0 on a node of its own; returns the mesh.
    int triangle() {
        return mesh({{"attributes", {{"POSITION", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}}}});
    }

    /// The document with its buffer at the given uri; a data URI if that is empty.
    std::string gltf(const std::string& uri = "") const {
        json whole = doc;
        if (!buffer.empty())
            whole["buffers"] = json::array(
                {{{"byteLength", buffer.size()},
                  {"uri",
                   uri.empty() ? "data:application/octet-stream;base64," + encodeBase64(buffer) : uri}}});
        return whole.dump();
    }

    std::string glb() const {
        json whole = doc;
        if (!buffer.empty()) whole["buffers"] = json::array({{{"byteLength", buffer.size()}}});
        std::string text = whole.dump(), data(reinterpret_cast<const char*>(buffer.data()), buffer.size());
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4, '\0');
        return container(2, {{"JSON", text}, {std::string("BIN\0", 4), data}});
    }

    /// A .glb of any version and chunks.
    static std::string container(std::uint32_t version,
                                 const std::vector<std::pair<std::string, std::string>>& chunks) {
        std::string body;
        for (const auto& [kind, data] : chunks)
            body.append(word(static_cast<std::uint32_t>(data.size()))).append(kind).append(data);
        return "glTF" + word(version) + word(static_cast<std::uint32_t>(body.size() + 12)) + body;
    }

    static std::string word(std::uint32_t value) {
        std::string text;
        for (unsigned i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
        return text;
    }
};

struct Imported {
    Scene scene;
    ImportReport report;

    /// Number of report lines of a kind that contain the text.
    int count(ImportReport::Kind kind, std::string_view text) const {
        int result = 0;
        for (const auto& line : report.lines)
            result += line.kind == kind && line.text.find(text) != std::string::npos;
        return result;
    }
    int ignored(std::string_view text) const { return count(ImportReport::Kind::Ignored, text); }
    int repaired(std::string_view text) const { return count(ImportReport::Kind::Repaired, text); }
    int added(std::string_view text) const { return count(ImportReport::Kind::Added, text); }
};

inline Imported import(std::string_view file) {
    Imported result;
    result.scene = importGltf(std::as_bytes(std::span(file)), "test.gltf", result.report);
    return result;
}
inline Imported import(const GltfBuilder& builder) { return import(builder.gltf()); }

inline const TriangleMesh& meshOf(const Scene& scene, std::size_t object = 0) {
    const int mesh = std::get<MeshId>(scene.objects.at(object).geometry).index;
    return *scene.meshes.at(static_cast<std::size_t>(mesh)).triangles;
}

}
