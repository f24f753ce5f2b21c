// Random numbers, and directions and points made of them: F43 to F46, F50, F51.

#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/bsdf.h"
#include "core/transport/emitter_shapes.h"
#include "core/transport/textbook_sampling.h"
#include "core/transport/trace_context.h"

namespace eyeray {
namespace {

const Vec3 kUp(0, 1, 0);

/// Points of one pixel's Sobol' sequence, and one more number for each.
struct Drawn {
    Vec2 u;
    float v;
};
std::vector<Drawn> drawn(int count) {
    std::vector<Drawn> all;
    for (int pass = 0; pass < count; ++pass) {
        const SampleAddress address{.pass = static_cast<std::uint32_t>(pass)};
        all.push_back(
            {sobol2(address, 1, SamplePurpose::Direction), sobol2(address, 2, SamplePurpose::Lobe).x});
    }
    return all;
}

// Under a sky of radiance cosⁿ a white diffuse surface shows 2/(n + 2).
MeasuredForms hemisphere(double power, const StabilityEffort& effort) {
    const auto inputs = drawn(effort.trials);
    const double truth = 2 / (power + 2);
    const auto sky = [=](const Drawn&, const Vec3& wi) { return std::pow(std::max(0.0F, wi.y), power); };
    const auto judge = [=](double mean) {
        const double error = std::fabs(mean / truth - 1);
        return Verdict{error, error > 0.005};
    };
    const auto naive = [](auto type) {
        using V = textbook::Vector<decltype(type)>;
        return [](const Drawn& in) { return Vec3(textbook::aroundNormal(V(kUp), V(in.u.x, in.u.y, in.v))); };
    };
    PhysicalSurface white;
    white.diffuse = Color(1);
    const Bsdf bsdf(white, {.wo = kUp, .normal = kUp, .geometricNormal = kUp});
    const auto robust = [&](const Drawn& in) {
        const auto sample = bsdf.sample(RayKind::Diffuse, in.u);
        return sample ? sample->wi * 1.0F : Vec3(0);
    };
    return {averaged(inputs, effort, naive(float()), sky, judge),
            averaged(inputs, effort, naive(double()), sky, judge),
            averaged(inputs, effort, robust, sky, judge)};
}

// The share of points within a share of the radius.
MeasuredForms lens(double within, const StabilityEffort& effort) {
    const Camera camera{.name = "", .eye = DVec3(0), .lensRadius = 1, .focusDistance = 10};
    const EyeRays eyeRays(camera, DVec3(0), 1, 1);
    const Ray through = eyeRays.through(0, 0, Vec2(0.5F));
    const auto inputs = drawn(effort.trials);
    const auto inside = [=](const Drawn&, const DVec2& p) { return glm::length(p) < within ? 1.0 : 0.0; };
    const auto judge = [=](double share) {
        const double error = std::fabs(share - within * within);
        return Verdict{error, error > 0.005};
    };
    const auto naive = [](auto type) {
        return [](const Drawn& in) { return DVec2(textbook::onLens(glm::vec<2, decltype(type)>(in.u))); };
    };
    const auto robust = [&](const Drawn& in) { return DVec2(Vec2(eyeRays.fromLens(through, in.u).origin)); };
    return {averaged(inputs, effort, naive(float()), inside, judge),
            averaged(inputs, effort, naive(double()), inside, judge),
            averaged(inputs, effort, robust, inside, judge)};
}

// Irradiance of a square of 1 m above a point, each sample's share of it: its variance is what costs samples.
MeasuredForms closeLamp(double height, const StabilityEffort& effort) {
    const SphericalRectangle square({0, height, 0}, {1, 0, 0}, {0, 0, 1});
    const auto inputs = drawn(effort.trials);
    const auto irradiance = [](const std::optional<ShapeSample>& s) {
        return s ? static_cast<double>(std::max(0.0F, s->wi.y)) / s->pdfW : 0.0;
    };
    const auto spread = [&](const auto& call) -> Measured {
        double sum = 0, squares = 0;
        for (const Drawn& in : inputs) {
            const double e = irradiance(call(in));
            sum += e;
            squares += e * e;
        }
        const double n = static_cast<double>(inputs.size()), mean = sum / n;
        const double deviation = std::sqrt(std::max(0.0, squares / n - mean * mean)) / mean;
        return {deviation, deviation > 1 ? 1e6 : 0, nanosecondsOf(inputs, effort, call)};
    };
    return {spread([&](const Drawn& in) { return square.sampleByArea(Vec3(0), in.u); }), std::nullopt,
            spread([&](const Drawn& in) { return square.sample(Vec3(0), in.u); })};
}

MeasuredForms smallCone(double ratio, const StabilityEffort& effort) {
    struct Input {
        float radius, distance;
        SphericalEllipsoid ball;
        double truth;
    };
    const auto inputs = inputsOf(effort.trials / 10, 46, [&](TrialNumbers& numbers) {
        const auto distance = static_cast<float>(numbers.uniform(1, 2)),
                   radius = static_cast<float>(ratio * distance * numbers.uniform(0.8, 1));
        DMat4 map(DMat3(1.0) * static_cast<double>(radius));
        map[3] = DVec4(0, distance, 0, 1);
        const Real sine = static_cast<Real>(radius) / distance, sine2 = sine * sine;
        const Real cone = sine2 / (1 + std::sqrt(1 - sine2));
        return Input{radius, distance, SphericalEllipsoid(map),
                     static_cast<double>(1 / (2 * Real(kPiD) * cone))};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using T = decltype(type);
            return textbook::conePdfW<T>(in.radius, in.distance);
        },
        [](const Input& in) -> double { return in.ball.pdfW(Vec3(0), kUp); },
        [](const Input& in, double pdf) -> Verdict {
            const double error = std::fabs(pdf / in.truth - 1);
            return {error, error > 1e-3};
        });
}

// Correlation of the first numbers of pixels that lie so far apart.
MeasuredForms neighbours(double distance, const StabilityEffort& effort) {
    const auto lag = static_cast<std::uint32_t>(std::lround(distance));
    const auto inputs = numbered(effort.trials);
    const auto correlation = [&](const auto& call) -> Measured {
        double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (const std::uint32_t pixel : inputs) {
            const double x = call(pixel), y = call(pixel + lag);
            a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
        }
        const double n = static_cast<double>(inputs.size());
        const double covariance = ab / n - a / n * b / n;
        const double variances = (aa / n - a / n * a / n) * (bb / n - b / n * b / n);
        const double r = std::fabs(covariance / std::sqrt(variances));
        return {r, r > 0.1 ? 1e6 : 0, nanosecondsOf(inputs, effort, call)};
    };
    return {correlation([](std::uint32_t pixel) -> double { return textbook::firstOfSeed<float>(pixel); }),
            correlation([](std::uint32_t pixel) { return textbook::firstOfSeed<double>(pixel); }),
            correlation([](std::uint32_t pixel) -> double {
                return sobol2({.x = pixel}, 0, SamplePurpose::Direction).x;
            })};
}

MeasuredForms lastNumbers(double below, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials, 51, [&](TrialNumbers& numbers) {
        return ~static_cast<std::uint32_t>(numbers.uniform(0, below));
    });
    return compared(
        inputs, effort,
        [](std::uint32_t bits, auto type) -> double { return textbook::toUnit<decltype(type)>(bits); },
        [](std::uint32_t bits) -> double { return toUnitFloat(bits); },
        [](std::uint32_t bits, double u) -> Verdict { return {std::fabs(u - bits * 0x1p-32), u >= 1}; });
}

}

