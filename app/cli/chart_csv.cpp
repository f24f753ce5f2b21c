#include <fmt/format.h>

#include <cmath>

#include "app/cli/chart.h"
#include "app/cli/csv.h"

namespace eyeray {
namespace {

constexpr std::array kAgainst = {ErrorAgainst::Limit, ErrorAgainst::Fullest};
constexpr std::array kAgainstNames = {"sampling", "model"};

/// Empty for no number.
std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string cells(const Spread& spread) {
    return fmt::format("{},{},{}", cell(spread.median), cell(spread.least), cell(spread.most));
}

std::string heading() {
    std::string text = "setting,method,max_depth,cutoff,sampler,glass_shadows,shadows,precision,accel,"
                       "adaptive,samples,samples_per_pixel,runs,front,"
                       "failure,build_seconds,seconds,seconds_min,seconds_max";
    for (const char* against : kAgainstNames) {
        for (const std::string_view metric : kErrorMetricNames)
            text += fmt::format(",{0}_{1},{0}_{1}_min,{0}_{1}_max", against, metric);
        text += fmt::format(",{}_reference_error", against);
    }
    return text + "\n";
}

}

std::string csvOf(const Chart& chart) {
    const Experiment& experiment = chart.experiment;
    const std::vector<bool> front = chart.onFront();
    std::string text = heading();
    for (std::size_t i = 0; i < experiment.points.size(); ++i) {
        const ExperimentPoint& point = experiment.points[i];
        const ExperimentCurve& curve = experiment.curves[point.curve];
        const TraceSettings& trace = curve.setting.trace;
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", quoted(curve.label),
            kMethodNames[static_cast<std::size_t>(trace.method)], trace.maxDepth, trace.cutoff,
            kSamplerNames[static_cast<std::size_t>(trace.sampler)],
            kGlassShadowNames[static_cast<std::size_t>(trace.glassShadows)], trace.shadows ? "on" : "off",
            kPrecisionNames[static_cast<std::size_t>(trace.precision)],
            kAccelNames[static_cast<std::size_t>(curve.setting.accel)], curve.setting.adaptive ? "on" : "off",
            point.samples, cell(point.samplesPerPixel().median), point.repeats.size(), front[i] ? 1 : 0,
            quoted(point.failure), curve.buildSeconds, cells(point.seconds()));
        for (const ErrorAgainst against : kAgainst) {
            for (std::size_t metric = 0; metric < kErrorMetrics; ++metric)
                text += fmt::format(",{}", cells(point.error(against, static_cast<ErrorMetric>(metric))));
            text += fmt::format(
                ",{}", cell(against == ErrorAgainst::Limit ? curve.limit.error : experiment.fullest.error));
        }
        text += "\n";
    }
    return text;
}

}
