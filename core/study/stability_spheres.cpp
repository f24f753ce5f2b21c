// Spheres and the quadratic formula: F01 to F03.

#include "core/geometry/shapes.h"
#include "core/geometry/solid.h"
#include "core/geometry/textbook_sphere.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"

namespace eyeray {
namespace {

/// The first root, by a discriminant that does not cancel; negative if there is none.
struct TrueSphere {
    Real discriminant, a, t;
};

TrueSphere trueSphere(const Ray& ray, Real radius) {
    using V = glm::vec<3, Real>;
    const V o(ray.origin), d(ray.direction);
    const Real a = glm::dot(d, d), b = glm::dot(o, d), length = std::sqrt(glm::dot(o, o));
    const V aside = glm::cross(o, d);
    const Real discriminant = a * radius * radius - glm::dot(aside, aside);
    const Real q = std::sqrt(std::max(discriminant, Real(0))) - b;
    return {discriminant, a, (length - radius) * (length + radius) / q};
}

/// Of the renderer, with the digits that its float lacks.
std::optional<double> hitBy(const Sphere& sphere, const Ray& ray) {
    const auto hit = intersect(sphere, ray);
    if (!hit) return {};
    return static_cast<double>(hit->t) + hit->u;
}

MeasuredForms farSphere(double distance, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
        TrueSphere truth;
    };
    const auto inputs = inputsOf(effort.trials, 1, [&](TrialNumbers& numbers) {
        const double x = numbers.uniform(-1.2, 1.2), y = numbers.uniform(-1.2, 1.2);
        const Ray ray = rayFrom({x, y, distance}, {0, 0, -1});
        return Input{ray, trueSphere(ray, 1)};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) {
            using T = decltype(type);
            return textbook::intersectSphere<T>(1, textbook::RayOf<T>(in.ray));
        },
        [](const Input& in) { return hitBy(Sphere{1}, in.ray); },
        [](const Input& in, const std::optional<double>& t) -> Verdict {
            const bool hits = in.truth.discriminant >= 0;
            if (std::fabs(in.truth.discriminant) < 1e-6L * in.truth.a) return {};
            if (t.has_value() != hits) return {0, true};
            return {hits ? std::fabs(static_cast<double>(*t - in.truth.t)) : 0};
        });
}

MeasuredForms hugeSphere(double radius, const StabilityEffort& effort) {
    const Sphere ground{static_cast<float>(radius)};
    struct Input {
        Ray ray;
        double t;
    };
    const auto inputs = inputsOf(effort.trials, 2, [&](TrialNumbers& numbers) {
        const double down = radians(numbers.uniform(5.7, 90)), around = numbers.uniform(0, 2 * kPiD);
        const Ray ray =
            rayFrom({0, ground.radius + 1.0, 0},
                    {std::cos(down) * std::cos(around), -std::sin(down), std::cos(down) * std::sin(around)});
        return Input{ray, static_cast<double>(trueSphere(ray, ground.radius).t)};
    });
    return compared(
        inputs, effort,
        [=](const Input& in, auto type) {
            using T = decltype(type);
            return textbook::intersectSphere<T>(ground.radius, textbook::RayOf<T>(in.ray));
        },
        [=](const Input& in) { return hitBy(ground, in.ray); },
        [](const Input& in, const std::optional<double>& t) -> Verdict {
            const double error = t ? std::fabs(*t / in.t - 1) : 0;
            return {error, !t || error > 1e-3};
        });
}

MeasuredForms smallRoot(double ratio, const StabilityEffort& effort) {
    struct Input {
        double b, c; // x² − bx + c
        Real root;
    };
    const auto inputs = inputsOf(effort.trials, 3, [&](TrialNumbers& numbers) {
        const double b = static_cast<float>(ratio * numbers.uniform(2, 3)),
                     c = static_cast<float>(numbers.uniform(0.1, 1));
        const Real half = b / Real(2);
        return Input{b, c, c / (half + std::sqrt(half * half - c))};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) {
            using T = decltype(type);
            const auto roots = textbook::quadraticRoots<T>(1, static_cast<T>(-in.b), static_cast<T>(in.c));
            return roots ? static_cast<double>(roots->lower) : NAN;
        },
        [](const Input& in) {
            const double half = -0.5 * in.b;
            return quadraticRoots(1, half, in.c, half * half - in.c).lower;
        },
        [](const Input& in, double root) -> Verdict {
            const double error = std::fabs(static_cast<double>(root / in.root - 1));
            return {error, error > 1e-3};
        });
}

}

std::vector<StabilityCase> sphereCases() {
    return {
        {.id = "F01",
         .title = "Far sphere",
         .why = "b² and 4ac agree in all their digits, so rays that miss are hits",
         .fix = "the distance of the ray from the centre: r²d² − |o × d|² (Haines, Günther, Akenine-Möller "
                "2019, Ray Tracing Gems 7), in double",
         .parameter = "distance, radii",
         .error = "error of t, radii",
         .failure = "hits for misses, or misses for hits",
         .sweep = decades(1, 5, 2),
         .showsFailures = true,
         .mark = {1e-6, 0},
         .measure = farSphere},
        {.id = "F02",
         .title = "Sphere as ground",
         .why = "p·p − R² cancels where the eye is close to a huge sphere",
         .fix = "products of floats are exact in double: the quadratic is solved in it",
         .parameter = "radius, m (the eye is 1 m above)",
         .error = "relative error of t",
         .failure = "off by more than 0.1 %, or missed",
         .sweep = decades(3, 7, 2),
         .mark = {1e-9, 0},
         .measure = hugeSphere},
        {.id = "F03",
         .title = "Small root of a quadratic",
         .why = "−b − √(b² − 4ac) cancels in the root that is small beside the other",
         .fix = "q = −(b + sgn(b)√D), roots q/a and c/q (Press et al. 2007, Numerical Recipes 5.6)",
         .parameter = "b / c",
         .error = "relative error of the root",
         .failure = "off by more than 0.1 %",
         .sweep = decades(1, 7, 2),
         .mark = {4 * 0x1p-52, 0},
         .measure = smallRoot},
    };
}

}