std::vector<StabilityCase> samplingCases() {
    return {
        {.id = "F43",
         .title = "Cosine distribution by points in a ball",
         .why = "they crowd about the normal; a furnace (n = 0) shows nothing of it",
         .fix = "a disk projected up to the hemisphere (Malley; Pharr, Jakob, Humphreys 2023, A.5.3)",
         .parameter = "n of a sky of radiance cosⁿ",
         .error = "relative error of the light that it brings",
         .failure = "off by more than 0.5 %",
         .sweep = {0, 1, 2, 4, 8, 16},
         .logarithmic = false,
         .mark = {5e-3, 0},
         .measure = hemisphere},
        {.id = "F44",
         .title = "Points on a lens crowded in its middle",
         .why = "u for the distance from the middle gives each ring as many points, however narrow",
         .fix = "√u",
         .parameter = "within this share of the radius",
         .error = "error of the share of points",
         .failure = "off by more than 0.005",
         .sweep = steps(0.1, 0.9, 0.1),
         .logarithmic = false,
         .mark = {5e-3, 0},
         .measure = lens},
        {.id = "F45",
         .title = "A lamp sampled by its area, close by",
         .why =
             "1/r² of the few nearest points carries all the light: for 1 % at h = 0.01 ten million samples",
         .fix = "uniform over its solid angle (Ureña, Fajardo, King 2013)",
         .parameter = "height over the point of a square of 1 m, m",
         .error = "standard deviation of a sample / mean",
         .failure = "deviation above the mean",
         .sweep = decades(-3, 0, 2),
         .mark = {1, 0},
         .measure = closeLamp},
        {.id = "F46",
         .title = "1 − cos θ of a small cone",
         .why = "cos θ rounds to 1: off by 7 % at a thousandth, infinite at a ten thousandth",
         .fix = "sin² θ / (1 + cos θ)",
         .parameter = "radius / distance of a ball",
         .error = "relative error of the density",
         .failure = "off by more than 0.1 %, or infinite",
         .sweep = decades(-5, -1, 2),
         .mark = {1e-6, 0},
         .measure = smallCone},
        {.id = "F50",
         .title = "Seeds that differ by one",
         .why = "the first number of a linear generator is linear in its seed: streaks",
         .fix = "numbers by hash of seed, pixel, pass and purpose (Wellons 2018; Burley 2020, JCGT 10(4))",
         .parameter = "distance of the pixels",
         .error = "correlation of their first numbers",
         .failure = "above 0.1",
         .sweep = {1, 2, 4, 8, 16, 32, 64},
         .mark = {0.02, 0},
         .measure = neighbours},
        {.id = "F51",
         .title = "A random number of 1.0",
         .why = "the last 128 of 2³² integers round to 1: an index past the end, log 0",
         .fix = "the top 24 bits alone: (u >> 8) · 2⁻²⁴",
         .parameter = "of the last so many integers",
         .error = "error of the number",
         .failure = "numbers that are 1",
         .sweep = decades(1, 6),
         .showsFailures = true,
         .mark = {0x1p-24, 0},
         .measure = lastNumbers},
    };
}

}
