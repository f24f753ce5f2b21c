#include "core/study/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/image/metrics.h"
#include "core/study/log_fit.h"

namespace eyeray {
namespace {

template <class Names, class Value>
std::string_view nameIn(const Names& names, Value value) {
    return names[static_cast<std::size_t>(value)];
}

bool hasRecursion(Method method) { return method != Method::Local && method != Method::Cast; }

/// What means nothing to the method as in all settings of that method.
ExperimentSetting normalised(ExperimentSetting setting) {
    const TraceSettings usual;
    TraceSettings& trace = setting.trace;
    if (!hasRecursion(trace.method)) {
        trace.maxDepth = usual.maxDepth;
        trace.cutoff = usual.cutoff;
    }
    if (!isPhysical(trace.method)) trace.sampler = usual.sampler;
    if (trace.method == Method::Local) {
        trace.glassShadows = usual.glassShadows;
        trace.shadows = usual.shadows;
    }
    if (trace.faults.empty()) trace.precision = usual.precision;
    return setting;
}

}

std::vector<ExperimentSetting> combinations(const ExperimentGrid& grid, const TraceSettings& base) {
    std::vector<ExperimentSetting> all = {{base, {}, false}};
    const auto cross = [&](const auto& values, const auto& set) {
        std::vector<ExperimentSetting> crossed;
        for (ExperimentSetting setting : all)
            for (const auto value : values) {
                set(setting, value);
                crossed.push_back(setting);
            }
        all = std::move(crossed);
    };
    using Setting = ExperimentSetting;
    cross(grid.methods, [](Setting& s, Method method) { s.trace.method = method; });
    cross(grid.depths, [](Setting& s, int depth) { s.trace.maxDepth = depth; });
    cross(grid.cutoffs, [](Setting& s, float cutoff) { s.trace.cutoff = cutoff; });
    cross(grid.samplers, [](Setting& s, Sampler sampler) { s.trace.sampler = sampler; });
    cross(grid.glassShadows, [](Setting& s, GlassShadows policy) { s.trace.glassShadows = policy; });
    cross(grid.shadows, [](Setting& s, bool on) { s.trace.shadows = on; });
    cross(grid.precisions, [](Setting& s, Precision precision) { s.trace.precision = precision; });
    cross(grid.accels, [](Setting& s, AccelKind accel) { s.accel = accel; });
    cross(grid.adaptive, [](Setting& s, bool on) { s.adaptive = on; });
    std::vector<ExperimentSetting> distinct;
    for (const ExperimentSetting& setting : all)
        if (std::ranges::find(distinct, normalised(setting)) == distinct.end())
            distinct.push_back(normalised(setting));
    return distinct;
}

std::string labelOf(const ExperimentSetting& setting, const ExperimentGrid& grid) {
    const TraceSettings& trace = setting.trace;
    std::string label(nameIn(kMethodNames, trace.method));
    const bool recursive = hasRecursion(trace.method);
    if (grid.depths.size() > 1 && recursive) label += fmt::format(" d{}", trace.maxDepth);
    if (grid.cutoffs.size() > 1 && recursive) label += fmt::format(" c{}", trace.cutoff);
    if (grid.samplers.size() > 1 && isPhysical(trace.method))
        label += fmt::format(" {}", nameIn(kSamplerNames, trace.sampler));
    if (grid.glassShadows.size() > 1 && trace.method != Method::Local)
        label += fmt::format(" {}", nameIn(kGlassShadowNames, trace.glassShadows));
    if (grid.shadows.size() > 1 && trace.method != Method::Local && !trace.shadows) label += " no shadows";
    if (grid.precisions.size() > 1 && !trace.faults.empty())
        label += fmt::format(" {}", nameIn(kPrecisionNames, trace.precision));
    if (grid.accels.size() > 1) label += fmt::format(" {}", nameIn(kAccelNames, setting.accel));
    if (grid.adaptive.size() > 1 && setting.adaptive) label += " adaptive";
    return label;
}

TraceSettings modelOf(const ExperimentSetting& setting) {
    TraceSettings model = setting.trace;
    model.sampler = TraceSettings{}.sampler;
    return model;
}

TraceSettings fullestModel(const TraceSettings& base) {
    TraceSettings model;
    model.method = Method::Path;
    model.maxDepth = kMaxDepth;
    model.cutoff = 0;
    model.glassShadows = base.glassShadows;
    return model;
}

Reference referenceOf(const ReferenceHalves& halves, int samples) {
    Reference reference{halves[0], rmse(halves[0], halves[1]) / 2, samples};
    for (std::size_t i = 0; i < reference.picture.values().size(); ++i)
        reference.picture.values()[i] = 0.5F * (halves[0].values()[i] + halves[1].values()[i]);
    return reference;
}

Spread spreadOf(std::vector<double> values) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (values.empty() || std::ranges::any_of(values, [](double v) { return std::isnan(v); }))
        return {nan, nan, nan};
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : std::midpoint(values[middle - 1], values[middle]);
    return {median, values.front(), values.back()};
}

Spread ExperimentPoint::seconds() const {
    std::vector<double> values;
    values.reserve(repeats.size());
    for (const Repeat& repeat : repeats) values.push_back(repeat.seconds);
    return spreadOf(std::move(values));
}

Spread ExperimentPoint::samplesPerPixel() const {
    std::vector<double> values;
    values.reserve(repeats.size());
    for (const Repeat& repeat : repeats) values.push_back(repeat.samplesPerPixel);
    return spreadOf(std::move(values));
}

Spread ExperimentPoint::error(ErrorAgainst against, ErrorMetric metric) const {
    std::vector<double> values;
    values.reserve(repeats.size());
    for (const Repeat& repeat : repeats)
        values.push_back((against == ErrorAgainst::Limit ? repeat.toLimit : repeat.toFullest)[metric]);
    return spreadOf(std::move(values));
}

std::optional<double> samplingSlope(const Experiment& experiment, std::size_t curve, ErrorMetric metric) {
    std::vector<double> samples, errors;
    for (const ExperimentPoint& point : experiment.points) {
        if (point.curve != curve || point.repeats.empty()) continue;
        samples.push_back(point.samples);
        errors.push_back(point.error(ErrorAgainst::Limit, metric).median);
    }
    return fittedSlope(samples, errors);
}

}
