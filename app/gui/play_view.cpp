#include <fmt/format.h>

#include <algorithm>

#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

struct Step {
    const char *label, *command, *help;
};
constexpr std::array kSteps = {Step{"|<", "play to=start", "the eye ray alone"},
                               Step{"<", "play to=back", "one ray back"},
                               Step{">", "play to=next", "the next ray"},
                               Step{"> hit", "play to=hit", "the next ray that hits something"},
                               Step{"> lamp", "play to=light", "the next ray to a lamp"},
                               Step{">|", "play to=end", "all rays"}};

void buttons(const Widgets& ui) {
    const bool running = ui.viewer.player().running();
    if (ImGui::Button(running ? "Stop" : "Play")) ui.execute({"play", {}}, {});
    ui.mark("play");
    ui.tooltip("traces the rays of the pixel one after the other");
    for (const Step& step : kSteps) {
        ImGui::SameLine();
        if (ImGui::Button(step.label)) ui.execute(Command::parse(step.command), {});
        ui.mark(step.command);
        ui.tooltip(step.help);
    }
}

/// The lines that the ray goes through stand out, and come into sight when it is another one.
void listing(const Widgets& ui, const RayRecord& ray, int shown) {
    int* const last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("listed"), 0);
    const bool moved = *last != shown;
    *last = shown;
    const Method method = ui.viewer.document().render.trace.method;
    const std::vector<std::size_t> marked = linesOf(method, ray);
    const auto code = pseudoCode(method);
    ImVec4 band = colorOf(ray.kind, ui.dark);
    band.w = 0.35F;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string line(code[i]);
        if (std::ranges::find(marked, i) == marked.end()) {
            dimmedText(line);
            continue;
        }
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(
            at, {at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetTextLineHeight() + 1},
            ImGui::GetColorU32(band), 3 * ui.scale);
        ImGui::TextUnformatted(line.c_str());
        if (moved) ImGui::SetScrollHereY();
    }
    ImGui::PopStyleVar();
}

}

void playView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture, then play how its pixel is traced");
    if (picked->trace.rays.empty()) return dimmedText("no ray was traced for this sample");
    buttons(ui);
    const int shown = ui.viewer.player().shown(picked->trace);
    const RayRecord& ray = picked->trace.rays[static_cast<std::size_t>(shown - 1)];
    const std::string text =
        fmt::format("ray {} of {}: {} ray of depth {}, {}", shown, picked->trace.rays.size(), name(ray.kind),
                    ray.depth, meeting(*ui.viewer.document().scene, ray));
    flow(ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextColored(colorOf(ray.kind, ui.dark), "%s", text.c_str());
    if (ImGui::BeginChild("listing")) listing(ui, ray, shown);
    ImGui::EndChild();
}

}
