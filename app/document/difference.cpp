#include <fmt/format.h>

#include <algorithm>

#include "app/document/document.h"
#include "app/document/document_commands.h"
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
            return {
                {"type", "spot"}, {"outer", degreesText(s.outerCone)}, {"inner", degreesText(s.innerCone)}};
        }
        Arguments operator()(const RectangleLamp& r) const {
            return {{"type", "rectangle"}, {"width", toText(r.width)}, {"height", toText(r.height)}};
        }
        Arguments operator()(const DiscLamp& d) const {
            return {{"type", "disc"}, {"radius", toText(d.radius)}};
        }
        Arguments operator()(const SphereLamp& s) const {
            return {{"type", "sphere"}, {"radius", toText(s.radius)}};
        }
    };
    return std::visit(Describe{}, shape);
}

Arguments changes(const LampShape& from, const LampShape& to) {
    const Arguments before = shapeArguments(from);
    Arguments changed = shapeArguments(to);
    if (from.index() == to.index())
        std::erase_if(changed, [&](const Command::Argument& argument) {
            return std::find(before.begin(), before.end(), argument) != before.end();
        });
    return changed;
}

Arguments changes(const Light& from, const Light& to) {
    Arguments changed = changes(from.shape, to.shape);
    ifChanged(changed, "enabled", from.enabled, to.enabled);
    ifChanged(changed, "falloff", from.falloff, to.falloff);
    ifChanged(changed, "color", from.color, to.color);
    ifChanged(changed, "intensity", from.intensity, to.intensity);
    ifChanged(changed, "position", DVec3(from.transform[3]), DVec3(to.transform[3]));
    // of two lamps with one direction, one may still be turned about it
    if (DMat3(from.transform) != DMat3(to.transform))
        changed.emplace_back("direction", toText(-DVec3(to.transform[2])));
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
    Arguments changed = std::visit(
        [&](const auto& model) {
            return changes(std::get<std::decay_t<decltype(model)>>(from.model), model);
        },
        to.model);
    if (needsOf(from.model).textured && !needsOf(to.model).textured)
        changed.emplace_back("textures", toText(false));
    return changed;
}

/// Which of `from` the first lamps of `to` are: edits keep the order, and new lamps come last.
std::vector<std::size_t> keptLights(const std::vector<Light>& from, const std::vector<Light>& to) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < from.size() && kept.size() < to.size(); ++i) {
        const Light& next = to[kept.size()];
        if (from[i].name == next.name && from[i].range == next.range &&
            from[i].followsCamera == next.followsCamera)
            kept.push_back(i);
    }
    return kept;
}

void addLightChanges(std::vector<Command>& commands, const std::vector<Light>& from,
                     const std::vector<Light>& to) {
    const std::vector<std::size_t> kept = keptLights(from, to);
    for (std::size_t i = from.size(); i-- > 0;)
        if (!std::binary_search(kept.begin(), kept.end(), i))
            commands.push_back({"remove-light", {{"light", fmt::format("{}", i)}}});
    for (std::size_t i = kept.size(); i < to.size(); ++i)
        commands.push_back({"add-light", {{"name", to[i].name}}});
    for (std::size_t i = 0; i < to.size(); ++i) {
        Light before = i < kept.size() ? from[kept[i]] : addedLight(to[i].name);
        if (i >= kept.size())
            before.transform *= std::numeric_limits<double>::quiet_NaN(); // differs from all
        addChanged(commands, "light", "light", fmt::format("{}", i), changes(before, to[i]));
    }
}

void addSceneChanges(std::vector<Command>& commands, const Scene& from, const Scene& to) {
    for (std::size_t i = 0; i < to.objects.size(); ++i)
        addChanged(commands, "object", "object", fmt::format("{}", i),
                   changes(from.objects[i], to.objects[i]));
    for (std::size_t i = 0; i < to.materials.size(); ++i)
        addChanged(commands, "material", "material", fmt::format("{}", i),
                   changes(from.materials[i], to.materials[i]));
    addLightChanges(commands, from.lights, to.lights);

    Arguments sky;
    ifChanged(sky, "zenith", from.environment.zenith, to.environment.zenith);
    ifChanged(sky, "horizon", from.environment.horizon, to.environment.horizon);
    ifChanged(sky, "nadir", from.environment.nadir, to.environment.nadir);
    if (!sky.empty()) commands.emplace_back("environment", sky);
    if (from.ambient != to.ambient) commands.push_back({"ambient", {{"color", toText(to.ambient)}}});
}

}

std::vector<Command> commandsBetween(const Document& from, const Document& to) {
    if (from.lab != nullptr && from.lab == to.lab && from.labValue != to.labValue) {
        const Command slid("lab", {{"value", toText(to.labValue)}});
        std::vector<Command> commands = commandsBetween(apply(from, slid), to);
        commands.insert(commands.begin(), slid);
        return commands;
    }
    std::vector<Command> commands;
    for (const Command& command : {changedSettings(from, to), changedCamera(from.camera, to.camera)})
        if (!command.arguments().empty()) commands.push_back(command);
    if (from.scene != to.scene) addSceneChanges(commands, *from.scene, *to.scene);
    const std::string layer = shownLayer(to).name; // after the lamp it may be of
    if (shownLayer(from).name != layer) commands.push_back({"layer", {{"name", layer}}});
    return commands;
}

}
