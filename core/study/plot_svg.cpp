#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/study/label_layout.h"
#include "core/study/palette.h"
#include "core/study/plot.h"
#include "core/study/svg.h"

namespace eyeray {
namespace {

// In letters.
constexpr float kMargin = 1, kLeft = 5.2F, kBottom = 3.4F, kHead = 1.9F;
constexpr float kLegendGap = 1.8F, kSwatch = 1.8F;
constexpr float kLetterWidth = 0.6F; // about what DejaVu Sans takes in the mean
constexpr float kMark = 0.32F, kLabel = 0.8F;
constexpr float kGuideLabel = 0.9F;        // of a guide's length
constexpr float kXTick = 6, kYTick = 2.6F; // room of a label

constexpr std::uint32_t kFaintOnDark = 0x272b34; // lines between the marks of an axis

float widthOf(std::string_view text, float letter) {
    const auto letters = std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });
    return static_cast<float>(letters) * kLetterWidth * letter;
}

class PlotDrawing {
public:
    PlotDrawing(const Plot& plot, const PlotSize& size)
        : plot_(plot), size_(size), letter_(size.letter), svg_(size.width, size.height, ground_.panel) {}

    std::string draw() {
        twin();
        const float top = legend(heading());
        frame_ = {plot_.x,
                  plot_.y,
                  {kLeft * letter_, top},
                  {size_.width - (kLeft + kMargin) * letter_, size_.height - top - kBottom * letter_}};
        axes();
        for (const PlotGuide& guide : plot_.guides) drawGuide(guide);
        for (const PlotSeries& series : plot_.series) drawLine(series);
        for (const PlotSeries& series : plot_.series)
            for (const PlotPoint& point : series.points) drawPoint(series, point);
        labels();
        return svg_.file();
    }

private:
    void twin() {
        const Ground& dark = groundOf(true);
        std::vector<std::array<std::uint32_t, 2>> twins = {{ground_.panel, dark.panel},
                                                           {ground_.text, dark.text},
                                                           {ground_.dimmed, dark.dimmed},
                                                           {ground_.paper, kFaintOnDark},
                                                           {ground_.border, dark.border}};
        for (int i = 0; i < static_cast<int>(kSeriesColors); ++i)
            twins.push_back({colorOfSeries(i, false), colorOfSeries(i, true)});
        svg_.twinColors(twins);
    }

    /// Returns where it ends.
    float heading() {
        if (plot_.title.empty()) return kMargin * letter_;
        svg_.text({kMargin * letter_, (kMargin + 0.9F) * letter_}, plot_.title,
                  {.size = 1.15F * letter_, .color = ground_.text, .bold = true});
        return (kMargin + kHead) * letter_;
    }

    /// In as many rows as its names need. Returns where it ends.
    float legend(float top) {
        float x = kMargin, y = top / letter_ + 0.8F;
        bool any = false;
        for (const PlotSeries& series : plot_.series) {
            if (series.name.empty()) continue;
            const float width = kSwatch + 0.5F + widthOf(series.name, 0.9F) + kLegendGap;
            if (any && (x + width) * letter_ > size_.width) {
                x = kMargin;
                y += 1.4F;
            }
            any = true;
            const Vec2 from = Vec2(x, y - 0.3F) * letter_, to = from + Vec2(kSwatch, 0) * letter_;
            stroke(series, std::array{from, to});
            mark(series, (from + to) * 0.5F, true);
            svg_.text(Vec2(x + kSwatch + 0.5F, y) * letter_, series.name,
                      {.size = 0.9F * letter_, .color = ground_.text});
            x += width;
        }
        return any ? (y + 1) * letter_ : top;
    }

