#include "app/viewer/chart_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/document/settings.h"
#include "core/base/errors.h"
#include "core/image/metrics.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostLoose = 8; // curves that are not pinned
constexpr int kSmallWidth = 320;      // of kept pictures, pixels
constexpr double kLeastGrowth = 1.5;  // of samples between two points

/// Every step-th pixel.
ColorImage small(const ColorImage& picture) {
    const int step = std::max(1, picture.width() / kSmallWidth);
    ColorImage fewer(std::max(1, picture.width() / step), std::max(1, picture.height() / step));
    for (int y = 0; y < fewer.height(); ++y)
        for (int x = 0; x < fewer.width(); ++x) fewer.at(x, y) = picture.at(x * step, y * step);
    return fewer;
}

bool sameView(const Document& a, const Document& b) { return a.scene == b.scene && a.camera == b.camera; }

/// A setting that changes what is traced, and is not named anyway.
bool isTold(std::string_view key) {
    constexpr std::array<std::string_view, 9> kUntold = {
        "method", "max-depth", "samples", "seconds", "error", "exposure", "tonemap", "threads", "aspect"};
    return std::ranges::find(kUntold, key) == kUntold.end();
}

}

std::string nameOfSetting(const Document& original, const Document& now) {
    std::string name = fmt::format("{} d{}", kMethodNames[static_cast<std::size_t>(now.render.trace.method)],
                                   now.render.trace.maxDepth);
    for (const Setting& setting : settings())
        if (isTold(setting.key) && setting.get(original) != setting.get(now))
            name += fmt::format(" {}={}", setting.key, setting.get(now));
    return name;
}

void ChartRecording::begin(const Document& original, const Document& now, int width, int height) {
    const bool sameSize = width == width_ && height == height_;
    width_ = width;
    height_ = height;
    last_ = {};
    lastSamples_ = 0;
    std::erase_if(curves_, [&](const RecordedCurve& curve) {
        return !curve.pinned && (curve.points.empty() || !sameSize || !sameView(curve.document, now));
    });
    if (reference_ && (!sameSize || !sameView(reference_->document, now))) reference_.reset();
    const auto loose = [](const RecordedCurve& curve) { return !curve.pinned; };
    if (std::ranges::count_if(curves_, loose) >= static_cast<std::ptrdiff_t>(kMostLoose))
        curves_.erase(std::ranges::find_if(curves_, loose));
    curves_.push_back({nameOfSetting(original, now), freeColor(), false, now, {}});
}

int ChartRecording::freeColor() const {
    constexpr int kColors = static_cast<int>(kSeriesColors);
    const auto uses = [&](int color) {
        return std::ranges::count(curves_, color, [](const RecordedCurve& c) { return c.color % kColors; });
    };
    int best = 0;
    for (int color = 1; color < kColors; ++color)
        if (uses(color) < uses(best)) best = color;
    return best;
}

bool ChartRecording::update(const RenderSession& session) {
    if (!on_ || curves_.empty()) return false;
    const RenderStatus before = session.status();
    const bool due = before.samples >= std::max(1, 2 * lastSamples_) ||
                     (!before.active() && before.samples >= kLeastGrowth * lastSamples_);
    if (!due || before.samples == lastSamples_) return false;
    ColorImage picture = session.image();
    if (session.status().samples != before.samples || picture.width() != width_ ||
        picture.height() != height_)
        return false; // a pass has ended meanwhile: the next frame will do
    ColorImage counts = session.sampleCounts();
    if (lastSamples_ > 0)
        curves_.back().points.push_back(
            {before.samples, before.seconds, estimatedError(picture, counts), small(picture)});
    last_ = std::move(picture);
    lastCounts_ = std::move(counts);
    lastSamples_ = before.samples;
    return true;
}

