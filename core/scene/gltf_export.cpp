#include "core/scene/gltf_export.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/scene/base64.h"
#include "core/scene/gltf.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

using nlohmann::json;

namespace {

enum class Container : std::uint8_t { Text, Binary };

Container containerOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".gltf") return Container::Text;
    if (ending == ".glb") return Container::Binary;
    throw InputError{path.string(), "is no name for a scene", "let it end in .glb or .gltf"};
}

std::string toText(const json& document, int indent) {
    return document.dump(indent, ' ', false, json::error_handler_t::replace); // a name may be no UTF-8
}

void append(std::string& file, std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) file += static_cast<char>(value >> shift & 0xffU);
}

void appendChunk(std::string& file, std::string_view kind, std::string_view data, char padding) {
    const std::size_t padded = (data.size() + 3) / 4 * 4;
    append(file, static_cast<std::uint32_t>(padded));
    file.append(kind).append(data).append(padded - data.size(), padding);
}

std::string_view asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string binaryFile(json document, std::span<const std::byte> buffer) {
    if (!buffer.empty()) document["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string body;
    appendChunk(body, "JSON", toText(document, -1), ' ');
    if (!buffer.empty()) appendChunk(body, std::string_view("BIN\0", 4), asText(buffer), '\0');
    std::string file = "glTF";
    append(file, 2);
    append(file, static_cast<std::uint32_t>(body.size() + 12));
    return file + body;
}

std::string textFile(json document, std::span<const std::byte> buffer) {
    if (!buffer.empty())
        document["buffers"] = {{{"byteLength", buffer.size()},
                                {"uri", "data:application/octet-stream;base64," + encodeBase64(buffer)}}};
    return toText(document, 1);
}

}

GltfExport::GltfExport(const Scene& s) : scene(s), sides_(s.materials.size()) {}

json GltfExport::finished() const {
    json result = document;
    result["asset"] = {{"version", "2.0"}, {"generator", "Eyeray"}};
    result["scene"] = 0;
    if (!extensions_.empty()) result["extensionsUsed"] = extensions_;
    return result;
}

int GltfExport::push(const char* section, json entry) {
    json& entries = document[section];
    entries.push_back(std::move(entry));
    return static_cast<int>(entries.size()) - 1;
}

int GltfExport::view(std::span<const std::byte> bytes) {
    const std::size_t offset = (buffer.size() + 3) / 4 * 4;
    buffer.resize(offset);
    buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    return push("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
}

const char* GltfExport::use(const char* extension) {
    extensions_.insert(extension);
    return extension;
}

int GltfExport::materialFor(int material, bool doubleSided) {
    Sides& sides = sides_[material];
    json& materials = document["materials"];
    if (!sides.known) {
        sides = {true, doubleSided};
        materials[material]["doubleSided"] = doubleSided;
    }
    if (sides.both == doubleSided) return material;
    if (sides.other < 0) {
        json copy = materials[material];
        copy["doubleSided"] = doubleSided;
        sides.other = push("materials", std::move(copy));
    }
    return sides.other;
}

json toJson(float value) {
    const std::string digits = fmt::format("{}", value);
    double shortest = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), shortest);
    return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}
json toJson(const Vec2& v) { return json::array({toJson(v.x), toJson(v.y)}); }
json toJson(const Color& c) { return json::array({toJson(c.x), toJson(c.y), toJson(c.z)}); }

void exportGltf(const Scene& scene, const std::filesystem::path& path) {
    const Container container = containerOf(path);
    validate(scene);
    GltfExport context(scene);
    exportMaterials(context, exportTextures(context));
    exportNodes(context);

    const std::string file = container == Container::Binary ? binaryFile(context.finished(), context.buffer)
                                                            : textFile(context.finished(), context.buffer);
    if (file.size() > limits::kFileBytes)
        throw Failure{path.string(),
                      fmt::format("would take {} MB, more than can be read back", file.size() >> 20U),
                      container == Container::Text ? "write a .glb" : "write fewer objects"};
    writeFileAtomically(path, std::as_bytes(std::span(file)));
}

}
