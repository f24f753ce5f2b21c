#pragma once
// How a case is measured: many inputs, each form's answer to each, a judge who knows the truth.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/base/math.h"
#include "core/base/sampling.h"
#include "core/geometry/ray.h"
#include "core/study/stability.h"

namespace eyeray {

using Real = long double; // of truths

/// Random numbers of one trial, the same in every run.
class TrialNumbers {
public:
    TrialNumbers(std::uint32_t seed, std::uint32_t trial) : key_(hashCombine(seed, trial)) {}

    double uniform(double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(hashCombine(key_, next_++)) * 0x1p-32);
    }
    int below(int end) { return static_cast<int>(uniform(0, end)); }
    DVec3 inCube(double half) {
        const double x = uniform(-half, half), y = uniform(-half, half);
        return {x, y, uniform(-half, half)};
    }
    DVec3 direction() {
        const double z = uniform(-1, 1), angle = uniform(0, 2 * kPiD), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::uint32_t key_, next_ = 0;
};

/// `make(numbers)` for each trial.
template <class Make>
auto inputsOf(int trials, std::uint32_t seed, const Make& make) {
    std::vector<decltype(make(std::declval<TrialNumbers&>()))> inputs;
    inputs.reserve(static_cast<std::size_t>(trials));
    for (std::uint32_t trial = 0; trial < static_cast<std::uint32_t>(trials); ++trial) {
        TrialNumbers numbers(seed, trial);
        inputs.push_back(make(numbers));
    }
    return inputs;
}

/// 0, 1, … count − 1, for trials that make their own numbers.
inline std::vector<std::uint32_t> numbered(int count) {
    std::vector<std::uint32_t> inputs(static_cast<std::size_t>(count));
    std::iota(inputs.begin(), inputs.end(), 0U);
    return inputs;
}

/// 10^from … 10^to, `perDecade` values for each factor of ten.
inline std::vector<double> decades(int from, int to, int perDecade = 1) {
    std::vector<double> values;
    for (int i = from * perDecade; i <= to * perDecade; ++i)
        values.push_back(std::pow(10.0, static_cast<double>(i) / perDecade));
    return values;
}

/// from, from + step, … up to `to`.
inline std::vector<double> steps(double from, double to, double step) {
    std::vector<double> values;
    for (int i = 0; from + i * step <= to + 1e-9 * step; ++i) values.push_back(from + i * step);
    return values;
}

/// The value, which the compiler must have computed and stored. g++ 12 takes double → float → double for
/// nothing where it has vectorised it (-ftree-slp-vectorize), so truths would be of other inputs than the
/// renderer's.
template <class T>
T pinned(T value) {
    asm volatile("" : "+m"(value)); // NOLINT(hicpp-no-assembler)
    return value;
}

/// As float has it.
inline DVec3 inFloat(const DVec3& v) { return DVec3(pinned(Vec3(v))); }

inline Ray rayFrom(const DVec3& origin, const DVec3& direction) {
    return pinned(Ray{.origin = Vec3(origin), .direction = Vec3(direction)});
}

/// Least time of several rounds over the first inputs, for each call.
template <class Input, class Call>
double nanosecondsOf(const std::vector<Input>& inputs, const StabilityEffort& effort, const Call& call) {
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t kMost = 1024; // stay in the cache
    constexpr int kRounds = 9;
    if (!effort.timed) return 0;
    const std::size_t count = std::min(kMost, inputs.size());
    double best = INFINITY;
    for (int round = 0; round < kRounds; ++round) {
        const auto start = Clock::now();
        for (std::size_t i = 0; i < count; ++i) pinned(call(inputs[i]));
        best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    }
    return best / static_cast<double>(count);
}

struct Verdict {
    double error = 0; // not finite: a failure
    bool failed = false;
};

inline Verdict verdictOf(const Verdict& verdict) { return verdict; }
inline Verdict verdictOf(bool failed) { return {0, failed}; }

/// `call(input)` for each input, judged by `judge(input, answer)`: a Verdict, or whether it failed, and then
/// the error is the share of those that did.
template <class Input, class Call, class Judge>
Measured tried(const std::vector<Input>& inputs, const StabilityEffort& effort, const Call& call,
               const Judge& judge) {
    constexpr bool yesOrNo = std::is_same_v<decltype(judge(inputs.front(), call(inputs.front()))), bool>;
    double largest = 0, failures = 0;
    for (const Input& input : inputs) {
        const Verdict verdict = verdictOf(judge(input, call(input)));
        const bool finite = std::isfinite(verdict.error);
        if (finite) largest = std::max(largest, verdict.error);
        failures += verdict.failed || !finite ? 1 : 0;
    }
    const double share = failures / static_cast<double>(inputs.size());
    return {yesOrNo ? share : largest, 1e6 * share, nanosecondsOf(inputs, effort, call)};
}

/// All three forms: `naive(input, T())` with T float and double, and `robust(input)`.
template <class Input, class Naive, class Robust, class Judge>
MeasuredForms compared(const std::vector<Input>& inputs, const StabilityEffort& effort, const Naive& naive,
                       const Robust& robust, const Judge& judge) {
    return {tried(
                inputs, effort, [&](const Input& input) { return naive(input, float()); }, judge),
            tried(
                inputs, effort, [&](const Input& input) { return naive(input, double()); }, judge),
            tried(inputs, effort, robust, judge)};
}

/// Mean of what `value` makes of each answer, and time; the error is what `judge` says of the mean.
template <class Input, class Call, class Value, class Judge>
Measured averaged(const std::vector<Input>& inputs, const StabilityEffort& effort, const Call& call,
                  const Value& value, const Judge& judge) {
    double sum = 0;
    for (const Input& input : inputs) sum += value(input, call(input));
    const Verdict verdict = judge(sum / static_cast<double>(inputs.size()));
    return {verdict.error, verdict.failed ? 1e6 : 0, nanosecondsOf(inputs, effort, call)};
}

}
