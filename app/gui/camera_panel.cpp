#include <fmt/format.h>

#include <array>

#include "app/document/settings.h"
#include "app/gui/panels.h"

namespace eyeray {
namespace {

struct AspectPreset {
    const char* label;
    double ratio;
};
constexpr std::array kAspects = {AspectPreset{"free", 0.0}, AspectPreset{"1:1", 1.0},
                                 AspectPreset{"4:3", 4.0 / 3}, AspectPreset{"3:2", 1.5},
                                 AspectPreset{"16:9", 16.0 / 9}};

void aspectButtons(const Widgets& ui) {
    const double aspect = ui.viewer.document().aspect;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Aspect");
    for (const AspectPreset& preset : kAspects) {
        ImGui::SameLine();
        const bool current = std::abs(aspect - preset.ratio) < 1e-6;
        if (current) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_ButtonActive]);
        if (ImGui::SmallButton(preset.label)) ui.execute({"set", {{"aspect", preset.label}}}, {});
        if (current) ImGui::PopStyleColor();
        ui.mark(fmt::format("aspect={}", preset.label));
        ui.tooltip(settingNamed("aspect").help);
    }
}

/// The lectures' image plane: corners (±a·tan(fov/2), ±tan(fov/2), −1).
void imagePlane(double fov, double aspect) {
    const DVec2 half = imagePlaneHalfExtents(fov, aspect);
    ImGui::Text("corners  (±%.4f, ±%.4f, −1)", half.x, half.y);
    dimmedText(fmt::format("x = a·tan(fov/2), y = tan(fov/2), a = {:.4g}; horizontal fov {:.2f}°", aspect,
                           degrees(2 * std::atan(half.x))));
}

void sceneCameras(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    if (document.scene->cameras.size() < 2) return;
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##camera", document.camera.name.c_str());
    ui.mark("camera");
    if (!open) return ui.tooltip("the cameras of the scene; C for the next");
    for (std::size_t i = 0; i < document.scene->cameras.size(); ++i) {
        const std::string& name = document.scene->cameras[i].name;
        if (ImGui::Selectable(fmt::format("{}##{}", name, i).c_str(), name == document.camera.name))
            ui.execute({"camera", {{"camera", fmt::format("{}", i)}}}, {});
    }
    ImGui::EndCombo();
}

}

void cameraPanel(const Widgets& ui) {
    const Document& document = ui.viewer.document();
    ui.number("Field of view", "fov", 1, 170, "%.1f°");
    if (isPhysical(document.render.trace.method)) {
        ui.number("Lens radius", "lens", 0, 0.5F, "%.3f m");
        ui.number("Focus distance", "focus", 0, 20, "%.2f m");
    }
    aspectButtons(ui);
    const PictureSize size = ui.viewer.pictureSize();
    if (size.width > 0 && size.height > 0)
        imagePlane(document.camera.verticalFov, static_cast<double>(size.width) / size.height);
    sceneCameras(ui);
    const Command camera("camera");
    ui.partPosition(camera, "Eye", "eye", document.camera.eye);
    ui.partPosition(camera, "Target", "target", document.camera.target);
}

}
