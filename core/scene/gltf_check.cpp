#include "core/scene/gltf_check.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 10> kExtensions{"KHR_implicit_shapes",
                                                       "KHR_lights_punctual",
                                                       "KHR_mesh_quantization",
                                                       "KHR_texture_transform",
                                                       "KHR_materials_emissive_strength",
                                                       "KHR_materials_ior",
                                                       "KHR_materials_specular",
                                                       "KHR_materials_transmission",
                                                       "KHR_materials_unlit",
                                                       "KHR_materials_volume"};

constexpr std::array<std::string_view, 15> kSections{
    "accessors", "animations", "buffers",  "bufferViews",    "cameras",
    "images",    "materials",  "meshes",   "nodes",          "samplers",
    "scenes",    "skins",      "textures", "extensionsUsed", "extensionsRequired"};

/// Members that are an index, a kind or a size, and those that are lists of indices, wherever in glTF and the
/// extensions above they stand. No size in a readable file exceeds 32 bits.
constexpr std::array<std::string_view, 20> kCardinals{
    "buffer", "bufferView", "byteLength", "byteOffset", "byteStride", "camera",  "componentType",
    "count",  "index",      "indices",    "light",      "material",   "mesh",    "mode",
    "node",   "sampler",    "shape",      "skin",       "source",     "texCoord"};
constexpr std::array<std::string_view, 3> kCardinalLists{"children", "joints", "nodes"};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError{where, what, "export the file again as glTF 2.0"};
}

std::string textAt(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void checkAsset(const json& document, const std::string& where) {
    const auto asset = document.find("asset");
    if (asset == document.end() || !asset->is_object()) refuse(where, "is not glTF: it has no asset");
    const std::string version = textAt(*asset, "version"), needed = textAt(*asset, "minVersion");
    if (!version.starts_with("2."))
        refuse(where, fmt::format("is glTF version \"{}\"", printable(version, 20)));
    if (!needed.empty() && needed != "2.0")
        refuse(where, fmt::format("needs glTF version \"{}\"", printable(needed, 20)));
}

/// The texts of a list; others in it are refused.
std::vector<std::string> textsAt(const json& document, const char* section, const std::string& where) {
    std::vector<std::string> result;
    if (const auto found = document.find(section); found != document.end())
        for (const json& name : *found) {
            if (!name.is_string()) refuse(where, fmt::format("{} is not a list of names", section));
            result.push_back(name.get<std::string>());
        }
    return result;
}

void checkExtensions(const json& document, const std::string& where, GltfNotes& notes) {
    const auto required = textsAt(document, "extensionsRequired", where);
    for (const std::string& name : required)
        if (!contains(kExtensions, name))
            throw InputError{where,
                             fmt::format("needs the extension {}, which cannot be read", printable(name, 80)),
                             "export it without"};
    for (const std::string& name : textsAt(document, "extensionsUsed", where))
        if (!contains(kExtensions, name) &&
            name.find("_materials_") == std::string::npos) // counted with their materials
            notes.ignored(fmt::format("extension {} is not read", name));
}

void checkSections(const json& document, const std::string& where) {
    for (const auto& [name, section] : document.items()) {
        if (!contains(kSections, name)) continue;
        if (!section.is_array()) refuse(where, fmt::format("its {} are not a list", name));
        if (name.starts_with("extensions")) continue;
        for (std::size_t i = 0; i < section.size(); ++i)
            if (!section[i].is_object())
                refuse(fmt::format("{}: {}[{}]", where, name, i), "is not an object");
    }
    const auto checkCount = [&](const char* section, std::size_t limit) {
        const auto found = document.find(section);
        if (found != document.end() && found->size() > limit)
            throw InputError{where, fmt::format("has {} {}, more than {}", found->size(), section, limit),
                             "split the scene"};
    };
    checkCount("nodes", limits::kNodes);
    checkCount("images", limits::kImages);
}

bool fits(const json& number) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    if (number.is_number_unsigned()) return number.get<std::uint64_t>() <= static_cast<std::uint64_t>(kMost);
    return number.get<std::int64_t>() >= -kMost;
}

void checkCardinal(const json& value, const std::string& key, const std::string& where) {
    if (!value.is_number_unsigned() || !fits(value))
        refuse(where, fmt::format("{} is not a whole number from 0 to 2147483647", key));
}

/// What tinygltf would pass over in silence.
void checkMember(const json& member, const std::string& name, const std::string& parent,
                 const std::string& where) {
    const bool sparse = name == "indices" && parent == "sparse"; // an object there
    if (contains(kCardinalLists, name)) {
        if (!member.is_array()) refuse(where, fmt::format("{} is not a list", name));
        for (const json& element : member) checkCardinal(element, name, where);
    } else if ((contains(kCardinals, name) && !sparse) || parent == "attributes") {
        checkCardinal(member, name, where);
    }
}

/// Looks through one part of the document. `ours` is false inside extras and extensions that nobody reads,
/// where only the size of numbers matters.
void checkValues(json& value, const std::string& key, bool ours, const std::string& where) {
    if (value.is_object()) {
        for (auto& [name, member] : value.items()) {
            const bool foreign = name == "extras" || (key == "extensions" && !contains(kExtensions, name));
            if (ours) checkMember(member, name, key, where);
            checkValues(member, name, ours && !foreign, where);
        }
    } else if (value.is_array()) {
        for (json& element : value) checkValues(element, key, ours, where);
    } else if (value.is_number_integer() && !fits(value)) {
        value = value.get<double>();
    }
}

/// tinygltf leaves empty objects out of lists in extensions, which would shift the indices of shapes.
void checkShapes(const json& document, const std::string& where) {
    const json::json_pointer path("/extensions/KHR_implicit_shapes/shapes");
    if (!document.contains(path)) return;
    const json& shapes = document.at(path);
    if (!shapes.is_array()) refuse(where, "its shapes are not a list");
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (!shapes[i].is_object() || shapes[i].empty())
            refuse(fmt::format("{}: shapes[{}]", where, i), "is not a shape");
}

}

void checkDocument(json& document, const std::string& where, GltfNotes& notes) {
    if (!document.is_object()) refuse(where, "is not glTF: its JSON is not an object");
    checkAsset(document, where);
    checkExtensions(document, where, notes);
    checkSections(document, where);
    for (auto& [name, section] : document.items()) {
        if (!section.is_array()) {
            if (name == "scene") checkCardinal(section, name, where);
            checkValues(section, name, name != "extras", where);
            continue;
        }
        for (std::size_t i = 0; i < section.size(); ++i)
            checkValues(section[i], "", true, fmt::format("{}: {}[{}]", where, name, i));
    }
    checkShapes(document, where);
}

}
