#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"
#include "core/study/picture_model.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kSpecularNames = {"phong"sv, "blinn-phong"sv};
constexpr double kMostIor = 5;

template <class T, class U>
void assign(T& field, const std::optional<U>& value) {
    if (value) field = static_cast<T>(*value);
}

void change(TaughtMaterial& m, const Command& c) {
    c.allowOnly({"material", "ambient", "diffuse", "specular", "shininess", "model", "reflectivity",
                 "transmission", "ior", "attenuation", "emission", "textures"});
    assign(m.ambient, c.color("ambient"));
    assign(m.diffuse, c.color("diffuse"));
    assign(m.specular, c.color("specular"));
    assign(m.shininess, c.number("shininess", 1, 100000));
    assign(m.specularModel, c.choice("model", kSpecularNames));
    assign(m.reflectivity, c.color("reflectivity"));
    assign(m.transmission, c.color("transmission"));
    assign(m.ior, c.number("ior", 1, kMostIor));
    assign(m.attenuation, c.color("attenuation"));
    assign(m.emission, c.color("emission"));
}

void change(GltfMaterial& m, const Command& c) {
    c.allowOnly({"material", "base-color", "metallic", "roughness", "emissive", "emissive-strength",
                 "transmission", "ior", "specular", "specular-color", "attenuation-distance",
                 "attenuation-color", "textures"});
    assign(m.baseColor, c.color("base-color"));
    assign(m.metallic, c.number("metallic", 0, 1));
    assign(m.roughness, c.number("roughness", 0, 1));
    assign(m.emissive, c.color("emissive"));
    assign(m.emissiveStrength, c.number("emissive-strength", 0, 1e9));
    assign(m.transmission, c.number("transmission", 0, 1));
    assign(m.ior, c.number("ior", 1, kMostIor));
    assign(m.specular, c.number("specular", 0, 1));
    assign(m.specularColor, c.color("specular-color"));
    assign(m.attenuationColor, c.color("attenuation-color"));
    if (c.find("attenuation-distance") == "none")
        m.attenuationDistance = kInfinity;
    else
        assign(m.attenuationDistance, c.number("attenuation-distance", 1e-9, 1e9));
}

void material(Document& document, const Command& command) {
    const int index = itemIndex(command, "material", document.scene->materials);
    MaterialModel& model = editableScene(document).materials[static_cast<std::size_t>(index)].model;
    std::visit([&](auto& material) { change(material, command); }, model);
    if (!command.flag("textures").value_or(true)) dropTextures(model);
}

constexpr std::array kCommands = {
    DocumentCommand{"material",
                    "material=NAME, taught: ambient diffuse specular reflectivity transmission attenuation "
                    "emission=r,g,b "
                    "shininess ior=N model=phong|blinn-phong; glTF: base-color emissive specular-color "
                    "attenuation-color=r,g,b metallic roughness transmission ior specular emissive-strength "
                    "attenuation-distance=N; textures=off",
                    "Changes a material.", material},
};

}

std::span<const DocumentCommand> materialCommands() { return kCommands; }

}
