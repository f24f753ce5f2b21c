#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_import.h"
#include "core/scene/gltf_textures.h"

namespace eyeray {

namespace {

constexpr Range kIor{0.1, 10}; // of taught materials; glTF itself starts at 1
constexpr std::array<std::string_view, 6> kRead{
    "KHR_materials_emissive_strength", "KHR_materials_ior",   "KHR_materials_specular",
    "KHR_materials_transmission",      "KHR_materials_unlit", "KHR_materials_volume"};

class MaterialImport {
public:
    MaterialImport(GltfImport& context, GltfTextures& textures, std::size_t index)
        : context_(context), textures_(textures), source_(context.document.model.materials[index]),
          where_(context.document.at("materials", index)),
          name_(nameOr(source_.name, fmt::format("material {}", index))) {}

    Material run() {
        GltfFields extras = eyerayExtras(source_.extras, where_, context_.notes);
        GltfMaterial physical;
        readCore(physical);
        readExtensions(physical);
        noteUnshown();
        if (GltfFields board = extras.child("checker"); board.present())
            physical.baseColorTexture = textures_.checker(board);
        GltfFields taught = extras.child("taught");
        extras.reportUnread();
        if (!taught.present()) return {name_, physical};
        return {name_, readTaught(taught, physical.baseColorTexture)};
    }

private:
    float factor(double value, Range range, const char* key) {
        return static_cast<float>(clamped(value, range.lo, range.hi, where_ + "." + key, context_.notes));
    }

    Color color(const std::vector<double>& values, const char* key) {
        return {factor(values[0], kUnit, key), factor(values[1], kUnit, key), factor(values[2], kUnit, key)};
    }

    GltfFields extension(const char* name) {
        return extensionFields(source_.extensions, name, where_, context_.notes);
    }

    void readCore(GltfMaterial& m) {
        const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
        if (pbr.baseColorFactor.size() != 4 || source_.emissiveFactor.size() != 3)
            throw InputError{where_, "a colour has too few or too many numbers", "export the file again"};
        m.baseColor = color(pbr.baseColorFactor, "baseColorFactor");
        m.baseColorTexture = textures_.reference(pbr.baseColorTexture, where_ + ".baseColorTexture");
        m.metallic = factor(pbr.metallicFactor, kUnit, "metallicFactor");
        m.roughness = factor(pbr.roughnessFactor, kUnit, "roughnessFactor");
        m.metallicRoughnessTexture =
            textures_.reference(pbr.metallicRoughnessTexture, where_ + ".metallicRoughnessTexture");
        m.emissive = color(source_.emissiveFactor, "emissiveFactor");
        m.emissiveTexture = textures_.reference(source_.emissiveTexture, where_ + ".emissiveTexture");
    }

    void readExtensions(GltfMaterial& m) {
        m.emissiveStrength = extension("KHR_materials_emissive_strength")
                                 .real("emissiveStrength", m.emissiveStrength, kNotNegative);
        m.ior = extension("KHR_materials_ior").real("ior", m.ior, {1, kIor.hi});

        GltfFields transmission = extension("KHR_materials_transmission");
        m.transmission = transmission.real("transmissionFactor", m.transmission, kUnit);
        m.transmissionTexture = textures_.reference(transmission, "transmissionTexture");

        GltfFields specular = extension("KHR_materials_specular");
        m.specular = specular.real("specularFactor", m.specular, kUnit);
        m.specularColor = specular.color("specularColorFactor", m.specularColor);

        GltfFields volume = extension("KHR_materials_volume");
        m.thickness = volume.real("thicknessFactor", m.thickness, kNotNegative);
        m.attenuationDistance = volume.real("attenuationDistance", m.attenuationDistance, kPositive);
        m.attenuationColor = volume.color("attenuationColor", m.attenuationColor, kUnit);

        for (const char* const key : {"specularTexture", "specularColorTexture"})
            if (specular.has(key)) note(key);
        if (volume.has("thicknessTexture")) note("thicknessTexture");
    }

    TaughtMaterial readTaught(GltfFields& fields, const TextureRef& texture) {
        TaughtMaterial m;
        m.ambient = fields.color("ambient", m.ambient);
        m.diffuse = fields.color("diffuse", m.diffuse);
        m.diffuseTexture = texture;
        m.specular = fields.color("specular", m.specular);
        m.shininess = fields.real("shininess", m.shininess, kNotNegative);
        m.specularModel = readModel(fields);
        m.reflectivity = fields.color("reflectivity", m.reflectivity);
        m.transmission = fields.color("transmission", m.transmission);
        m.ior = fields.real("ior", m.ior, kIor);
        m.attenuation = fields.color("attenuation", m.attenuation);
        m.emission = fields.color("emission", m.emission);
        fields.reportUnread();
        return m;
    }

    static SpecularModel readModel(GltfFields& fields) {
        const std::string model = fields.text("model", "phong");
        if (model == "phong") return SpecularModel::Phong;
        if (model != "blinn-phong") fields.refuse("model is neither phong nor blinn-phong");
        return SpecularModel::BlinnPhong;
    }

    void noteUnshown() {
        if (source_.normalTexture.index >= 0) note("normalTexture");
        if (source_.occlusionTexture.index >= 0) note("occlusionTexture");
        if (source_.alphaMode != "OPAQUE") note("alphaMode " + printable(source_.alphaMode, 20));
        for (const auto& extension : source_.extensions) {
            const std::string& name = extension.first;
            const bool read = std::find(kRead.begin(), kRead.end(), name) != kRead.end();
            if (!read || name == "KHR_materials_unlit") note(printable(name, limits::kNameBytes));
        }
    }

    void note(const std::string& feature) { context_.notes.ignoredOne(feature, "material"); }

    GltfImport& context_;
    GltfTextures& textures_;
    const tinygltf::Material& source_;
    std::string where_, name_;
};

}

void importMaterials(GltfImport& context) {
    GltfTextures textures(context);
    for (std::size_t i = 0; i < context.document.model.materials.size(); ++i)
        context.scene.materials.push_back(MaterialImport(context, textures, i).run());
}

}
