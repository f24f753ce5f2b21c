#include <algorithm>

#include <fmt/format.h>

#include "app/gui/panels.h"
#include "core/study/photon_text.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr float kLeastRadius = 0.001F; // metres
constexpr float kLeastPerSecond = 1;

/// A slider for a part of `from-light`, with its name before it.
void slider(const Widgets& ui, const char* label, const char* key, double value, float lowest, float highest,
            const char* format, const char* help) {
    auto edited = static_cast<float>(value);
    const float width = 10 * ImGui::GetFontSize();
    flow(ImGui::CalcTextSize(label).x + width + ImGui::GetStyle().ItemSpacing.x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(width);
    const std::string id = fmt::format("##{}", key);
    if (ImGui::SliderFloat(id.c_str(), &edited, lowest, highest, format,
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
        ui.execute({"from-light", {{key, fmt::format("{}", edited)}}}, {});
    ui.mark(fmt::format("from-light {}", key));
    ui.tooltip(help);
}

void controls(const Widgets& ui) {
    const PhotonSettings& settings = ui.viewer.photonSettings();
    const Camera& camera = ui.viewer.document().camera;
    bool on = settings.on;
    if (ImGui::Checkbox("From the light", &on)) ui.execute({"from-light", {{"on", toText(on)}}}, {});
    ui.mark("from-light");
    ui.tooltip("sends photons from the lamps and shows the few that find the eye");
    if (!on) return;
    ImGui::SameLine();
    if (ImGui::Button(ui.viewer.paused() ? "Go on" : "Pause")) ui.execute({"pause", {}}, {});
    ui.mark("pause photons");
    ui.tooltip("holds the photons, and the tracing from the eye with them");
    const auto farthest =
        static_cast<float>(std::max(camera.distance() / 2, 2.0 * static_cast<double>(kLeastRadius)));
    slider(ui, "lens radius", "radius", lensRadius(settings, camera), kLeastRadius, farthest, "%.3f m",
           "of the lens at the eye: twice the radius catches four times the photons");
    slider(ui, "photons a second", "rate", settings.perSecond, kLeastPerSecond,
           static_cast<float>(kMostPhotonsPerSecond),
           settings.perSecond < kMostPhotonsPerSecond ? "%.0f" : "as fast as it can",
           "few to follow each, or as many as this computer can send");
}

void row(const char* name, const std::string& count, const std::string& remark) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(count.c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", remark.c_str());
}

std::string percentText(std::uint64_t part, std::uint64_t whole) {
    const double share = whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
    return fmt::format("{:.1f} %", 100 * share);
}

void counters(const PhotonPicture& picture) {
    const PhotonTally& tally = picture.tally;
    const double seconds = std::max(picture.seconds, 1e-3),
                 each = std::max<double>(1, static_cast<double>(tally.emitted));
    if (!ImGui::BeginTable("photons", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    row("photons emitted", countText(tally.emitted),
        fmt::format("{} a second", countText(static_cast<std::uint64_t>(
                                       std::lround(static_cast<double>(tally.emitted) / seconds)))));
    row("bounces", countText(tally.bounces),
        fmt::format("{:.2f} a photon", static_cast<double>(tally.bounces) / each));
    row("absorbed", countText(tally.absorbed), percentText(tally.absorbed, tally.emitted));
    row("left the scene", countText(tally.escaped), percentText(tally.escaped, tally.emitted));
    row("reached the lens", countText(tally.reached), rarityText(tally.reached, tally.emitted));
    row("and are in the picture", countText(tally.onPicture), rarityText(tally.onPicture, tally.emitted));
    ImGui::EndTable();
}

}

void photonView(const Widgets& ui) {
    controls(ui);
    if (!ui.viewer.photonSettings().on)
        return dimmedText(
            "light goes from the lamps to the eye: watch how little of it arrives, and why rays are "
            "traced the other way");
    const auto& picture = ui.viewer.photons().picture();
    if (!picture) return;
    if (!picture->lamps) return dimmedText("no lamp is on: there are no photons");
    ImGui::TextWrapped("%s", forecastText(picture->tally, picture->pixels, picture->seconds).c_str());
    if (ImGui::BeginChild("counters")) {
        counters(*picture);
        if (picture->replaced)
            dimmedText(
                "A lamp without falloff has no power: in its place stands one with falloff that gives the "
                "middle of the scene the same light.");
        dimmedText(
            fmt::format("The picture is drawn in blocks of {0} x {0} pixels. The sky and glowing materials "
                        "send no photons.",
                        kPhotonBlock));
    }
    ImGui::EndChild();
}

}
