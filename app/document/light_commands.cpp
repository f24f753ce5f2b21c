#include <fmt/format.h>

#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kLampNames = {"point"sv, "directional"sv, "spot"sv, "rectangle"sv, "disc"sv, "sphere"sv};
constexpr double kBrightest = 1e9;
constexpr double kSmallest = 1e-6, kLargest = 1e6; // metres

LampShape lampShape(int kind) {
    switch (kind) {
    case 0:
        return PointLamp{};
    case 1:
        return DirectionalLamp{};
    case 2:
        return SpotLamp{};
    case 3:
        return RectangleLamp{};
    case 4:
        return DiscLamp{};
    default:
        return SphereLamp{};
    }
}

/// Rotation whose −z is `direction`, with the position kept. A unit vector is taken as it stands, so that a
/// direction written and read again gives the same bits.
void pointAlong(DMat4& transform, const DVec3& direction, const Command& command) {
    const bool unit = std::abs(glm::dot(direction, direction) - 1) < 1e-14;
    const DVec3 z = unit ? -direction : -safeNormalize(direction);
    if (glm::length(z) == 0)
        throw InputError(command.text(), "the direction is zero", "give a direction such as 0,-1,0");
    const DVec3 x = safeNormalize(glm::cross(std::abs(z.y) < 0.99 ? DVec3(0, 1, 0) : DVec3(1, 0, 0), z));
    transform[0] = DVec4(x, 0);
    transform[1] = DVec4(glm::cross(z, x), 0);
    transform[2] = DVec4(z, 0);
}

void resize(LampShape& shape, const Command& command) {
    if (auto* spot = std::get_if<SpotLamp>(&shape)) {
        if (const auto outer = command.number("outer", 0.1, 89.9)) spot->outerCone = radians(*outer);
        if (const auto inner = command.number("inner", 0, 89.9)) spot->innerCone = radians(*inner);
        spot->innerCone = std::min(spot->innerCone, spot->outerCone);
    } else if (auto* rectangle = std::get_if<RectangleLamp>(&shape)) {
        rectangle->width = command.number("width", kSmallest, kLargest).value_or(rectangle->width);
        rectangle->height = command.number("height", kSmallest, kLargest).value_or(rectangle->height);
    } else if (auto* disc = std::get_if<DiscLamp>(&shape)) {
        disc->radius = command.number("radius", kSmallest, kLargest).value_or(disc->radius);
    } else if (auto* sphere = std::get_if<SphereLamp>(&shape)) {
        sphere->radius = command.number("radius", kSmallest, kLargest).value_or(sphere->radius);
    }
}

void change(Light& light, const Command& command) {
    if (const auto kind = command.choice("type", kLampNames)) light.shape = lampShape(*kind);
    resize(light.shape, command);
    light.enabled = command.flag("enabled").value_or(light.enabled);
    light.falloff = command.flag("falloff").value_or(light.falloff);
    light.color = command.color("color").value_or(light.color);
    light.intensity = command.number("intensity", 0, kBrightest).value_or(light.intensity);
    if (const auto position = command.triple("position")) light.transform[3] = DVec4(*position, 1);
    if (const auto direction = command.triple("direction")) pointAlong(light.transform, *direction, command);
}

void light(Document& document, const Command& command) {
    command.allowOnly({"light", "enabled", "color", "intensity", "falloff", "position", "direction", "type",
                       "outer", "inner", "width", "height", "radius"});
    const int index = itemIndex(command, "light", document.scene->lights);
    change(editableScene(document).lights[static_cast<std::size_t>(index)], command);
}

void addLight(Document& document, const Command& command) {
    command.allowOnly({"type", "name", "enabled", "color", "intensity", "falloff", "position", "direction",
                       "outer", "inner", "width", "height", "radius"});
    constexpr std::size_t kMostLights = 1000;
    if (document.scene->lights.size() >= kMostLights)
        throw InputError(command.text(), "the scene has 1000 lamps already", "remove one first");
    Scene& scene = editableScene(document);
    Light added = addedLight(command.find("name").value_or(fmt::format("lamp {}", scene.lights.size() + 1)));
    const SceneBounds bounds = boundsOf(scene);
    added.transform[3] = DVec4(bounds.center() + DVec3(0, bounds.radius(), 0), 1);
    pointAlong(added.transform, DVec3(0, -1, 0), command);
    change(added, command);
    scene.lights.push_back(std::move(added));
}

void removeLight(Document& document, const Command& command) {
    command.allowOnly({"light"});
    const int index = itemIndex(command, "light", document.scene->lights);
    auto& lights = editableScene(document).lights;
    lights.erase(lights.begin() + index);
}

void ambient(Document& document, const Command& command) {
    command.allowOnly({"color"});
    command.required("color");
    editableScene(document).ambient = *command.color("color");
}

void environment(Document& document, const Command& command) {
    command.allowOnly({"zenith", "horizon", "nadir"});
    Environment& environment = editableScene(document).environment;
    environment.zenith = command.color("zenith").value_or(environment.zenith);
    environment.horizon = command.color("horizon").value_or(environment.horizon);
    environment.nadir = command.color("nadir").value_or(environment.nadir);
}

constexpr std::array kCommands = {
    DocumentCommand{
        "light",
        "light=NAME enabled=on|off color=r,g,b intensity=I falloff=on|off position=x,y,z direction=x,y,z "
        "type=point|directional|spot|rectangle|disc|sphere outer=DEG inner=DEG width=M height=M radius=M",
        "Changes a lamp.", light},
    DocumentCommand{"add-light", "type=… name=… and as light", "Adds a lamp above the scene.", addLight},
    DocumentCommand{"remove-light", "light=NAME", "Removes a lamp.", removeLight},
    DocumentCommand{"ambient", "color=r,g,b", "Sets the ambient light Ia.", ambient},
    DocumentCommand{"environment", "zenith=r,g,b horizon=r,g,b nadir=r,g,b", "Sets the sky.", environment},
};

}

Light addedLight(std::string name) {
    Light light;
    light.name = std::move(name);
    light.falloff = false;
    light.intensity = 0.5;
    return light;
}

std::span<const DocumentCommand> lightCommands() { return kCommands; }

}
