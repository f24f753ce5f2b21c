#include <fmt/format.h>

#include "app/gui/panels.h"

namespace eyeray {
namespace {

const char* kindOf(const LampShape& shape) {
    struct Name {
        const char* operator()(const PointLamp&) const { return "point"; }
        const char* operator()(const DirectionalLamp&) const { return "directional"; }
        const char* operator()(const SpotLamp&) const { return "spot"; }
        const char* operator()(const RectangleLamp&) const { return "rectangle"; }
        const char* operator()(const DiscLamp&) const { return "disc"; }
        const char* operator()(const SphereLamp&) const { return "sphere"; }
    };
    return std::visit(Name{}, shape);
}

void shapeOf(const Widgets& ui, const Command& command, const LampShape& shape) {
    if (const auto* spot = std::get_if<SpotLamp>(&shape)) {
        ui.partNumber(command, "cone", "outer", degrees(spot->outerCone), 1, 89, "%.0f°");
        ui.partNumber(command, "inner cone", "inner", degrees(spot->innerCone), 0, 89, "%.0f°");
    } else if (const auto* rectangle = std::get_if<RectangleLamp>(&shape)) {
        ui.partNumber(command, "width (m)", "width", rectangle->width, 0.01, 100, "%.2f", true);
        ui.partNumber(command, "height (m)", "height", rectangle->height, 0.01, 100, "%.2f", true);
    } else if (const auto* disc = std::get_if<DiscLamp>(&shape)) {
        ui.partNumber(command, "radius (m)", "radius", disc->radius, 0.001, 100, "%.3f", true);
    } else if (const auto* sphere = std::get_if<SphereLamp>(&shape)) {
        ui.partNumber(command, "radius (m)", "radius", sphere->radius, 0.001, 100, "%.3f", true);
    }
    if (hasSurface(shape)) dimmedText("local, cast and whitted take this lamp as one point at its centre");
}

void lamp(const Widgets& ui, const Light& light, std::size_t index) {
    const std::string number = fmt::format("{}", index);
    const Command command("light", {{"light", number}});
    ImGui::PushID(static_cast<int>(index));
    bool on = light.enabled;
    const bool switched = ImGui::Checkbox("##on", &on);
    ui.mark("lamp " + light.name);
    ui.tooltip("this lamp on or off");
    if (switched) ui.part(command, "enabled", toText(on), false);
    ImGui::SameLine();
    const bool open = ImGui::TreeNodeEx("lamp", 0, "%s (%s)", light.name.c_str(), kindOf(light.shape));
    ui.mark("open lamp " + light.name);
    if (open) {
        ui.partColor(command, "colour", "color", light.color);
        ui.partNumber(command, light.falloff ? "intensity" : "strength c", "intensity", light.intensity, 0,
                      std::max(10.0, light.intensity * 2), "%.3g");
        ui.partFlag(command, "falls off with distance²", "falloff", light.falloff);
        ui.partPosition(command, "position", "position", DVec3(light.transform[3]));
        ui.partPosition(command, "direction", "direction", -DVec3(light.transform[2]));
        shapeOf(ui, command, light.shape);
        if (ImGui::SmallButton("remove")) ui.execute({"remove-light", {{"light", number}}}, {});
        ui.mark("remove lamp " + light.name);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

}

void lightsPanel(const Widgets& ui) {
    const auto scene = ui.viewer.document().scene;
    for (std::size_t i = 0; i < scene->lights.size(); ++i) lamp(ui, scene->lights[i], i);
    if (scene->lights.empty()) dimmedText("the scene has no lamp");
    for (const char* kind : {"point", "spot", "directional", "rectangle", "disc", "sphere"}) {
        if (std::string_view(kind) != "point") flow(ImGui::CalcTextSize(kind).x + 2 * ImGui::GetFontSize());
        if (ImGui::SmallButton(fmt::format("+ {}", kind).c_str()))
            ui.execute({"add-light", {{"type", kind}}}, {});
        ui.mark(fmt::format("add {}", kind));
        ui.tooltip("adds a lamp above the scene");
    }
    ui.partColor(Command("ambient"), "Ambient Ia", "color", scene->ambient);
    const Command sky("environment");
    ui.partColor(sky, "Sky, zenith", "zenith", scene->environment.zenith);
    ui.partColor(sky, "Sky, horizon", "horizon", scene->environment.horizon);
    ui.partColor(sky, "Below", "nadir", scene->environment.nadir);
    if (!scene->environment.black())
        dimmedText("the sky is background only in local, cast and whitted: it lights nothing");
}

}
