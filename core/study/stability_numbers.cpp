// Numbers too small, too large or too regular: F52, F59, F60, F64.

#include <bit>

#include <glm/gtc/packing.hpp>
#include <xmmintrin.h>

#include "core/base/thread_pool.h"
#include "core/geometry/shapes.h"
#include "core/geometry/textbook_sphere.h"
#include "core/image/codecs.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/optics.h"
#include "core/transport/textbook_sampling.h"

namespace eyeray {
namespace {

// The first points of a pixel: correlation of the two coordinates, the largest over all pixels.
MeasuredForms highBase(double base, const StabilityEffort& effort) {
    constexpr std::uint32_t kPoints = 64;
    const auto high = static_cast<std::uint32_t>(base);
    const auto low = high == 3 ? 2U : high == 7 ? 5U : high == 13 ? 11U : high == 67 ? 61U : high - 2;
    const auto correlation = [&](const auto& point) {
        double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (std::uint32_t i = 0; i < kPoints; ++i) {
            const DVec2 p = point(i);
            a += p.x, b += p.y, aa += p.x * p.x, bb += p.y * p.y, ab += p.x * p.y;
        }
        return std::fabs(kPoints * ab - a * b) / std::sqrt((kPoints * aa - a * a) * (kPoints * bb - b * b));
    };
    const auto judged = [](double r, double nanoseconds) -> Measured {
        return {r, r > 0.25 ? 1e6 : 0, nanoseconds};
    };
    const auto points = numbered(kPoints);
    const auto naive = [&](auto type) {
        const auto point = [&](std::uint32_t i) {
            using T = decltype(type);
            return DVec2(textbook::halton<T>(i + 1, low), textbook::halton<T>(i + 1, high));
        };
        return judged(correlation(point), nanosecondsOf(points, effort, point));
    };
    constexpr std::uint32_t kPixels = 256;
    double worst = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel)
        worst = std::max(worst, correlation([&](std::uint32_t i) {
                             return DVec2(sobol2({.x = pixel, .pass = i}, high, SamplePurpose::Direction));
                         }));
    const double ns = nanosecondsOf(
        points, effort, [&](std::uint32_t i) { return sobol2({.pass = i}, high, SamplePurpose::Direction); });
    return {naive(float()), naive(double()), judged(worst, ns)};
}

// Written to a file and read again.
MeasuredForms writtenAndRead(double size, const StabilityEffort& effort) {
    const auto inputs = inputsOf(
        1024, 59, [&](TrialNumbers& numbers) { return static_cast<float>(size * numbers.uniform(1, 10)); });
    const auto judge = [](float value, float read) -> Verdict {
        const double error = std::fabs(static_cast<double>(read) / static_cast<double>(value) - 1);
        return {error, error > 1e-3};
    };
    const auto half = tried(
        inputs, effort, [](float value) { return glm::unpackHalf1x16(glm::packHalf1x16(value)); }, judge);
    ColorImage image(static_cast<int>(inputs.size()), 1);
    for (std::size_t i = 0; i < inputs.size(); ++i) image.values()[i] = Color(inputs[i]);
    const auto throughFile = [&](int) { return decodeExr(encodeRadiance(image, ImageFormat::Exr, {}), ""); };
    const ColorImage read = throughFile(0);
    std::size_t next = 0;
    Measured robust = tried(
        inputs, {.trials = 0, .timed = false, .stop = {}}, [&](float) { return read.values()[next++].r; },
        judge);
    const std::vector<int> once(1);
    robust.nanoseconds = nanosecondsOf(once, effort, throughFile) / static_cast<double>(inputs.size());
    return {half, std::nullopt, robust};
}

/// The processor's own way with numbers below the normal ones, while it lives.
class GradualUnderflow {
public:
    GradualUnderflow() { _mm_setcsr(saved_ & ~kFlushes); }
    ~GradualUnderflow() { _mm_setcsr(saved_); }
    GradualUnderflow(const GradualUnderflow&) = delete;
    GradualUnderflow& operator=(const GradualUnderflow&) = delete;

private:
    static constexpr unsigned kFlushes = 0x8040; // FTZ and DAZ
    unsigned saved_ = _mm_getcsr();
};

bool isDenormal(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x7f800000U) == 0 && (bits & 0x007fffffU) != 0;
}
bool isDenormal(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return (bits & 0x7ff0000000000000U) == 0 && (bits & 0x000fffffffffffffU) != 0;
}