/// Root mean square over the picture, channels averaged. A pixel that has had no samples since the point
/// before keeps its error.
double ChartRecording::estimatedError(const ColorImage& picture, const ColorImage& counts) {
    squaredErrors_.resize(picture.values().size());
    double sum = 0;
    for (std::size_t i = 0; i < squaredErrors_.size(); ++i) {
        const double a = lastCounts_.values()[i].x, b = counts.values()[i].x;
        const DVec3 step = DVec3(picture.values()[i]) - DVec3(last_.values()[i]);
        if (b > a) squaredErrors_[i] = dot(step, step) / 3 * a / (b - a);
        sum += squaredErrors_[i];
    }
    return std::sqrt(sum / static_cast<double>(squaredErrors_.size()));
}

void ChartRecording::clear() {
    curves_.clear();
    reference_.reset();
    last_ = {};
    lastSamples_ = 0;
}

void ChartRecording::remove(std::size_t curve) {
    if (static_cast<int>(curve) == current())
        curves_.at(curve).points.clear();
    else
        curves_.erase(curves_.begin() + static_cast<std::ptrdiff_t>(curve));
}

void ChartRecording::takeReference(std::size_t curve) {
    const RecordedCurve& taken = curves_.at(curve);
    if (taken.points.empty())
        throw InputError(fmt::format("chart-reference n={}", curve), "this curve has no point yet",
                         "wait a moment");
    const RecordedPoint& last = taken.points.back();
    reference_ = ChartReference{taken.name, last.samples, last.picture, taken.document};
}

std::vector<std::size_t> ChartRecording::drawn() const {
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const RecordedCurve& curve = curves_[i];
        if (curve.points.empty()) continue;
        const ColorImage& picture = curve.points.back().picture;
        const bool comparable = !reference_ || (sameView(curve.document, reference_->document) &&
                                                picture.width() == reference_->picture.width() &&
                                                picture.height() == reference_->picture.height());
        if (comparable) drawn.push_back(i);
    }
    return drawn;
}

double ChartRecording::errorOf(const RecordedPoint& point) const {
    return reference_ ? rmse(point.picture, reference_->picture) : point.error;
}

Plot plotOf(const ChartRecording& recording) {
    const auto& reference = recording.reference();
    Plot plot{.title = {},
              .xTitle = "seconds of tracing",
              .yTitle = reference ? fmt::format("RMSE to {} ×{}", reference->name, reference->samples)
                                  : "estimated error (RMSE of linear light)",
              .x = {},
              .y = {},
              .series = {}};
    for (const std::size_t i : recording.drawn()) {
        const RecordedCurve& curve = recording.curves()[i];
        PlotSeries series{.name = curve.name, .color = curve.color, .points = {}};
        for (const RecordedPoint& point : curve.points) {
            const double error = recording.errorOf(point);
            series.points.push_back({point.seconds,
                                     error,
                                     {},
                                     fmt::format("{}\n{} samples, {} s\nerror {}", curve.name, point.samples,
                                                 shortNumber(point.seconds), shortNumber(error))});
        }
        plot.series.push_back(std::move(series));
    }
    fitAxes(plot, Scale::Log, Scale::Log);
    if (plot.series.empty()) return plot;
    // The latest curve alone has labels: the samples of all are much the same.
    const RecordedCurve& latest = recording.curves()[recording.drawn().back()];
    std::vector<PlotPoint>& points = plot.series.back().points;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].label = fmt::format("×{}", latest.points[i].samples);
    if (const PlotPoint& first = points.front(); first.y > 0)
        plot.guides.push_back({first.x, first.y, -0.5, "slope −½: Monte Carlo"});
    return plot;
}

std::string csvOf(const ChartRecording& recording) {
    std::string text = "curve,samples,seconds,estimated_error,error_to_reference\n";
    const std::vector<std::size_t> drawn = recording.drawn();
    for (std::size_t i = 0; i < recording.curves().size(); ++i) {
        const RecordedCurve& curve = recording.curves()[i];
        const bool compared = recording.reference() && std::ranges::find(drawn, i) != drawn.end();
        for (const RecordedPoint& point : curve.points) {
            std::string name;
            for (const char c : curve.name) name += c == '"' ? std::string("\"\"") : std::string(1, c);
            text += fmt::format("\"{}\",{},{},{},{}\n", name, point.samples, point.seconds, point.error,
                                compared ? fmt::format("{}", recording.errorOf(point)) : "");
        }
    }
    return text;
}

}
