#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/cli/chart.h"
#include "core/image/encode.h"
#include "core/study/log_fit.h"
#include "core/study/report_page.h"

namespace eyeray {
namespace {

const Axis kDifferences{Scale::Log, 1e-3, 1}; // of linear light as exposed

std::string spreadText(const Spread& spread) {
    return fmt::format("{} ({}–{})", shortNumber(spread.median), shortNumber(spread.least),
                       shortNumber(spread.most));
}

std::string methodAndDepth(const TraceSettings& trace) {
    if (trace.method == Method::Local || trace.method == Method::Cast)
        return fmt::format("{}: no mirrors, no glass", kMethodNames[static_cast<std::size_t>(trace.method)]);
    return fmt::format("{} to depth {}", kMethodNames[static_cast<std::size_t>(trace.method)],
                       trace.maxDepth);
}

class Report {
public:
    explicit Report(const Chart& chart)
        : chart_(chart), page_(fmt::format("Speed against accuracy: {}", chart.scene), summary(chart)) {}

    std::string write() {
        page_.section("Charts");
        page_.paragraph(
            "Left is faster, lower is more accurate; both axes are logarithmic. Whiskers reach from "
            "the least to the most of all runs. Hover over a point for all its measures.");
        for (const Plot& plot : plotsOf(chart_)) page_.figure(svgOf(plot), caption(plot));
        points();
        page_.section("At equal time");
        page_.paragraph("Error to the fullest model by so many seconds, between measured points along a "
                        "power law. The star of a column is the method to take for that time.");
        page_.table(equalTime());
        page_.section("At equal error");
        page_.paragraph(
            "Seconds until the error to the fullest model is so small. A star is the fastest, ≤ a curve that "
            "is there with its first sample, - one that never gets there as far as it was measured.");
        page_.table(equalError());
        references();
        pictures();
        return page_.file();
    }

private:
    const Experiment& experiment() const { return chart_.experiment; }

    static std::string summary(const Chart& chart) {
        return fmt::format(
            "{}x{} pixels, {} threads, median of {} runs with other random numbers. Seconds are "
            "of tracing alone, building the index left out.",
            chart.plan.width, chart.plan.height, chart.threads, chart.plan.repeats);
    }

    std::string caption(const Plot& plot) const {
        if (!plot.guides.empty() && plot.guides.front().slope < 0)
            return "What is left to do by more samples alone. Independent samples fall along the dashed "
                   "line; "
                   "well spread ones fall faster. Slopes are fitted over the number of samples.";
        return "Where a curve turns level, its model is at its end: more samples only make its mistakes "
               "clearer.";
    }

    void points() {
        page_.section("All points");
        ReportTable table{{"setting", "samples", "seconds", "RMSE to its limit", "RMSE to fullest",
                           "relative MSE", "95th percentile", "FLIP", "front"},
                          {}};
        const std::vector<bool> front = chart_.onFront();
        for (std::size_t i = 0; i < experiment().points.size(); ++i) {
            const ExperimentPoint& point = experiment().points[i];
            std::vector<std::string> cells = {experiment().curves[point.curve].label,
                                              fmt::format("{}", point.samples)};
            if (point.repeats.empty()) {
                cells.push_back(fmt::format("failed: {}", point.failure));
                cells.resize(table.head.size());
            } else {
                const auto model = [&](ErrorMetric metric) {
                    return shortNumber(point.error(ErrorAgainst::Fullest, metric).median);
                };
                cells.insert(cells.end(), {spreadText(point.seconds()),
                                           spreadText(point.error(ErrorAgainst::Limit, ErrorMetric::Rmse)),
                                           spreadText(point.error(ErrorAgainst::Fullest, ErrorMetric::Rmse)),
                                           model(ErrorMetric::RelativeMse), model(ErrorMetric::Percentile95),
                                           model(ErrorMetric::Flip), front[i] ? "front" : ""});
            }
            table.rows.push_back({std::move(cells), front[i]});
        }
        page_.table(table);
    }

    struct Measured {
        std::vector<double> seconds, errors;
    };
    Measured measured(std::size_t curve) const {
        Measured result;
        for (const ExperimentPoint& point : experiment().points)
            if (point.curve == curve && !point.repeats.empty()) {
                result.seconds.push_back(point.seconds().median);
                result.errors.push_back(point.error(ErrorAgainst::Fullest, chart_.metric).median);
            }
        return result;
    }

    /// Round numbers within what was measured, few enough for a page.
    std::vector<double> levels(std::vector<double> Measured::* values) const {
        constexpr std::size_t kMost = 8;
        double low = std::numeric_limits<double>::infinity(), high = 0;
        for (std::size_t curve = 0; curve < experiment().curves.size(); ++curve) {
            const Measured points = measured(curve);
            for (const double value : points.*values) {
                if (value > 0) low = std::min(low, value);
                high = std::max(high, value);
            }
        }
        std::vector<double> levels;
        for (double power = std::floor(std::log10(low)); std::pow(10, power) <= high; ++power)
            for (const int mantissa : {1, 2, 5})
                if (const double level = mantissa * std::pow(10, power); level >= low && level <= high)
                    levels.push_back(level);
        while (levels.size() > kMost)
            for (std::size_t i = 1; i < levels.size(); ++i)
                levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(i));
        return levels;
    }

