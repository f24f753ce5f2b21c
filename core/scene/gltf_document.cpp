#include "core/scene/gltf_document.h"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "core/scene/gltf_check.h"
#include "core/scene/gltf_container.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

using nlohmann::json;

namespace {

json parseJson(std::string_view text, const std::string& where) {
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        throw InputError{where, fmt::format("is not glTF: no JSON at byte {}", error.byte),
                         "choose a .gltf or .glb file"};
    } catch (const json::exception&) {
        throw InputError{where, "has a number in its JSON that is too large", "export it again"};
    }
}

/// Takes a section out of the JSON; empty where there is none.
json taken(json& document, const char* section) {
    const auto found = document.find(section);
    if (found == document.end()) return json::array();
    json result = std::move(*found);
    document.erase(found);
    return result;
}

std::string textOf(json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? std::move(found->get_ref<std::string&>())
                                                       : std::string();
}

void takeBuffers(GltfDocument& result, json buffers, std::span<const std::byte> binary,
                 const GltfFiles& files) {
    std::size_t total = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string where = result.at("buffers", i);
        const json& length = buffers[i].value("byteLength", json());
        if (!length.is_number_unsigned())
            throw InputError{where, "has no byteLength", "export the file again"};
        const auto bytes = length.get<std::size_t>();
        if (bytes > limits::kBufferBytes - total)
            throw InputError{where,
                             fmt::format("the buffers hold more than {} MB", limits::kBufferBytes >> 20U),
                             "split the scene"};
        total += bytes;

        const std::string uri = textOf(buffers[i], "uri");
        std::span<const std::byte> data = binary;
        if (!uri.empty())
            data = result.storage.emplace_back(files.read(uri, limits::kBufferBytes, where));
        else if (i != 0 || binary.empty())
            throw InputError{where, "has no data", "export the file again"};
        if (data.size() < bytes)
            throw InputError{where, fmt::format("claims {} bytes, has {}", bytes, data.size()),
                             "the file is damaged or cut off: export or copy it again"};
        result.buffers.push_back(data.first(bytes));
    }
}

void takeImages(GltfDocument& result, json images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string where = result.at("images", i);
        GltfImageSource image{textOf(images[i], "name"), textOf(images[i], "uri"),
                              images[i].value("bufferView", -1)};
        if (image.uri.empty() == (image.bufferView < 0))
            throw InputError{where, "needs either a uri or a bufferView", "export the file again"};
        if (!image.uri.empty())
            static_cast<void>(pathOfUri(image.uri, where)); // refuses what leads elsewhere
        result.images.push_back(std::move(image));
    }
}

void dropUnshown(json& document, GltfNotes& notes) {
    for (const char* const section : {"animations", "skins"})
        if (const std::size_t count = taken(document, section).size(); count > 0)
            notes.ignored(fmt::format("{} are not shown ({}): the scene stands still", section, count));
}

tinygltf::Model toStructures(const json& document, const std::string& where) {
    const std::string text = document.dump();
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string errors, warnings;
    const bool loaded =
        loader.LoadASCIIFromString(&model, &errors, &warnings, text.data(),
                                   static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE);
    if (!loaded || !errors.empty()) {
        const std::string first = errors.substr(0, errors.find('\n'));
        throw InputError{where, first.empty() ? "cannot be understood" : first, "export the file again"};
    }
    return model;
}

}

std::string GltfDocument::at(const char* section, std::size_t index) const {
    return fmt::format("{}: {}[{}]", where, section, index);
}

GltfDocument parseDocument(std::span<const std::byte> file, const std::string& where, const GltfFiles& files,
                           GltfNotes& notes) {
    const GltfContainer container = openContainer(file, where);
    json document = parseJson(container.json, where);
    checkDocument(document, where, notes);

    GltfDocument result;
    result.where = where;
    takeBuffers(result, taken(document, "buffers"), container.binary, files);
    takeImages(result, taken(document, "images"));
    dropUnshown(document, notes);
    result.model = toStructures(document, where);
    return result;
}

}