    void axes() {
        const Vec2 low = frame_.corner, high = low + frame_.size;
        const int most = static_cast<int>(frame_.size.x / (kXTick * letter_));
        for (const Tick& tick : ticksOf(plot_.x, most)) {
            const float x = low.x + static_cast<float>(plot_.x.share(tick.value)) * frame_.size.x;
            gridLine({x, low.y}, {x, high.y}, !tick.label.empty());
            svg_.text({x, high.y + 1.2F * letter_}, tick.label,
                      {.size = kLabel * letter_, .color = ground_.dimmed, .anchor = Svg::Anchor::Middle});
        }
        for (const Tick& tick : ticksOf(plot_.y, static_cast<int>(frame_.size.y / (kYTick * letter_)))) {
            const float y = high.y - static_cast<float>(plot_.y.share(tick.value)) * frame_.size.y;
            gridLine({low.x, y}, {high.x, y}, !tick.label.empty());
            svg_.text({low.x - 0.5F * letter_, y + 0.3F * letter_}, tick.label,
                      {.size = kLabel * letter_, .color = ground_.dimmed, .anchor = Svg::Anchor::End});
        }
        svg_.line(std::array{low, Vec2(low.x, high.y), high}, {ground_.dimmed, 0.08F * letter_, {}});
        svg_.text({(low.x + high.x) / 2, high.y + 2.7F * letter_}, plot_.xTitle,
                  {.size = 0.95F * letter_, .color = ground_.text, .anchor = Svg::Anchor::Middle});
        svg_.text(
            {1.4F * letter_, (low.y + high.y) / 2}, plot_.yTitle,
            {.size = 0.95F * letter_, .color = ground_.text, .anchor = Svg::Anchor::Middle, .upward = true});
    }

    void gridLine(const Vec2& from, const Vec2& to, bool major) {
        svg_.line(std::array{from, to}, {major ? ground_.border : ground_.paper, 0.05F * letter_, {}});
    }

    void drawGuide(const PlotGuide& guide) {
        const auto ends = frame_.line(guide);
        if (ends[0] == ends[1]) return;
        const std::array dashes = {0.5F * letter_, 0.35F * letter_};
        svg_.line(ends, {ground_.dimmed, 0.09F * letter_, dashes});
    }

    void stroke(const PlotSeries& series, std::span<const Vec2> points) {
        const std::array dashes = {0.4F * letter_, 0.3F * letter_};
        const std::uint32_t color = colorOfSeries(series.color, false);
        if (series.line == PlotLine::Full) svg_.line(points, {color, 0.12F * letter_, {}});
        if (series.line == PlotLine::Dashed) svg_.line(points, {color, 0.12F * letter_, dashes});
        if (series.line == PlotLine::Broad) svg_.line(points, {color, 0.7F * letter_, {}, 0.25F});
    }

    void drawLine(const PlotSeries& series) {
        std::vector<Vec2> line;
        line.reserve(series.points.size());
        for (const PlotPoint& point : series.points) line.push_back(frame_.place(point.x, point.y).at);
        if (line.size() > 1) stroke(series, line);
    }

    void drawPoint(const PlotSeries& series, const PlotPoint& point) {
        const PlotFrame::Place place = frame_.place(point.x, point.y);
        const auto range = [&](const Vec2& from, const Vec2& to) {
            svg_.line(std::array{from, to}, {colorOfSeries(series.color, false), 0.08F * letter_, {}, 0.7F});
        };
        const auto draw = [&] {
            if (point.xRange)
                range(frame_.place(point.xRange->front(), point.y).at,
                      frame_.place(point.xRange->back(), point.y).at);
            if (point.yRange)
                range(frame_.place(point.x, point.yRange->front()).at,
                      frame_.place(point.x, point.yRange->back()).at);
            mark(series, place.at, place.onAxes);
        };
        if (point.hover.empty())
            draw();
        else
            svg_.described(point.hover, draw);
    }

