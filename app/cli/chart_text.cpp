#include <fmt/format.h>

#include "app/cli/chart.h"

namespace eyeray {

std::string textOf(const Chart& chart) {
    const Experiment& experiment = chart.experiment;
    const std::vector<bool> front = chart.onFront();
    std::string text =
        fmt::format("{:<34}{:>11}{:>13}{:>13}   ({}; * on the Pareto front)\n", "setting", "seconds",
                    "to its limit", "to fullest", kErrorMetricLabels[static_cast<std::size_t>(chart.metric)]);
    for (std::size_t i = 0; i < experiment.points.size(); ++i) {
        const ExperimentPoint& point = experiment.points[i];
        text += fmt::format("{:<34}", chart.pointName(point));
        if (point.repeats.empty())
            text += fmt::format("  failed: {}\n", point.failure);
        else
            text += fmt::format("{:>11.4g}{:>13.4g}{:>13.4g} {}\n", point.seconds().median,
                                point.error(ErrorAgainst::Limit, chart.metric).median,
                                point.error(ErrorAgainst::Fullest, chart.metric).median, front[i] ? "*" : "");
    }
    text += "\nslope of the error to its limit over samples:\n";
    for (std::size_t curve = 0; curve < experiment.curves.size(); ++curve)
        if (const auto slope = samplingSlope(experiment, curve, chart.metric))
            text += fmt::format("{:<34}{:>11.2f}\n", experiment.curves[curve].label, *slope);
    return text;
}

}
