#include <algorithm>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_import.h"
#include "core/scene/gltf_units.h"

namespace eyeray {

namespace {

constexpr const char* kPunctual = "KHR_lights_punctual";

Color colorOf(const tinygltf::Light& light, const std::string& where, GltfNotes& notes) {
    if (light.color.empty()) return Color(1);
    if (light.color.size() != 3) throw InputError{where, "color has not 3 numbers", "export the file again"};
    Color color;
    for (int i = 0; i < 3; ++i)
        color[i] = static_cast<float>(clamped(light.color[i], 0, limits::kNumber, where + ".color", notes));
    return color;
}

SpotLamp spotOf(const tinygltf::SpotLight& spot, const std::string& where, GltfNotes& notes) {
    constexpr double kNarrowest = 1e-6; // between the cones, so that the edge has a width
    const double outer = clamped(spot.outerConeAngle, kNarrowest, kPiD / 2, where + ".outerConeAngle", notes);
    return {clamped(spot.innerConeAngle, 0, outer - kNarrowest, where + ".innerConeAngle", notes), outer};
}

std::optional<LampShape> shapeOf(const tinygltf::Light& light, const std::string& where, GltfNotes& notes) {
    if (light.type == "point") return PointLamp{};
    if (light.type == "directional") return DirectionalLamp{};
    if (light.type == "spot") return spotOf(light.spot, where, notes);
    notes.ignored(where + ": a lamp of this type is not known");
    return std::nullopt;
}

}

std::optional<Light> importPunctualLight(GltfImport& context, int node) {
    const auto& model = context.document.model;
    GltfFields reference =
        extensionFields(model.nodes[node].extensions, kPunctual,
                        context.document.at("nodes", static_cast<std::size_t>(node)), context.notes);
    const auto index = reference.index("light", model.lights.size());
    if (!index) return std::nullopt;

    const tinygltf::Light& source = model.lights[*index];
    const std::string where = context.document.at("lights", static_cast<std::size_t>(*index));
    const auto shape = shapeOf(source, where, context.notes);
    if (!shape) return std::nullopt;

    GltfFields extras = eyerayExtras(source.extras, where, context.notes);
    Light light;
    light.name = source.name;
    light.shape = *shape;
    light.color = colorOf(source, where, context.notes);
    light.falloff = extras.flag("falloff", true);
    light.enabled = extras.flag("enabled", true);
    light.followsCamera = extras.flag("followsCamera", false);
    light.intensity = clamped(source.intensity, 0, limits::kNumber, where + ".intensity", context.notes);
    if (light.falloff) light.intensity /= kLumensPerWatt;
    if (source.range != 0)
        light.range = clamped(source.range, kPositive.lo, kPositive.hi, where + ".range", context.notes);
    extras.reportUnread();
    return light;
}

std::optional<Light> importAreaLamp(GltfFields& nodeExtras) {
    GltfFields fields = nodeExtras.child("lamp");
    if (!fields.present()) return std::nullopt;
    Light light;
    const std::string type = fields.text("type", "rectangle");
    if (type == "rectangle")
        light.shape =
            RectangleLamp{fields.number("width", 1, kPositive), fields.number("height", 1, kPositive)};
    else if (type == "disc")
        light.shape = DiscLamp{fields.number("radius", DiscLamp{}.radius, kPositive)};
    else if (type == "sphere")
        light.shape = SphereLamp{fields.number("radius", SphereLamp{}.radius, kPositive)};
    else
        fields.refuse("type is none of rectangle, disc and sphere");
    light.color = fields.color("color", light.color);
    light.intensity = fields.number("intensity", light.intensity, kNotNegative);
    if (fields.has("range")) light.range = fields.number("range", 0, kPositive);
    light.falloff = fields.flag("falloff", true);
    light.enabled = fields.flag("enabled", true);
    light.followsCamera = fields.flag("followsCamera", false);
    fields.reportUnread();
    return light;
}

}
