#include <algorithm>

#include <tiny_gltf.h>

#include "core/image/encode.h"
#include "core/scene/gltf_export.h"

namespace eyeray {

using nlohmann::json;

namespace {

int wrapMode(Wrap wrap) {
    if (wrap == Wrap::Clamp) return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    return wrap == Wrap::Mirror ? TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT : TINYGLTF_TEXTURE_WRAP_REPEAT;
}

void exportImage(GltfExport& context, const Image& image) {
    const auto bytes = image.encoded ? *image.encoded : encodeDisplayed(*image.pixels, ImageFormat::Png, {});
    const bool jpeg = bytes.size() > 1 && bytes[0] == std::byte{0xff} && bytes[1] == std::byte{0xd8};
    context.push("images", {{"name", image.name},
                            {"mimeType", jpeg ? "image/jpeg" : "image/png"},
                            {"bufferView", context.view(bytes)}});
}

int exportTexture(GltfExport& context, const Texture& texture) {
    const auto* const image = std::get_if<ImageTexture>(&texture.source);
    if (!image) return -1;
    const int filter = image->nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
    const int sampler = context.push(
        "samplers",
        {{"wrapS", wrapMode(image->wrapU)}, {"wrapT", wrapMode(image->wrapV)}, {"magFilter", filter}});
    return context.push("textures", {{"name", texture.name}, {"source", image->image}, {"sampler", sampler}});
}

class MaterialExport {
public:
    MaterialExport(GltfExport& context, const std::vector<int>& textures)
        : context_(context), textures_(textures) {}

    json run(const Material& material) {
        json result{{"name", material.name}};
        if (const auto* const taught = std::get_if<TaughtMaterial>(&material.model)) {
            GltfMaterial physical = asPhysical(*taught); // what other programs show
            physical.baseColorTexture = taught->diffuseTexture;
            writePhysical(result, physical);
            result["extras"]["eyeray"]["taught"] = taughtJson(*taught);
        } else {
            writePhysical(result, std::get<GltfMaterial>(material.model));
        }
        return result;
    }

private:
    void writePhysical(json& result, const GltfMaterial& m) {
        const Color& c = m.baseColor;
        json& pbr = result["pbrMetallicRoughness"];
        pbr["baseColorFactor"] = {toJson(c.x), toJson(c.y), toJson(c.z), 1};
        pbr["metallicFactor"] = toJson(m.metallic);
        pbr["roughnessFactor"] = toJson(m.roughness);
        writeTexture(pbr, "metallicRoughnessTexture", m.metallicRoughnessTexture);
        writeTexture(result, "emissiveTexture", m.emissiveTexture);
        writeBaseColor(result, m.baseColorTexture);
        writeEmission(result, m);
        writeExtensions(result, m);
    }

    void writeBaseColor(json& result, const TextureRef& ref) {
        if (!ref.used()) return;
        const auto* const checker = std::get_if<CheckerTexture>(&context_.scene.textures[ref.texture].source);
        if (!checker) {
            writeTexture(result["pbrMetallicRoughness"], "baseColorTexture", ref);
            return;
        }
        json& board = result["extras"]["eyeray"]["checker"];
        board = {
            {"even", toJson(checker->even)}, {"odd", toJson(checker->odd)}, {"cells", toJson(ref.scale)}};
        if (ref.offset != Vec2(0)) board["offset"] = toJson(ref.offset);
        if (ref.rotation != 0) board["rotation"] = toJson(ref.rotation);
        if (ref.uvSet != 0) board["texCoord"] = ref.uvSet;
    }

    /// emissiveFactor ends at 1; what is brighter goes into the strength.
    void writeEmission(json& result, const GltfMaterial& m) {
        const float excess = std::max(1.0F, maxComponent(m.emissive));
        result["emissiveFactor"] = toJson(m.emissive / excess);
        if (const float strength = m.emissiveStrength * excess; strength != 1)
            extension(result, "KHR_materials_emissive_strength")["emissiveStrength"] = toJson(strength);
    }

    void writeExtensions(json& result, const GltfMaterial& m) {
        const GltfMaterial defaults;
        if (m.ior != defaults.ior) extension(result, "KHR_materials_ior")["ior"] = toJson(m.ior);
        if (m.transmission > 0 || m.transmissionTexture.used()) {
            json& transmission = extension(result, "KHR_materials_transmission");
            transmission["transmissionFactor"] = toJson(m.transmission);
            writeTexture(transmission, "transmissionTexture", m.transmissionTexture);
        }
        if (m.specular != defaults.specular || m.specularColor != defaults.specularColor)
            extension(result, "KHR_materials_specular") = {{"specularFactor", toJson(m.specular)},
                                                           {"specularColorFactor", toJson(m.specularColor)}};
        const bool absorbs = m.attenuationDistance < kInfinity;
        if (m.thickness > 0 || absorbs || m.attenuationColor != defaults.attenuationColor) {
            json& volume = extension(result, "KHR_materials_volume");
            volume = {{"thicknessFactor", toJson(m.thickness)},
                      {"attenuationColor", toJson(m.attenuationColor)}};
            if (absorbs) volume["attenuationDistance"] = toJson(m.attenuationDistance);
        }
    }

    static json taughtJson(const TaughtMaterial& m) {
        return {{"ambient", toJson(m.ambient)},
                {"diffuse", toJson(m.diffuse)},
                {"specular", toJson(m.specular)},
                {"shininess", toJson(m.shininess)},
                {"model", m.specularModel == SpecularModel::Phong ? "phong" : "blinn-phong"},
                {"reflectivity", toJson(m.reflectivity)},
                {"transmission", toJson(m.transmission)},
                {"ior", toJson(m.ior)},
                {"attenuation", toJson(m.attenuation)},
                {"emission", toJson(m.emission)}};
    }

    void writeTexture(json& owner, const char* key, const TextureRef& ref) {
        if (!ref.used()) return;
        json info{{"index", textures_[ref.texture]}};
        if (ref.uvSet != 0) info["texCoord"] = ref.uvSet;
        if (ref.offset != Vec2(0) || ref.scale != Vec2(1) || ref.rotation != 0)
            info["extensions"][context_.use("KHR_texture_transform")] = {{"offset", toJson(ref.offset)},
                                                                         {"scale", toJson(ref.scale)},
                                                                         {"rotation", toJson(ref.rotation)}};
        owner[key] = std::move(info);
    }

    json& extension(json& owner, const char* name) { return owner["extensions"][context_.use(name)]; }

    GltfExport& context_;
    const std::vector<int>& textures_;
};

}

std::vector<int> exportTextures(GltfExport& context) {
    for (const Image& image : context.scene.images) exportImage(context, image);
    std::vector<int> result;
    result.reserve(context.scene.textures.size());
    for (const Texture& texture : context.scene.textures) result.push_back(exportTexture(context, texture));
    return result;
}

void exportMaterials(GltfExport& context, const std::vector<int>& textures) {
    MaterialExport writer(context, textures);
    for (const Material& material : context.scene.materials) context.push("materials", writer.run(material));
}

}
