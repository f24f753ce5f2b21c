#include <fmt/format.h>

#include "app/gui/panels.h"

namespace eyeray {

void scenePanel(const Widgets& ui) {
    static const std::vector<BuiltinScene> scenes = builtinScenes();
    const OpenedScene& opened = ui.viewer.opened();
    ImGui::SetNextItemWidth(-1);
    const std::string shown =
        ui.viewer.loading() ? fmt::format("loading {}…", ui.viewer.loadingName()) : opened.reference;
    const bool open = ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLarge);
    ui.mark("scene");
    if (open) {
        for (const BuiltinScene& scene : scenes) {
            if (ImGui::Selectable(scene.name.c_str(), scene.name == opened.reference))
                ui.execute({"open", {{"scene", scene.name}}}, {});
            ui.mark("scene=" + scene.name);
            ui.tooltip(scene.whatToLookAt);
        }
        ImGui::EndCombo();
    } else {
        ui.tooltip("the built-in scenes; Ctrl+O opens a file");
    }
    if (!ui.viewer.hasScene()) return;
    if (const std::string& line = ui.viewer.document().scene->whatToLookAt; !line.empty())
        ImGui::TextWrapped("%s", line.c_str());
    if (!opened.report.lines.empty()) {
        ui.button("Import report", "dialog show=report",
                  "what was added to this file or is not shown as it says");
        ImGui::SameLine();
        dimmedText(fmt::format("{} lines", opened.report.lines.size()));
    }
}

}