    /// Hollow where the axes do not reach it.
    void mark(const PlotSeries& series, const Vec2& at, bool onAxes) {
        const float r = kMark * letter_;
        const std::uint32_t color = colorOfSeries(series.color, false);
        const Svg::Stroke edge{color, 0.12F * letter_, {}};
        const auto shape = [&](std::span<const Vec2> corners) {
            std::vector<Vec2> points;
            for (const Vec2& corner : corners) points.push_back(at + corner * r);
            svg_.polygon(points, onAxes ? color : ground_.panel, 1);
            points.push_back(points.front());
            svg_.line(points, edge);
        };
        switch (series.mark) {
        case PlotMark::None:
            return;
        case PlotMark::Disc:
            svg_.box(at - r, Vec2(2 * r), r, onAxes ? color : ground_.panel, edge);
            return;
        case PlotMark::Square:
            shape(std::array{Vec2(-0.9F, -0.9F), Vec2(0.9F, -0.9F), Vec2(0.9F, 0.9F), Vec2(-0.9F, 0.9F)});
            return;
        case PlotMark::Triangle:
            shape(std::array{Vec2(0, -1.2F), Vec2(1.1F, 0.8F), Vec2(-1.1F, 0.8F)});
            return;
        case PlotMark::Diamond:
            shape(std::array{Vec2(0, -1.3F), Vec2(1.1F, 0), Vec2(0, 1.3F), Vec2(-1.1F, 0)});
            return;
        case PlotMark::Cross:
            svg_.line(std::array{at - r, at + r}, edge);
            svg_.line(std::array{at + Vec2(-r, r), at + Vec2(r, -r)}, edge);
            return;
        }
    }

    /// Those of guides first, for they have no other place.
    void labels() {
        std::vector<LabelledPoint> points;
        std::vector<const std::string*> texts;
        const auto add = [&](const Vec2& at, const std::string& text) {
            points.push_back({at, {widthOf(text, kLabel * letter_), 1.15F * kLabel * letter_}});
            texts.push_back(&text);
        };
        for (const PlotGuide& guide : plot_.guides) {
            const auto ends = frame_.line(guide);
            if (ends[0] != ends[1]) add(glm::mix(ends[0], ends[1], kGuideLabel), guide.label);
        }
        for (const PlotSeries& series : plot_.series)
            if (series.mark != PlotMark::None)
                for (const PlotPoint& point : series.points)
                    add(frame_.place(point.x, point.y).at, point.label);
        const auto corners = layOutLabels(points, frame_.corner, frame_.size, 1.4F * kMark * letter_);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (corners[i]) drawLabel(points[i], *corners[i], *texts[i]);
    }

    /// With a thin line to its point where it stands away from it.
    void drawLabel(const LabelledPoint& point, const Vec2& corner, const std::string& text) {
        const Vec2 near = glm::clamp(point.at, corner, corner + point.extent);
        if (glm::length(near - point.at) > 2.2F * kMark * letter_)
            svg_.line(std::array{point.at, near}, {ground_.dimmed, 0.05F * letter_, {}});
        svg_.text(corner + Vec2(point.extent.x / 2, 0.8F * point.extent.y), text,
                  {.size = kLabel * letter_,
                   .color = ground_.text,
                   .anchor = Svg::Anchor::Middle,
                   .halo = ground_.panel});
    }

    const Plot& plot_;
    const PlotSize size_;
    const float letter_;
    const Ground& ground_ = groundOf(false);
    Svg svg_;
    PlotFrame frame_;
};

}

std::string svgOf(const Plot& plot, const PlotSize& size) { return PlotDrawing(plot, size).draw(); }

std::string svgOf(std::span<const Plot> plots, const PlotSize& size) {
    const float height = size.height * static_cast<float>(plots.size());
    std::string file =
        fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
                    R"(viewBox="0 0 {0:.0f} {1:.0f}">)"
                    "\n",
                    size.width, height);
    for (std::size_t i = 0; i < plots.size(); ++i)
        file += fmt::format("<g transform=\"translate(0 {:.0f})\">\n{}</g>\n",
                            size.height * static_cast<float>(i), svgOf(plots[i], size));
    return file + "</svg>\n";
}

}
