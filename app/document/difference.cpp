#include <fmt/format.h>

#include "app/document/document.h"
#include "app/document/settings.h"

namespace eyeray {
namespace {

using Arguments = std::vector<Command::Argument>;

template <class T>
void ifChanged(Arguments& arguments, const char* key, const T& from, const T& to) {
    if (from != to) arguments.emplace_back(key, toText(to));
}
void ifChanged(Arguments& arguments, const char* key, float from, float to) {
    if (from != to) arguments.emplace_back(key, fmt::format("{}", to));
}

void addChanged(std::vector<Command>& commands, const std::string& name, const std::string& noun,
                const std::string& item, Arguments changed) {
    if (changed.empty()) return;
    changed.insert(changed.begin(), {noun, item});
    commands.emplace_back(name, std::move(changed));
}

Command changedSettings(const Document& from, const Document& to) {
    Arguments changed;
    for (const Setting& setting : settings())
        if (setting.get(from) != setting.get(to)) changed.emplace_back(setting.key, setting.get(to));
    return {"set", changed};
}

Command changedCamera(const Camera& from, const Camera& to) {
    Arguments changed;
    ifChanged(changed, "eye", from.eye, to.eye);
    ifChanged(changed, "target", from.target, to.target);
    ifChanged(changed, "up", from.up, to.up);
    return {"camera", changed};
}

Arguments changes(const Object& from, const Object& to) {
    Arguments changed;
    ifChanged(changed, "visible", from.visible, to.visible);
    if (from.material != to.material) changed.emplace_back("material", fmt::format("{}", to.material));
    ifChanged(changed, "x", DVec3(from.transform[0]), DVec3(to.transform[0]));
    ifChanged(changed, "y", DVec3(from.transform[1]), DVec3(to.transform[1]));
    ifChanged(changed, "z", DVec3(from.transform[2]), DVec3(to.transform[2]));
    ifChanged(changed, "position", DVec3(from.transform[3]), DVec3(to.transform[3]));
    return changed;
}

Arguments shapeArguments(const LampShape& shape) {
    struct Describe {
        Arguments operator()(const PointLamp&) const { return {{"type", "point"}}; }
        Arguments operator()(const DirectionalLamp&) const { return {{"type", "directional"}}; }
        Arguments operator()(const SpotLamp& s) const {
            return {{"type", "spot"},
                    {"outer", toText(degrees(s.outerCone))},
                    {"inner", toText(degrees(s.innerCone))}};
        }
        Arguments operator()(const RectangleLamp& r) const {
            return {{"type", "rectangle"}, {"width", toText(r.width)}, {"height", toText(r.height)}};
        }
        Arguments operator()(const SphereLamp& s) const {
            return {{"type", "sphere"}, {"radius", toText(s.radius)}};
        }
    };
    return std::visit(Describe{}, shape);
}

Arguments changes(const Light& from, const Light& to) {
    Arguments changed;
    if (shapeArguments(from.shape) != shapeArguments(to.shape)) changed = shapeArguments(to.shape);
    ifChanged(changed, "enabled", from.enabled, to.enabled);
    ifChanged(changed, "falloff", from.falloff, to.falloff);
    ifChanged(changed, "color", from.color, to.color);
    ifChanged(changed, "intensity", from.intensity, to.intensity);
    ifChanged(changed, "position", DVec3(from.transform[3]), DVec3(to.transform[3]));
    ifChanged(changed, "direction", -DVec3(from.transform[2]), -DVec3(to.transform[2]));
    return changed;
}

Arguments changes(const TaughtMaterial& from, const TaughtMaterial& to) {
    Arguments changed;
    ifChanged(changed, "ambient", from.ambient, to.ambient);
    ifChanged(changed, "diffuse", from.diffuse, to.diffuse);
    ifChanged(changed, "specular", from.specular, to.specular);
    ifChanged(changed, "shininess", from.shininess, to.shininess);
    if (from.specularModel != to.specularModel)
        changed.emplace_back("model", to.specularModel == SpecularModel::Phong ? "phong" : "blinn-phong");
    ifChanged(changed, "reflectivity", from.reflectivity, to.reflectivity);
    ifChanged(changed, "transmission", from.transmission, to.transmission);
    ifChanged(changed, "ior", from.ior, to.ior);
    ifChanged(changed, "attenuation", from.attenuation, to.attenuation);
    ifChanged(changed, "emission", from.emission, to.emission);
    return changed;
}

Arguments changes(const GltfMaterial& from, const GltfMaterial& to) {
    Arguments changed;
    ifChanged(changed, "base-color", from.baseColor, to.baseColor);
    ifChanged(changed, "metallic", from.metallic, to.metallic);
    ifChanged(changed, "roughness", from.roughness, to.roughness);
    ifChanged(changed, "emissive", from.emissive, to.emissive);
    ifChanged(changed, "emissive-strength", from.emissiveStrength, to.emissiveStrength);
    ifChanged(changed, "transmission", from.transmission, to.transmission);
    ifChanged(changed, "ior", from.ior, to.ior);
    ifChanged(changed, "specular", from.specular, to.specular);
    ifChanged(changed, "specular-color", from.specularColor, to.specularColor);
    ifChanged(changed, "attenuation-color", from.attenuationColor, to.attenuationColor);
    if (from.attenuationDistance != to.attenuationDistance)
        changed.emplace_back("attenuation-distance", std::isfinite(to.attenuationDistance)
                                                         ? fmt::format("{}", to.attenuationDistance)
                                                         : std::string("none"));
    return changed;
}

Arguments changes(const Material& from, const Material& to) {
    if (from.model.index() != to.model.index()) return {};
    return std::visit(
        [&](const auto& model) {
            return changes(std::get<std::decay_t<decltype(model)>>(from.model), model);
        },
        to.model);
}

/// Lamps are removed and added at the end only; from the first that does not keep its name on, all are made
/// anew.
void addLightChanges(std::vector<Command>& commands, const std::vector<Light>& from,
                     const std::vector<Light>& to) {
    std::size_t kept = 0;
    while (kept < from.size() && kept < to.size() && from[kept].name == to[kept].name) ++kept;
    for (std::size_t i = from.size(); i > kept; --i)
        commands.push_back({"remove-light", {{"light", fmt::format("{}", i - 1)}}});
    for (std::size_t i = kept; i < to.size(); ++i) commands.push_back({"add-light", {{"name", to[i].name}}});
    for (std::size_t i = 0; i < to.size(); ++i) {
        Light added;
        added.name = to[i].name;
        added.transform = DMat4(0);
        addChanged(commands, "light", "light", fmt::format("{}", i),
                   changes(i < kept ? from[i] : added, to[i]));
    }
}

}

std::vector<Command> commandsBetween(const Document& from, const Document& to) {
    std::vector<Command> commands;
    for (const Command& command : {changedSettings(from, to), changedCamera(from.camera, to.camera)})
        if (!command.arguments().empty()) commands.push_back(command);
    if (from.scene == to.scene) return commands;

    for (std::size_t i = 0; i < to.scene->objects.size(); ++i)
        addChanged(commands, "object", "object", fmt::format("{}", i),
                   changes(from.scene->objects[i], to.scene->objects[i]));
    for (std::size_t i = 0; i < to.scene->materials.size(); ++i)
        addChanged(commands, "material", "material", fmt::format("{}", i),
                   changes(from.scene->materials[i], to.scene->materials[i]));
    addLightChanges(commands, from.scene->lights, to.scene->lights);

    Arguments sky;
    ifChanged(sky, "zenith", from.scene->environment.zenith, to.scene->environment.zenith);
    ifChanged(sky, "horizon", from.scene->environment.horizon, to.scene->environment.horizon);
    ifChanged(sky, "nadir", from.scene->environment.nadir, to.scene->environment.nadir);
    if (!sky.empty()) commands.emplace_back("environment", sky);
    if (from.scene->ambient != to.scene->ambient)
        commands.push_back({"ambient", {{"color", toText(to.scene->ambient)}}});
    return commands;
}

}
