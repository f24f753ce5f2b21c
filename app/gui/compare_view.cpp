#include "app/gui/compare_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/settings.h"
#include "app/gl/imgui_renderer.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr float kGrip = 7; // pixels to each side of the line that take the mouse

float lineAt(const Document& document, ImVec2 corner, ImVec2 size) {
    return std::floor(corner.x + size.x * static_cast<float>(document.comparison.split));
}

/// A line of text on a ground of its own; `right` is its right edge, else its left one.
void label(const Widgets& ui, const std::string& text, ImVec2 at, bool right) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const float pad = 5 * ui.scale;
    const float x = right ? at.x - extent.x - 2 * pad : at.x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({x, at.y}, {x + extent.x + 2 * pad, at.y + extent.y + pad},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.86F), 4 * ui.scale);
    list.AddText({x + pad, at.y + pad / 2}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

/// Whether a setting is that of a fault which is off.
bool idle(std::string_view key, FaultSet faults) {
    return (key == "epsilon" && !faults.has(Fault::GlobalEpsilon)) ||
           (key == "clamp" && !faults.has(Fault::EarlyClamp));
}

double millions(const RayCounts& counts) { return 1e-6 * static_cast<double>(counts.total()); }

std::string countOf(int count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string costText(int samples, double seconds) {
    return fmt::format("{}, {:.2f} s", countOf(samples, "sample"), seconds);
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}

SideNames sideNames(const Document& document) {
    if (document.comparison.isRasterised()) return {"rasterised", "traced"};
    SideNames names;
    const Command set = Command::parse("set " + document.comparison.with);
    const Document other = otherSide(document);
    const auto tell = [](std::string& name, const std::string& key, const Document& side) {
        if (idle(key, side.render.trace.faults)) return;
        name += fmt::format("{}{}={}", name.empty() ? "" : "\n", key, settingNamed(key).get(side));
    };
    for (const auto& [key, value] : set.arguments()) {
        tell(names.other, key, other);
        tell(names.own, key, document);
    }
    return names;
}

std::string changeText(const PictureChange& change) {
    const std::string differing =
        fmt::format("{:.1f} % of pixels differ after", percent(change.changed, change.pixels));
    if (change.samples == change.samplesThere)
        return fmt::format("{} {}", differing, countOf(change.samples, "sample"));
    return fmt::format("{} {:.2f} s on the left, {:.2f} s on the right", differing, change.secondsThere,
                       change.secondsHere);
}

std::vector<std::string> wrongLines(const PictureChange& change) {
    const double light = change.lightHere > 0 ? 100 * (change.lightThere / change.lightHere - 1) : 0;
    const std::string samples = change.samples == change.samplesThere
                                    ? countOf(change.samples, "sample")
                                    : fmt::format("{} | {} samples", change.samplesThere, change.samples);
    return {fmt::format("{} pixels wrong ({:.2f} %), light {:+.1f} %", countText(change.wrong),
                        percent(change.wrong, change.pixels), light),
            fmt::format("{:.2f} s | {:.2f} s, {:.1f} | {:.1f} Mrays, {}", change.secondsThere,
                        change.secondsHere, millions(change.there), millions(change.here), samples)};
}

void CompareView::refresh(const Viewer& viewer) {
    const Document& document = viewer.document();
    const Comparison& comparison = document.comparison;
    if (const RenderSession* const session = viewer.comparison().session())
        other_.refresh(*session, shownDisplay(otherSide(document).render));
    const auto& change = viewer.comparison().change();
    if (comparison.marks && change && change != marked_) {
        marked_ = change;
        marks_.upload(change->marks);
    }
    if (!comparison.difference || !change) return;
    const auto gain = static_cast<float>(comparison.gain);
    const DisplaySettings display = shownDisplay(document.render);
    if (change == change_ && gain == differenceGain_ && display == differenceDisplay_) return;
    change_ = change;
    differenceGain_ = gain;
    differenceDisplay_ = display;
    ColorImage amplified = change->difference;
    for (Color& value : amplified.values()) value *= gain;
    difference_.upload(eyeray::display(amplified, display));
}

void CompareView::handle(const Widgets& ui, ImVec2 corner, ImVec2 size) {
    const Document& document = ui.viewer.document();
    if (document.comparison.difference) return;
    const float grip = kGrip * ui.scale;
    ImGui::SetCursorScreenPos({lineAt(document, corner, size) - grip, corner.y});
    ImGui::InvisibleButton("split line", {2 * grip, size.y});
    ui.mark("split line");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!ImGui::IsItemActive() || ImGui::GetIO().MouseDelta.x == 0) return;
    const float split = std::clamp((ImGui::GetIO().MousePos.x - corner.x) / size.x, 0.0F, 1.0F);
    ui.execute({"compare", {{"split", fmt::format("{:.4f}", split)}}}, {});
}

void CompareView::draw(const Widgets& ui, const GlTexture& raster, ImVec2 corner, ImVec2 size,
                       bool wholly) const {
    const Document& document = ui.viewer.document();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 opposite{corner.x + size.x, corner.y + size.y};
    if (document.comparison.difference && !wholly) {
        if (ui.viewer.comparison().change() && difference_.width() > 0)
            list.AddImage(textureId(difference_), corner, opposite);
        return;
    }
    const GlTexture& other = document.comparison.isRasterised() ? raster : other_.texture();
    if (other.width() == 0) return;
    const float line = wholly ? opposite.x : lineAt(document, corner, size);
    list.AddImage(textureId(other), corner, {line, opposite.y}, {0, 0}, {(line - corner.x) / size.x, 1});
    const bool marked = document.comparison.marks && marked_ == ui.viewer.comparison().change();
    if (marked && marks_.width() > 0)
        list.AddImage(textureId(marks_), corner, {line, opposite.y}, {0, 0}, {(line - corner.x) / size.x, 1});
    if (!wholly) splitLine(ui, corner, size);
}

void CompareView::splitLine(const Widgets& ui, ImVec2 corner, ImVec2 size) const {
    const float x = lineAt(ui.viewer.document(), corner, size), middle = corner.y + size.y / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 black = IM_COL32(0, 0, 0, 255), white = IM_COL32(255, 255, 255, 255);
    list.AddLine({x, corner.y}, {x, corner.y + size.y}, black, 4 * ui.scale);
    list.AddLine({x, corner.y}, {x, corner.y + size.y}, white, 2 * ui.scale);
    list.AddCircleFilled({x, middle}, 9 * ui.scale, black);
    list.AddCircleFilled({x, middle}, 7.5F * ui.scale, white);
    for (const float side : {-1.0F, 1.0F}) {
        const float tip = x + side * 5 * ui.scale, base = x + side * 1.5F * ui.scale, arm = 3.5F * ui.scale;
        list.AddTriangleFilled({tip, middle}, {base, middle - side * arm}, {base, middle + side * arm},
                               black);
    }
    SideNames names = sideNames(ui.viewer.document());
    if (const auto& change = ui.viewer.comparison().change(); change && change->secondsThere > 0) {
        names.other += fmt::format("\n{}", costText(change->samplesThere, change->secondsThere));
        names.own += fmt::format("\n{}", costText(change->samples, change->secondsHere));
    }
    const float margin = 8 * ui.scale;
    label(ui, names.other, {x - margin, corner.y + margin}, true);
    label(ui, names.own, {x + margin, corner.y + margin}, false);
}

void CompareView::legend(const Widgets& ui, const LegendPlace& place) const {
    const Comparison& comparison = ui.viewer.document().comparison;
    const auto& change = ui.viewer.comparison().change();
    if (ui.viewer.document().lab != nullptr && !comparison.difference)
        return legendPane(ui, "lab legend", place, [&] { labLegend(ui); });
    legendPane(ui, "compare legend", place, [&] {
        if (comparison.difference) {
            const SideNames names = sideNames(ui.viewer.document());
            ImGui::Text("difference from %s", names.other.c_str());
            if (comparison.gain != 1) ImGui::Text("%g times", comparison.gain);
        }
        if (!change) return ImGui::TextDisabled("tracing both sides");
        ImGui::TextWrapped("%s", changeText(*change).c_str());
        ImGui::TextWrapped("%s | %s rays", countText(change->there.total()).c_str(),
                           countText(change->here.total()).c_str());
    });
}

/// What the class reads off: how wrong the left side is, what it costs, and why.
void CompareView::labLegend(const Widgets& ui) {
    const auto& change = ui.viewer.comparison().change();
    if (change) {
        const std::vector<std::string> lines = wrongLines(*change);
        ImGui::TextWrapped("%s", lines[0].c_str());
        dimmedText(lines[1]);
    } else {
        ImGui::TextDisabled("tracing both sides");
    }
    ImGui::TextWrapped("%s", std::string(ui.viewer.document().lab->why).c_str());
}

}