    struct Reading {
        double value = std::numeric_limits<double>::infinity();
        std::string text = "-";
    };
    using Read = Reading (*)(const Measured&, double level);

    static Reading errorBy(const Measured& curve, double seconds) {
        const auto error = interpolated(curve.seconds, curve.errors, seconds);
        return error ? Reading{*error, shortNumber(*error)} : Reading{};
    }

    /// A curve that begins below the level has been there even before its first point.
    static Reading secondsTo(const Measured& curve, double error) {
        if (!curve.errors.empty() && curve.errors.front() < error)
            return {curve.seconds.front(), fmt::format("≤ {}", shortNumber(curve.seconds.front()))};
        const auto seconds = firstReach(curve.seconds, curve.errors, error);
        return seconds ? Reading{*seconds, shortNumber(*seconds)} : Reading{};
    }

    /// A row for each curve, a column for each level; the least of a column has a star.
    ReportTable table(const std::vector<double>& levels, const char* unit, Read read) const {
        ReportTable table{{"setting"}, {}};
        for (std::size_t curve = 0; curve < experiment().curves.size(); ++curve)
            table.rows.push_back({{experiment().curves[curve].label}});
        for (const double level : levels) {
            table.head.push_back(fmt::format("{}{}", shortNumber(level, 1), unit));
            std::vector<Reading> column;
            column.reserve(table.rows.size());
            for (std::size_t curve = 0; curve < table.rows.size(); ++curve)
                column.push_back(read(measured(curve), level));
            const double best = std::ranges::min(column, {}, &Reading::value).value;
            for (std::size_t curve = 0; curve < table.rows.size(); ++curve)
                table.rows[curve].cells.push_back(
                    column[curve].text + (std::isfinite(best) && column[curve].value == best ? " ★" : ""));
        }
        return table;
    }

    ReportTable equalTime() const { return table(levels(&Measured::seconds), " s", errorBy); }
    ReportTable equalError() const { return table(levels(&Measured::errors), "", secondsTo); }

    void references() {
        page_.section("References");
        page_.paragraph(
            "A reference is the mean of two halves traced with other random numbers; half of what "
            "they differ by is its own error. No point can be told to be better than that.");
        ReportTable table{{"reference for", "samples", "its own RMSE", "slope of the error over samples"},
                          {}};
        const auto row = [](const std::string& name, const Reference& reference, const std::string& slope) {
            return ReportTable::Row{
                {name, fmt::format("{}", reference.samples), shortNumber(reference.error), slope}};
        };
        table.rows.push_back(
            row("the fullest model: path to depth 64, nothing cut off", experiment().fullest, "-"));
        for (std::size_t i = 0; i < experiment().curves.size(); ++i) {
            const ExperimentCurve& curve = experiment().curves[i];
            if (curve.limit.picture.empty()) continue;
            const auto slope = samplingSlope(experiment(), i, chart_.metric);
            table.rows.push_back(row(fmt::format("{} ({})", curve.label, methodAndDepth(curve.setting.trace)),
                                     curve.limit, slope ? fmt::format("{:.2f}", *slope) : "-"));
        }
        page_.table(table);
    }

    std::vector<std::byte> png(const ByteImage& image) const {
        return encodeDisplayed(image, ImageFormat::Png, {});
    }

    void pictures() {
        page_.section("Pictures");
        const int most = chart_.plan.grid.samples.back();
        page_.paragraph(fmt::format("Each setting with {} samples, and where it differs: from its own limit "
                                    "(noise), and from the fullest model (noise, and what the model leaves "
                                    "out).",
                                    most));
        page_.figure(svgOfHeat(kDifferences, "largest difference of a channel, of linear light as exposed"),
                     "Colours of the difference pictures, the same in all of them.");
        const ColorImage& fullest = experiment().fullest.picture;
        std::vector<ReportPicture> all = {
            {png(display(fullest, experiment().display)), "The fullest model",
             fmt::format("path to depth 64, {} samples", experiment().fullest.samples)}};
        page_.pictures(all);
        for (const ExperimentCurve& curve : experiment().curves)
            if (!curve.picture.empty()) page_.pictures(picturesOf(curve));
    }

    std::vector<ReportPicture> picturesOf(const ExperimentCurve& curve) const {
        const auto difference = [&](const ColorImage& reference) {
            return png(
                differencePicture(reference, curve.picture, experiment().display.exposure, kDifferences));
        };
        return {{png(display(curve.picture, experiment().display)), curve.label,
                 methodAndDepth(curve.setting.trace)},
                {difference(curve.limit.picture), curve.label, "from its own limit"},
                {difference(experiment().fullest.picture), curve.label, "from the fullest model"}};
    }

    const Chart& chart_;
    ReportPage page_;
};

}

std::string reportOf(const Chart& chart) { return Report(chart).write(); }

}
