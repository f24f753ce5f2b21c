#include <fmt/format.h>

#include <algorithm>

#include "app/cli/chart.h"
#include "core/study/pareto.h"

namespace eyeray {
namespace {

std::string rangeText(const Spread& spread) {
    return fmt::format("{} ({} to {})", shortNumber(spread.median), shortNumber(spread.least),
                       shortNumber(spread.most));
}

std::string hoverText(const Chart& chart, const ExperimentPoint& point) {
    if (point.repeats.empty()) return fmt::format("{}\n{}", chart.pointName(point), point.failure);
    std::string text = fmt::format("{}\nseconds {}", chart.pointName(point), rangeText(point.seconds()));
    for (const ErrorAgainst against : {ErrorAgainst::Limit, ErrorAgainst::Fullest}) {
        text += against == ErrorAgainst::Limit ? "\nto its own limit:" : "\nto the fullest model:";
        for (std::size_t metric = 0; metric < kErrorMetrics; ++metric)
            text += fmt::format("\n  {} {}", kErrorMetricNames[metric],
                                rangeText(point.error(against, static_cast<ErrorMetric>(metric))));
    }
    return text;
}

class Plotting {
public:
    Plotting(const Chart& chart, ErrorAgainst against) : chart_(chart), against_(against) {}

    Plot plot() {
        const auto& plan = chart_.plan;
        const bool limit = against_ == ErrorAgainst::Limit;
        Plot plot{.title = limit ? "Error of sampling: against each method's own limit"
                                 : "Error of model and sampling: against the fullest model",
                  .xTitle = fmt::format("seconds of tracing {}x{} pixels on {} threads", plan.width,
                                        plan.height, chart_.threads),
                  .yTitle = std::string(kErrorMetricLabels[static_cast<std::size_t>(chart_.metric)]),
                  .x = {},
                  .y = {},
                  .series = {}};
        for (std::size_t curve = 0; curve < experiment().curves.size(); ++curve)
            plot.series.push_back(seriesOf(curve));
        if (!limit) plot.series.insert(plot.series.begin(), front());
        if (PlotSeries failed = failures(); !failed.points.empty()) plot.series.push_back(std::move(failed));
        fitAxes(plot, Scale::Log, Scale::Log);
        addGuides(plot);
        return plot;
    }

private:
    const Experiment& experiment() const { return chart_.experiment; }

    /// Colour by method; mark and line by which of the method's curves it is.
    PlotSeries seriesOf(std::size_t index) const {
        constexpr std::array kMarks = {PlotMark::Disc, PlotMark::Square, PlotMark::Triangle,
                                       PlotMark::Diamond};
        const ExperimentCurve& curve = experiment().curves[index];
        const Method method = curve.setting.trace.method;
        const auto before = static_cast<std::size_t>(
            std::count_if(experiment().curves.begin(), experiment().curves.begin() + static_cast<long>(index),
                          [&](const ExperimentCurve& c) { return c.setting.trace.method == method; }));
        PlotSeries series{.name = curve.label,
                          .color = static_cast<int>(method),
                          .mark = kMarks[before % kMarks.size()],
                          .line = before % 2 == 0 ? PlotLine::Full : PlotLine::Dashed,
                          .points = {}};
        const auto slope = samplingSlope(experiment(), index, chart_.metric);
        if (slope && against_ == ErrorAgainst::Limit) series.name += fmt::format(": slope {:.2f}", *slope);
        for (const ExperimentPoint& point : experiment().points)
            if (point.curve == index && !point.repeats.empty()) series.points.push_back(pointOf(point));
        return series;
    }

    PlotPoint pointOf(const ExperimentPoint& point) const {
        const Spread x = point.seconds(), y = point.error(against_, chart_.metric);
        return {x.median,
                y.median,
                chart_.pointName(point),
                hoverText(chart_, point),
                std::array{x.least, x.most},
                std::array{y.least, y.most}};
    }

    PlotSeries failures() const {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        PlotSeries series{
            .name = "failed", .color = 5, .mark = PlotMark::Cross, .line = PlotLine::None, .points = {}};
        for (const ExperimentPoint& point : experiment().points)
            if (point.repeats.empty())
                series.points.push_back({kNan, kNan,
                                         fmt::format("{}: {}", chart_.pointName(point), point.failure),
                                         hoverText(chart_, point)});
        return series;
    }

    /// As steps: what is to be had by each time.
    PlotSeries front() const {
        PlotSeries series{.name = "Pareto front: nothing is faster and no less accurate",
                          .color = 5,
                          .mark = PlotMark::None,
                          .line = PlotLine::Broad,
                          .points = {}};
        std::vector<Cost> costs;
        for (const ExperimentPoint& point : experiment().points)
            costs.push_back({point.seconds().median, point.error(against_, chart_.metric).median});
        for (const std::size_t i : paretoFront(costs)) {
            if (!series.points.empty()) series.points.push_back({costs[i].time, series.points.back().y});
            series.points.push_back({costs[i].time, costs[i].error});
        }
        return series;
    }

    /// Through the first point of the curve that samples most slowly, which has most to gain.
    void addGuides(Plot& plot) const {
        const PlotPoint* slowest = nullptr;
        for (const PlotSeries& series : plot.series)
            if (series.mark != PlotMark::Cross && series.line != PlotLine::Broad && !series.points.empty() &&
                series.points.front().y > 0 && (!slowest || series.points.front().x > slowest->x))
                slowest = &series.points.front();
        const double slope = monteCarloSlope(chart_.metric);
        if (slowest && against_ == ErrorAgainst::Limit)
            plot.guides.push_back({slowest->x, slowest->y, slope,
                                   slope == -1 ? "slope −1: Monte Carlo" : "slope −½: Monte Carlo"});
        if (against_ == ErrorAgainst::Fullest && chart_.metric == ErrorMetric::Rmse &&
            experiment().fullest.error > 0)
            plot.guides.push_back(
                {plot.x.low, experiment().fullest.error, 0, "error of the reference itself"});
    }

    const Chart& chart_;
    const ErrorAgainst against_;
};

}

std::string Chart::pointName(const ExperimentPoint& point) const {
    return fmt::format("{} ×{}", experiment.curves[point.curve].label, point.samples);
}

std::vector<bool> Chart::onFront() const {
    std::vector<Cost> costs;
    costs.reserve(experiment.points.size());
    for (const ExperimentPoint& point : experiment.points)
        costs.push_back({point.seconds().median, point.error(ErrorAgainst::Fullest, metric).median});
    std::vector<bool> front(costs.size(), false);
    for (const std::size_t i : paretoFront(costs)) front[i] = true;
    return front;
}

std::vector<Plot> plotsOf(const Chart& chart) {
    return {Plotting(chart, ErrorAgainst::Limit).plot(), Plotting(chart, ErrorAgainst::Fullest).plot()};
}

}
