#include <fmt/format.h>

#include <array>

#include "app/gui/panels.h"

namespace eyeray {
namespace {

struct Medium {
    const char* label;
    const char* ior;
    const char* help;
};
constexpr std::array kMedia = {
    Medium{"vacuum", "1", "η = 1.0"},
    Medium{"air", "1.000277", "η = 1.000277"},
    Medium{"water", "1.33", "η = 1.33; light travels at 0.752 c"},
    Medium{"glass", "1.49", "η = 1.49, the lecture's value (acrylic); light travels at 0.671 c"},
    Medium{"crown", "1.52", "η = 1.52, crown (window) glass; light travels at 0.658 c"},
    Medium{"diamond", "2.42", "η = 2.42; light travels at 0.413 c"}};

void iorButtons(const Widgets& ui, const Command& material, float ior) {
    int column = 0;
    for (const Medium& medium : kMedia) {
        if (column++ % 3 != 0) ImGui::SameLine();
        const bool current = std::abs(ior - static_cast<float>(*toNumber(medium.ior))) < 1e-6F;
        if (current) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_ButtonActive]);
        const float width = (ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x -
                             2 * ImGui::GetStyle().ItemSpacing.x) /
                            3;
        if (ImGui::Button(medium.label, {width, 0})) ui.part(material, "ior", medium.ior, false);
        if (current) ImGui::PopStyleColor();
        ui.mark(fmt::format("ior={}", medium.label));
        ui.tooltip(medium.help);
    }
}

void specularModel(const Widgets& ui, const Command& material, SpecularModel model) {
    int chosen = static_cast<int>(model);
    for (const auto& [label, name, value] :
         {std::tuple{"Phong", "phong", 0}, {"Blinn-Phong", "blinn-phong", 1}}) {
        if (value > 0) ImGui::SameLine();
        if (ImGui::RadioButton(label, &chosen, value)) ui.part(material, "model", name, false);
        ui.mark(fmt::format("model={}", name));
    }
}

void materialOf(const Widgets& ui, const Command& material, const TaughtMaterial& m) {
    ui.partColor(material, "ambient ka", "ambient", m.ambient);
    ui.partColor(material, "diffuse kd", "diffuse", m.diffuse);
    ui.partColor(material, "specular ks", "specular", m.specular);
    ui.partNumber(material, "shininess", "shininess", m.shininess, 1, 1000, "%.0f", true);
    specularModel(ui, material, m.specularModel);
    ui.partColor(material, "reflection kr", "reflectivity", m.reflectivity);
    ui.partColor(material, "transmission kt", "transmission", m.transmission);
    if (isBlack(m.transmission)) return dimmedText("kt = 0: opaque, so its index of refraction does nothing");
    ui.partNumber(material, "index η", "ior", m.ior, 1, 3, "%.4f");
    iorButtons(ui, material, m.ior);
    ui.partColor(material, "attenuation σ", "attenuation", m.attenuation);
}

void materialOf(const Widgets& ui, const Command& material, const GltfMaterial& m) {
    ui.partColor(material, "base colour", "base-color", m.baseColor);
    ui.partNumber(material, "metallic", "metallic", m.metallic, 0, 1, "%.2f");
    ui.partNumber(material, "roughness", "roughness", m.roughness, 0, 1, "%.2f");
    ui.partColor(material, "emissive", "emissive", m.emissive);
    ui.partNumber(material, "transmission", "transmission", m.transmission, 0, 1, "%.2f");
    ui.partNumber(material, "index η", "ior", m.ior, 1, 3, "%.4f");
    iorButtons(ui, material, m.ior);
    if (m.transmission <= 0) return;
    ui.partColor(material, "colour inside", "attenuation-color", m.attenuationColor);
    const double distance = std::isfinite(m.attenuationDistance) ? m.attenuationDistance : 1000.0;
    ui.partNumber(material, "at depth (m)", "attenuation-distance", distance, 0.001, 1000, "%.3f", true);
}

/// Taught weights may add up to more than the light that arrives.
void energyMeter(const TaughtMaterial& m) {
    const float energy = maxComponent(m.diffuse + m.reflectivity + m.transmission);
    ImGui::ProgressBar(std::min(energy, 1.0F), {-1, 0}, fmt::format("kd + kr + kt = {:.2f}", energy).c_str());
    if (energy > 1.0005F)
        dimmedText("more light leaves than arrives: fine for a picture, impossible in nature");
}
void energyMeter(const GltfMaterial&) {}

}

void objectPanel(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    const auto& objects = document.scene->objects;
    if (document.selectedObject < 0 || document.selectedObject >= static_cast<int>(objects.size()))
        return dimmedText("click an object in the picture to change its material; Shift-drag moves it");
    const Object& object = objects[static_cast<std::size_t>(document.selectedObject)];
    const Material& material = document.scene->materials[static_cast<std::size_t>(object.material)];
    ImGui::TextWrapped("%s", object.name.c_str());
    const Command objectCommand("object", {{"object", fmt::format("{}", document.selectedObject)}});
    ui.partFlag(objectCommand, "visible", "visible", object.visible);
    ui.partPosition(objectCommand, "Position", "position", DVec3(object.transform[3]));
    ImGui::Separator();
    dimmedText(fmt::format("material {}", material.name));
    const Command materialCommand("material", {{"material", fmt::format("{}", object.material)}});
    ImGui::PushID(object.material);
    std::visit([&](const auto& model) { materialOf(ui, materialCommand, model); }, material.model);
    std::visit([](const auto& model) { energyMeter(model); }, material.model);
    ImGui::PopID();
}

}
