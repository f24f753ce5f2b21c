#include "app/gui/chart_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/gl/imgui_renderer.h"
#include "app/gui/plot_view.h"
#include "app/gui/theme.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr float kNameWidth = 22;    // at most, in letters' heights
constexpr float kPictureWidth = 15; // of the picture beside the pointer, in letters' heights
constexpr std::size_t kNameBytes = 64;

using Arguments = std::vector<Command::Argument>;

void controls(const Widgets& ui) {
    bool on = ui.viewer.recording().on();
    if (ImGui::Checkbox("Record", &on)) ui.execute({"chart", {{"on", toText(on)}}}, {});
    ui.mark("chart");
    ui.tooltip(
        "takes a point whenever the number of samples has doubled; each change of settings begins a curve");
    ImGui::SameLine();
    if (ImGui::Button("Save SVG")) ui.execute({"chart-save", {{"format", "svg"}}}, {});
    ui.mark("chart svg");
    ImGui::SameLine();
    if (ImGui::Button("Save CSV")) ui.execute({"chart-save", {{"format", "csv"}}}, {});
    ui.mark("chart csv");
}

/// A button of the curve's colour; a click gives it the next.
void colorButton(const Widgets& ui, const RecordedCurve& curve, const std::string& n) {
    const ImVec4 color = fromHex(colorOfSeries(curve.color, ui.dark));
    if (ImGui::ColorButton("##color", color, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop))
        ui.execute(
            {"curve",
             {{"n", n}, {"color", fmt::format("{}", (curve.color + 1) % static_cast<int>(kSeriesColors))}}},
            {});
    ui.mark("curve color " + n);
    ui.tooltip("another colour");
}

void nameField(const Widgets& ui, const RecordedCurve& curve, const std::string& n, float width) {
    std::array<char, kNameBytes> name{};
    curve.name.copy(name.data(), name.size() - 1);
    ImGui::SetNextItemWidth(width);
    if (ImGui::InputText("##name", name.data(), name.size(), ImGuiInputTextFlags_EnterReturnsTrue))
        ui.execute({"curve", {{"n", n}, {"name", name.data()}}}, {});
    ui.mark("curve name " + n);
}

bool isReference(const ChartRecording& recording, const RecordedCurve& curve) {
    const auto& reference = recording.reference();
    return reference && !curve.points.empty() && reference->picture == curve.points.back().picture;
}

void row(const Widgets& ui, const RecordedCurve& curve, const std::string& n, float nameWidth) {
    ImGui::PushID(n.c_str());
    colorButton(ui, curve, n);
    ImGui::SameLine();
    nameField(ui, curve, n, nameWidth);
    ImGui::SameLine();
    bool pinned = curve.pinned;
    if (ImGui::Checkbox("pin", &pinned)) ui.execute({"curve", {{"n", n}, {"pin", toText(pinned)}}}, {});
    ui.mark("curve pin " + n);
    ui.tooltip("keeps the curve when the view changes");
    ImGui::SameLine();
    bool right = isReference(ui.viewer.recording(), curve);
    if (ImGui::Checkbox("right", &right))
        ui.execute({"chart-reference", right ? Arguments{{"n", n}} : Arguments{}}, {});
    ui.mark("curve right " + n);
    ui.tooltip("takes its latest picture as right, and measures all errors against it");
    ImGui::SameLine();
    if (ImGui::Button("×")) ui.execute({"curve-remove", {{"n", n}}}, {});
    ui.mark("curve remove " + n);
    ui.tooltip("takes the curve away");
    ImGui::PopID();
}

}

void ChartView::plot(const Widgets& ui) {
    const ChartRecording& recording = ui.viewer.recording();
    const std::vector<RecordedCurve>& curves = recording.curves();
    const std::vector<std::size_t> drawn = recording.drawn(); // the series of the plot
    if (drawn.empty())
        return dimmedText(recording.on()
                              ? "waiting for the second sample of each pixel"
                              : "Record draws here how the error of the picture falls with time. Then change "
                                "the method or the depth, and compare");
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
    const auto hovered = drawPlot(ui, plotOf(recording), corner, size);
    ImGui::Dummy(size);
    ui.mark("chart plot");
    if (!hovered) return;
    const std::size_t curve = drawn[hovered->series];
    tell(ui, curves[curve], curves[curve].points[hovered->point]);
    if (ImGui::IsMouseClicked(0)) ui.execute({"curve-return", {{"n", fmt::format("{}", curve)}}}, {});
}

/// Beside the pointer: the picture as it was at this point.
void ChartView::tell(const Widgets& ui, const RecordedCurve& curve, const RecordedPoint& point) {
    const ByteImage picture = display(point.picture, shownDisplay(ui.viewer.document().render));
    if (!(shown_ == picture)) {
        shown_ = picture;
        picture_.upload(shown_);
    }
    const float width = kPictureWidth * ImGui::GetFontSize();
    const float height = width * static_cast<float>(shown_.height()) / static_cast<float>(shown_.width());
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(curve.name.c_str());
    ImGui::Text("%d samples, %s s, error %s", point.samples, shortNumber(point.seconds).c_str(),
                shortNumber(ui.viewer.recording().errorOf(point)).c_str());
    ImGui::Image(textureId(picture_), {width, height});
    ImGui::TextDisabled("click: back to these settings");
    ImGui::EndTooltip();
}

void ChartView::list(const Widgets& ui) const {
    controls(ui);
    if (!ImGui::BeginChild("curves")) return ImGui::EndChild();
    const std::vector<RecordedCurve> curves = ui.viewer.recording().curves(); // commands change them
    const float letter = ImGui::GetFontSize();
    const float width =
        std::clamp(ImGui::GetContentRegionAvail().x - 14 * letter, 4 * letter, kNameWidth * letter);
    for (std::size_t i = curves.size(); i-- > 0;)
        if (!curves[i].points.empty()) row(ui, curves[i], fmt::format("{}", i), width);
    ImGui::EndChild();
}

}
