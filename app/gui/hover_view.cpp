#include "app/gui/hover_view.h"

#include <fmt/format.h>

#include "app/gui/legend.h"
#include "app/gui/theme.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr int kRest = 4;                          // times as long as the tracing took
constexpr float kAlpha = 0.93F, kLetters = 0.86F; // of the window's, to cover little of the picture
constexpr float kBeside = 16;                     // pixels from the pointer, at scale 1

void rayCounts(const Widgets& ui, const SampleRecord& record) {
    RayCounts counts;
    for (const RayRecord& ray : record.rays) ++counts[ray.kind];
    bool first = true;
    for (int i = 0; i < kRayKinds; ++i) {
        const auto kind = static_cast<RayKind>(i);
        if (counts[kind] == 0) continue;
        if (!first) ImGui::SameLine();
        first = false;
        ImGui::TextColored(colorOf(kind, ui.dark), "%s",
                           fmt::format("{} {}", counts[kind], name(kind)).c_str());
    }
}

}

std::string metText(const Scene& scene, const RayRecord& ray) {
    std::string text = meeting(scene, ray);
    if (ray.end != RayEnd::Hit) return text;
    const auto material = static_cast<std::size_t>(ray.hit.material);
    if (ray.hit.material >= 0 && material < scene.materials.size() && !scene.materials[material].name.empty())
        text += ", " + scene.materials[material].name;
    return fmt::format("{}, t = {}", text, metresText(ray.t));
}

void HoverView::over(Viewer& viewer, PixelPosition pixel, std::uint64_t version) {
    pending_ = !hovered_ || hovered_->pixel != pixel || version_ != version;
    const auto begin = Clock::now();
    if (!pending_ || begin < rested_) return;
    pending_ = false;
    auto trace = viewer.session().retrace(pixel.x, pixel.y, 0);
    hovered_.reset();
    if (!trace || trace->rays.empty()) return;
    hovered_ = HoveredPixel{pixel, std::move(*trace)};
    version_ = version;
    const auto end = Clock::now();
    rested_ = end + kRest * (end - begin);
}

void HoverView::leave() {
    hovered_.reset();
    pending_ = false;
}

void HoverView::draw(const Widgets& ui, ImVec2 pictureMiddle, const Rgba8& shown,
                     const std::string& layer) const {
    if (!hovered_) return;
    const auto [x, y] = hovered_->pixel;
    const auto film = ui.viewer.session().pixel(x, y);
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const bool left = pointer.x > pictureMiddle.x, above = pointer.y > pictureMiddle.y; // where it stands
    const float beside = kBeside * ui.scale;
    ImGui::SetNextWindowPos({pointer.x + (left ? -beside : beside), pointer.y + (above ? -beside : beside)},
                            ImGuiCond_Always, {left ? 1.0F : 0.0F, above ? 1.0F : 0.0F});
    ImGui::SetNextWindowBgAlpha(kAlpha);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * ui.scale, 6 * ui.scale});
    ImGui::BeginTooltip();
    ImGui::SetWindowFontScale(kLetters);
    swatch(shown, fmt::format("({}, {})  sRGB {} {} {}", x, y, shown.r, shown.g, shown.b));
    if (film) ImGui::TextUnformatted(("linear " + colorText(film->mean)).c_str());
    ImGui::TextUnformatted(metText(*ui.viewer.document().scene, hovered_->trace.rays.front()).c_str());
    rayCounts(ui, hovered_->trace);
    if (!layer.empty()) ImGui::TextUnformatted(layer.c_str());
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

}
