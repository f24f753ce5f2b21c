#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

struct Step {
    const char *label, *command, *help, *gridHelp;
};
constexpr std::array kSteps = {
    Step{"|<", "play to=start", "the eye ray alone", "no pixel"},
    Step{"<", "play to=back", "one ray back", "one pixel back"},
    Step{">", "play to=next", "the next ray", "the next pixel"},
    Step{"> hit", "play to=hit", "the next ray that hits something",
         "the next pixel whose rays hit something"},
    Step{"> lamp", "play to=light", "the next ray to a lamp", "the next pixel with a ray to a lamp"},
    Step{">|", "play to=end", "all rays", "all pixels"}};
constexpr float kSlowest = 0.1F, kFastest = 20;

void buttons(const Widgets& ui) {
    const bool onGrid = ui.viewer.gridPlayer().on();
    if (ImGui::Button(ui.viewer.playing() ? "Stop" : "Play")) ui.execute({"play", {}}, {});
    ui.mark("play");
    ui.tooltip(onGrid ? "traces the pixels of a coarse picture one after the other"
                      : "traces the rays of the pixel one after the other");
    for (const Step& step : kSteps) {
        ImGui::SameLine();
        if (ImGui::Button(step.label)) ui.execute(Command::parse(step.command), {});
        ui.mark(step.command);
        ui.tooltip(onGrid ? step.gridHelp : step.help);
    }
    bool grid = onGrid;
    flow(ImGui::CalcTextSize("Pixel by pixel").x + 2 * ImGui::GetFrameHeight());
    if (ImGui::Checkbox("Pixel by pixel", &grid)) ui.execute({"play-grid", {{"on", toText(grid)}}}, {});
    ui.mark("play-grid");
    ui.tooltip("a coarse picture fills on the image plane while the rays of its pixels are traced");
    auto speed = static_cast<float>(ui.viewer.gridPlayer().speed());
    const float width = 7 * ImGui::GetFontSize();
    flow(width);
    ImGui::SetNextItemWidth(width);
    if (ImGui::SliderFloat("##speed", &speed, kSlowest, kFastest, "speed %.2g",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
        ui.execute({"play", {{"speed", fmt::format("{}", speed)}}}, {});
    ui.mark("play speed");
    ui.tooltip("how fast it plays by itself");
}

/// The lines that the rays go through stand out, and come into sight when they are others: `step` is then
/// another.
void listing(const Widgets& ui, std::span<const RayRecord> rays, int step) {
    int* const last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("listed"), 0);
    const bool moved = *last != step;
    *last = step;
    const Method method = ui.viewer.document().render.trace.method;
    std::map<std::size_t, RayKind> marked;
    for (const RayRecord& ray : rays)
        for (const std::size_t line : linesOf(method, ray)) marked.emplace(line, ray.kind);
    const auto code = pseudoCode(method);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string line(code[i]);
        const auto mark = marked.find(i);
        if (mark == marked.end()) {
            dimmedText(line);
            continue;
        }
        ImVec4 band = colorOf(mark->second, ui.dark);
        band.w = 0.35F;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(
            at, {at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetTextLineHeight() + 1},
            ImGui::GetColorU32(band), 3 * ui.scale);
        ImGui::TextUnformatted(line.c_str());
        if (moved) ImGui::SetScrollHereY();
    }
    ImGui::PopStyleVar();
}

std::string gridText(const GridPlayer& player) {
    const PixelGrid& grid = player.grid();
    const auto cell = player.current();
    if (!cell) return fmt::format("a picture of {} x {} pixels, still empty", grid.columns, grid.rows);
    return fmt::format("pixel {} of {} (column {}, row {}): {} rays; so far {} eye rays, {} rays in all",
                       *cell + 1, grid.cells(), grid.column(*cell) + 1, grid.row(*cell) + 1,
                       player.traced().empty() ? 0 : player.traced().back().rays, player.traced().size(),
                       countText(player.rays()));
}

}

void playView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    const GridPlayer& player = ui.viewer.gridPlayer();
    buttons(ui);
    if (player.on()) {
        ImGui::TextWrapped("%s", gridText(player).c_str());
        if (picked && ImGui::BeginChild("listing"))
            listing(ui, picked->trace.rays, static_cast<int>(player.traced().size()));
        if (picked) ImGui::EndChild();
        return;
    }
    if (!picked) return dimmedText("click the picture, then play how its pixel is traced");
    if (picked->trace.rays.empty()) return dimmedText("no ray was traced for this sample");
    const int shown = ui.viewer.player().shown(picked->trace);
    const RayRecord& ray = picked->trace.rays[static_cast<std::size_t>(shown - 1)];
    const std::string text =
        fmt::format("ray {} of {}: {} ray of depth {}, {}", shown, picked->trace.rays.size(), name(ray.kind),
                    ray.depth, meeting(*ui.viewer.document().scene, ray));
    flow(ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextColored(colorOf(ray.kind, ui.dark), "%s", text.c_str());
    if (ImGui::BeginChild("listing")) listing(ui, {&ray, 1}, shown);
    ImGui::EndChild();
}

}