// Light through so many lengths of e, then through 64 panes.
MeasuredForms denseAbsorber(double depth, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials / 10, 60, [&](TrialNumbers& numbers) {
        return static_cast<float>(depth * numbers.uniform(0.95, 1));
    });
    const auto throughPanes = [](auto light) {
        using T = decltype(light);
        constexpr int kPanes = 64;
        for (int i = 0; i < kPanes; ++i) light = pinned(light * T(0.96));
        return light;
    };
    const auto judge = [](float, auto light) -> bool { return isDenormal(light); };
    const auto naive = [&](auto type) {
        const GradualUnderflow gradual;
        return tried(
            inputs, effort, [&](float d) { return throughPanes(std::exp(-static_cast<decltype(type)>(d))); },
            judge);
    };
    const FloatEnvironment environment;
    const auto robust =
        tried(inputs, effort, [&](float d) { return throughPanes(transmittanceOf(Color(1), d).x); }, judge);
    return {naive(float()), naive(double()), robust};
}

// A ball of a tenth of its distance.
MeasuredForms farBall(double distance, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
        float radius;
    };
    const auto inputs = inputsOf(effort.trials, 64, [&](TrialNumbers& numbers) {
        const double radius = 0.1 * distance;
        const DVec3 target(numbers.uniform(-0.5, 0.5) * radius, numbers.uniform(-0.5, 0.5) * radius, 0);
        const DVec3 eye = inFloat({0, 0, distance});
        return Input{rayFrom(eye, glm::normalize(target - eye)), static_cast<float>(radius)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) {
            using T = decltype(type);
            textbook::RayOf<T> ray(in.ray);
            ray.tMax = T(1e4); // "far enough"
            return textbook::intersectSphere<T>(in.radius, ray).has_value();
        },
        [](const Input& in) { return intersect(Sphere{in.radius}, in.ray).has_value(); },
        [](const Input&, bool hit) { return !hit; });
}

}

std::vector<StabilityCase> numberCases() {
    return {
        {.id = "F52",
         .title = "Halton points in high bases",
         .why = "in base 67 the first 67 points rise in step: two such coordinates lie on a line",
         .fix = "pairs of an Owen-scrambled (0,2)-sequence (Burley 2020, JCGT 10(4))",
         .parameter = "higher base of two neighbouring ones",
         .error = "correlation of 64 points' coordinates",
         .failure = "above 0.25",
         .sweep = {3, 7, 13, 19, 31, 43, 67},
         .mark = {0.25, 0},
         .measure = highBase},
        {.id = "F59",
         .title = "Radiance in half floats",
         .why = "above 65,520 is infinity, below 0.00000003 is 0, and 2,049 is 2,048",
         .fix = "EXR of 32-bit floats, bit for bit",
         .parameter = "radiance",
         .error = "relative error",
         .failure = "off by more than 0.1 %",
         .sweep = decades(-9, 9, 1),
         .showsFailures = true,
         .mark = {0, 0},
         .measure = writtenAndRead},
        {.id = "F60",
         .title = "Denormal numbers",
         .why = "below 10⁻³⁸ the processor computes a hundred times as slowly, for light that no one sees",
         .fix = "flushed to 0 on every thread that traces (FTZ and DAZ)",
         .parameter = "optical depth",
         .error = "share of results that are denormal",
         .failure = "results that are denormal",
         .sweep = {10, 40, 70, 80, 86, 90, 95, 100, 110},
         .logarithmic = false,
         .showsFailures = true,
         .mark = {0, 0},
         .measure = denseAbsorber},
        {.id = "F64",
         .title = "A search that starts at 10,000",
         .why = "“the nearest hit so far” begins with a number that seemed large enough",
         .fix = "it begins with infinity",
         .parameter = "distance, m",
         .error = "share of rays that miss",
         .failure = "rays that miss a ball",
         .sweep = decades(0, 9),
         .mark = {0, 0},
         .measure = farBall},
    };
}

}
