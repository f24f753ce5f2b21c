#include "app/gui/plot_view.h"

#include <algorithm>
#include <array>

#include "app/gui/theme.h"
#include "core/study/label_layout.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

// In letters' heights.
constexpr float kLeft = 4, kRight = 1, kTop = 1.8F, kBottom = 2.6F;
constexpr float kMark = 0.26F, kReach = 0.8F, kSmall = 0.82F;
constexpr float kFarLabel = 1.2F;
constexpr float kXTick = 5, kYTick = 2;
constexpr float kDash = 0.45F, kGap = 0.3F;

ImVec2 of(const Vec2& v) { return {v.x, v.y}; }

class Painter {
public:
    Painter(const Widgets& ui, const Plot& plot, ImVec2 corner, ImVec2 size)
        : plot_(plot), dark_(ui.dark), letter_(ImGui::GetFontSize()), corner_(corner.x, corner.y),
          list_(*ImGui::GetWindowDrawList()), frame_(frameOf(plot, corner, size)) {}

    std::optional<PlotPlace> draw() {
        axes();
        for (const PlotGuide& guide : plot_.guides) drawGuide(guide);
        const auto hovered = underPointer();
        for (std::size_t s = 0; s < plot_.series.size(); ++s) drawSeries(s, hovered);
        labels();
        return hovered;
    }

private:
    ImU32 ground(std::uint32_t hex, float alpha = 1) const { return ImGui::GetColorU32(fromHex(hex, alpha)); }
    ImU32 colorOf(const PlotSeries& series) const { return ground(colorOfSeries(series.color, dark_)); }
    Vec2 placeOf(const PlotPoint& point) const { return frame_.place(point.x, point.y).at; }

    void text(const Vec2& at, const Vec2& anchor, const std::string& words, ImU32 color) {
        const float height = kSmall * letter_;
        const ImVec2 extent =
            ImGui::GetFont()->CalcTextSizeA(height, 1e9F, 0, words.c_str(), words.c_str() + words.size());
        list_.AddText(ImGui::GetFont(), height, of(glm::round(at - anchor * Vec2(extent.x, extent.y))), color,
                      words.c_str());
    }

    void axes() {
        const Vec2 low = frame_.corner, high = low + frame_.size;
        const ImU32 faint = ground(groundOf(dark_).border, 0.45F), line = ground(groundOf(dark_).border),
                    dimmed = ground(groundOf(dark_).dimmed), words = ground(groundOf(dark_).text);
        for (const Tick& tick : ticksOf(plot_.x, static_cast<int>(frame_.size.x / (kXTick * letter_)))) {
            const float x = low.x + static_cast<float>(plot_.x.share(tick.value)) * frame_.size.x;
            list_.AddLine({x, low.y}, {x, high.y}, tick.label.empty() ? faint : line);
            text({x, high.y + 0.15F * letter_}, {0.5F, 0}, tick.label, dimmed);
        }
        for (const Tick& tick : ticksOf(plot_.y, static_cast<int>(frame_.size.y / (kYTick * letter_)))) {
            const float y = high.y - static_cast<float>(plot_.y.share(tick.value)) * frame_.size.y;
            list_.AddLine({low.x, y}, {high.x, y}, tick.label.empty() ? faint : line);
            text({low.x - 0.4F * letter_, y}, {1, 0.5F}, tick.label, dimmed);
        }
        list_.AddRect(of(low), of(high), dimmed);
        text({(low.x + high.x) / 2, high.y + 1.15F * letter_}, {0.5F, 0}, plot_.xTitle, words);
        text(corner_ + Vec2(0.6F, 0.5F) * letter_, {0, 0}, plot_.yTitle, words);
    }

    void drawGuide(const PlotGuide& guide) {
        const auto ends = frame_.line(guide);
        const float length = glm::distance(ends[0], ends[1]), step = (kDash + kGap) * letter_;
        const ImU32 color = ground(groundOf(dark_).dimmed);
        for (int i = 0; static_cast<float>(i) * step < length; ++i) {
            const float from = static_cast<float>(i) * step;
            const float to = std::min(length, from + kDash * letter_);
            list_.AddLine(of(glm::mix(ends[0], ends[1], from / length)),
                          of(glm::mix(ends[0], ends[1], to / length)), color, 0.08F * letter_);
        }
    }

    void drawSeries(std::size_t index, const std::optional<PlotPlace>& hovered) {
        const PlotSeries& series = plot_.series[index];
        const ImU32 color = colorOf(series);
        std::vector<ImVec2> line;
        line.reserve(series.points.size());
        for (const PlotPoint& point : series.points) line.push_back(of(placeOf(point)));
        list_.AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, 0.12F * letter_);
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool here = hovered == PlotPlace{index, i};
            list_.AddCircleFilled(line[i], (here ? 1.7F : 1) * kMark * letter_, color);
            if (here)
                list_.AddCircle(line[i], 2.2F * kMark * letter_, ground(groundOf(dark_).text), 0,
                                0.1F * letter_);
        }
    }

    void labels() {
        std::vector<LabelledPoint> points;
        std::vector<const std::string*> texts;
        const auto add = [&](const Vec2& at, const std::string& words) {
            const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(kSmall * letter_, 1e9F, 0, words.c_str());
            points.push_back({at, {extent.x, extent.y}});
            texts.push_back(&words);
        };
        for (const PlotGuide& guide : plot_.guides) {
            const auto ends = frame_.line(guide);
            if (ends[0] != ends[1]) add(glm::mix(ends[0], ends[1], 0.85F), guide.label);
        }
        for (const PlotSeries& series : plot_.series)
            for (const PlotPoint& point : series.points) add(placeOf(point), point.label);
        const auto corners = layOutLabels(points, frame_.corner, frame_.size, 1.3F * kMark * letter_);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (corners[i] && isNear(points[i], *corners[i]))
                text(*corners[i], {0, 0}, *texts[i], ground(groundOf(dark_).text));
    }

    /// One far from its point would be taken for another's.
    bool isNear(const LabelledPoint& point, const Vec2& corner) const {
        const Vec2 edge = glm::clamp(point.at, corner, corner + point.extent);
        return glm::distance(edge, point.at) < kFarLabel * letter_;
    }

    std::optional<PlotPlace> underPointer() const {
        if (!ImGui::IsWindowHovered()) return std::nullopt;
        const Vec2 pointer(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
        std::optional<PlotPlace> nearest;
        float best = kReach * letter_;
        for (std::size_t s = 0; s < plot_.series.size(); ++s)
            for (std::size_t i = 0; i < plot_.series[s].points.size(); ++i) {
                const float distance = glm::distance(pointer, placeOf(plot_.series[s].points[i]));
                if (distance >= best) continue;
                best = distance;
                nearest = PlotPlace{s, i};
            }
        return nearest;
    }

    const Plot& plot_;
    const bool dark_;
    const float letter_;
    const Vec2 corner_;
    ImDrawList& list_;
    const PlotFrame frame_;
};

}

PlotFrame frameOf(const Plot& plot, ImVec2 corner, ImVec2 size) {
    const float letter = ImGui::GetFontSize();
    return {plot.x,
            plot.y,
            {corner.x + kLeft * letter, corner.y + kTop * letter},
            {std::max(letter, size.x - (kLeft + kRight) * letter),
             std::max(letter, size.y - (kTop + kBottom) * letter)}};
}

std::optional<PlotPlace> drawPlot(const Widgets& ui, const Plot& plot, ImVec2 corner, ImVec2 size) {
    return Painter(ui, plot, corner, size).draw();
}

}
