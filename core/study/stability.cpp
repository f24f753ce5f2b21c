#include "core/study/stability.h"

#include <algorithm>

#include "core/base/thread_pool.h"
#include "core/study/stability_groups.h"

namespace eyeray {
namespace {

const std::optional<Measured>& formOf(const StabilityPoint& point, Form form) {
    return point.forms[static_cast<std::size_t>(form)];
}

std::vector<StabilityCase> gathered() {
    std::vector<StabilityCase> all;
    for (const auto group :
         {sphereCases, triangleCases, boxCases, spawnCases, transformCases, opticsCases, samplingCases,
          lampCases, sumCases, tieCases, shadingCases, seriesCases, pixelCases, numberCases})
        for (StabilityCase& one : group()) all.push_back(std::move(one));
    std::ranges::sort(all, {}, &StabilityCase::id);
    return all;
}

}

const std::vector<StabilityCase>& stabilityCases() {
    static const std::vector<StabilityCase> cases = gathered();
    return cases;
}

std::optional<Measured> StabilityResult::worst(Form form) const {
    std::optional<Measured> worst;
    for (const StabilityPoint& point : points) {
        const auto& measured = formOf(point, form);
        if (!measured) continue;
        if (!worst) worst.emplace();
        worst->error = std::max(worst->error, measured->error);
        worst->failuresPerMillion = std::max(worst->failuresPerMillion, measured->failuresPerMillion);
        worst->nanoseconds = std::max(worst->nanoseconds, measured->nanoseconds);
    }
    return worst;
}

bool StabilityResult::passes() const {
    const auto robust = worst(Form::Robust);
    return !robust || (robust->error <= subject->mark.error &&
                       robust->failuresPerMillion <= subject->mark.failuresPerMillion);
}

std::optional<double> StabilityResult::cost(Form naive) const {
    std::vector<double> ratios, fair;
    for (const StabilityPoint& point : points) {
        const auto &taught = formOf(point, naive), &robust = formOf(point, Form::Robust);
        if (!taught || !robust || !(taught->nanoseconds > 0)) continue;
        ratios.push_back(robust->nanoseconds / taught->nanoseconds);
        if (taught->failuresPerMillion == 0) fair.push_back(ratios.back());
    }
    if (!fair.empty()) ratios = std::move(fair);
    if (ratios.empty()) return {};
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

StabilityResult measureCase(const StabilityCase& subject, const StabilityEffort& effort) {
    const FloatEnvironment environment;
    StabilityResult result{&subject, {}};
    for (const double parameter : subject.sweep) {
        if (effort.stop.stop_requested()) break;
        result.points.push_back({parameter, subject.measure(parameter, effort)});
    }
    return result;
}

}
