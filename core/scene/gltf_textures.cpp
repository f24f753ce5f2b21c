#include "core/scene/gltf_textures.h"

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/decode.h"
#include "core/scene/gltf_accessors.h"

namespace eyeray {

namespace {

constexpr const char* kTransform = "KHR_texture_transform";
constexpr int kNotShown = -1;

Wrap wrapOf(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::Clamp;
    return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::Mirror : Wrap::Repeat;
}

}

TextureRef GltfTextures::placed(int texture, int uvSet, GltfFields transform) {
    TextureRef ref;
    ref.texture = texture;
    ref.offset = transform.pair("offset", ref.offset);
    ref.scale = transform.pair("scale", ref.scale);
    ref.rotation = transform.real("rotation", ref.rotation);
    ref.uvSet = transform.whole("texCoord", uvSet, 0, kUvSets - 1);
    if (ref.uvSet >= kUvSets) {
        context_.notes.repaired(fmt::format("{}: texture coordinate set {} is not read, taken as 0",
                                            transform.where(), ref.uvSet));
        ref.uvSet = 0;
    }
    return ref;
}

TextureRef GltfTextures::reference(const tinygltf::TextureInfo& info, const std::string& where) {
    if (info.index < 0) return {};
    return placed(textureOf(info.index, where), info.texCoord,
                  extensionFields(info.extensions, kTransform, where, context_.notes));
}

TextureRef GltfTextures::reference(GltfFields& extension, const std::string& key) {
    GltfFields info = extension.child(key);
    const auto index = info.index("index", context_.document.model.textures.size());
    if (!index) return {};
    const int uvSet = info.whole("texCoord", 0, 0, kUvSets - 1);
    GltfFields extensions = info.child("extensions");
    return placed(textureOf(*index, info.where()), uvSet, extensions.child(kTransform));
}

TextureRef GltfTextures::checker(GltfFields& fields) {
    CheckerTexture checker;
    checker.even = fields.color("even", checker.even);
    checker.odd = fields.color("odd", checker.odd);
    TextureRef ref;
    ref.scale = fields.pair("cells", ref.scale);
    ref.offset = fields.pair("offset", ref.offset);
    ref.rotation = fields.real("rotation", ref.rotation);
    ref.uvSet = fields.whole("texCoord", ref.uvSet, 0, kUvSets - 1);
    ref.texture = static_cast<int>(context_.scene.textures.size());
    context_.scene.textures.push_back({"checker", checker});
    fields.reportUnread();
    return ref;
}

int GltfTextures::textureOf(int index, const std::string& where) {
    const auto& textures = context_.document.model.textures;
    if (static_cast<std::size_t>(index) >= textures.size())
        throw InputError{where, fmt::format("texture {} does not exist", index), "export the file again"};
    if (const auto known = textures_.find(index); known != textures_.end()) return known->second;

    const tinygltf::Texture& source = textures[index];
    const std::string textureWhere = context_.document.at("textures", static_cast<std::size_t>(index));
    int& result = textures_[index] = kNotShown;
    if (source.source < 0) {
        context_.notes.ignored(textureWhere + ": has no PNG or JPEG image, it is not shown");
        return result;
    }
    const auto image = imageOf(source.source, textureWhere);
    if (!image) return result;

    ImageTexture texture;
    texture.image = *image;
    if (source.sampler >= 0) {
        const auto& samplers = context_.document.model.samplers;
        if (static_cast<std::size_t>(source.sampler) >= samplers.size())
            throw InputError{textureWhere, fmt::format("sampler {} does not exist", source.sampler),
                             "export the file again"};
        const tinygltf::Sampler& sampler = samplers[source.sampler];
        texture.wrapU = wrapOf(sampler.wrapS);
        texture.wrapV = wrapOf(sampler.wrapT);
        texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    result = static_cast<int>(context_.scene.textures.size());
    context_.scene.textures.push_back({nameOr(source.name, context_.scene.images[*image].name), texture});
    return result;
}

std::optional<int> GltfTextures::imageOf(int index, const std::string& where) {
    if (static_cast<std::size_t>(index) >= context_.document.images.size())
        throw InputError{where, fmt::format("image {} does not exist", index), "export the file again"};
    if (const auto known = images_.find(index); known != images_.end()) return known->second;

    auto& result = images_[index];
    context_.poll();
    try {
        Image image = decode(index, context_.document.at("images", static_cast<std::size_t>(index)));
        decodedBytes_ += image.pixels->values().size() * sizeof(Rgba8);
        result = static_cast<int>(context_.scene.images.size());
        context_.scene.images.push_back(std::move(image));
    } catch (const InputError& error) {
        context_.notes.repaired(fmt::format("{}; the surface shows without it", error.what()));
    }
    return result;
}

Image GltfTextures::decode(int index, const std::string& where) const {
    const GltfImageSource& source = context_.document.images[index];
    std::vector<std::byte> bytes;
    if (source.uri.empty()) {
        const auto view = viewBytes(context_.document, source.bufferView, where);
        bytes.assign(view.begin(), view.end());
    } else {
        bytes = context_.files.read(source.uri, limits::kFileBytes, where);
    }
    DecodedImage decoded = decodeImage(bytes, where);
    if (decoded.pixels.values().size() * sizeof(Rgba8) > limits::kImageBytes - decodedBytes_)
        throw InputError{where, fmt::format("the images take more than {} MB", limits::kImageBytes >> 20U),
                         "use smaller images"};
    return {nameOr(source.name, fmt::format("image {}", index)),
            std::make_shared<const ByteImage>(std::move(decoded.pixels)),
            std::make_shared<const std::vector<std::byte>>(std::move(bytes))};
}

}
