// Where a ray starts that leaves a surface: F04 to F06, F61.

#include "core/geometry/accel.h"
#include "core/geometry/textbook_spawn.h"
#include "core/geometry/textbook_sphere.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"

namespace eyeray {
namespace {

constexpr double kOldEpsilon = 1e-4; // as in many programs

struct Ball {
    DVec3 center;
    float radius;
};

/// A ray at a ball, and where another leaves it, outward.
struct Leaving {
    Ray ray;
    Vec3 away;
};

Leaving leaving(const Ball& ball, const DVec3& eye, TrialNumbers& numbers) {
    const DVec3 inside = ball.center + numbers.inCube(0.5 * ball.radius);
    const DVec3 start = inFloat(eye), direction = inFloat(glm::normalize(inside - start));
    const DVec3 p = start - ball.center;
    const DVec3 unit = glm::normalize(direction), aside = p - glm::dot(p, unit) * unit;
    const double half = std::sqrt(ball.radius * static_cast<double>(ball.radius) - glm::dot(aside, aside));
    const DVec3 normal = (aside - half * unit) / static_cast<double>(ball.radius);
    DVec3 away = numbers.direction();
    while (std::fabs(glm::dot(away, normal)) < 1e-3) away = numbers.direction();
    return {rayFrom(start, direction), Vec3(glm::dot(away, normal) < 0 ? -away : away)};
}

template <class T>
std::optional<T> textbookHit(const Ball& ball, T radius, textbook::RayOf<T> ray) {
    ray.origin -= textbook::Vector<T>(ball.center);
    return textbook::intersectSphere<T>(radius, ray);
}

/// The origin of the ray that leaves, in the world.
template <class T>
std::optional<textbook::RayOf<T>> textbookSpawn(const Ball& ball, const Leaving& in, T epsilon) {
    const textbook::RayOf<T> ray(in.ray);
    const auto t = textbookHit<T>(ball, ball.radius, ray);
    if (!t) return {};
    const textbook::Vector<T> p = ray.at(*t), away(in.away);
    const auto normal = (p - textbook::Vector<T>(ball.center)) / T(ball.radius);
    return textbook::RayOf<T>(textbook::spawnOrigin<T>(p, normal, away, epsilon), away);
}

std::optional<Hit> hitBy(const Ball& ball, const Placement& placement, const Ray& ray) {
    return intersect(Sphere{ball.radius}, placement.toObject(ray));
}

/// The ray that leaves, as the renderer makes it.
std::optional<Ray> spawnedBy(const Ball& ball, const Placement& placement, const Leaving& in) {
    const Sphere sphere{ball.radius};
    const Ray local = placement.toObject(in.ray);
    const auto hit = intersect(sphere, local);
    if (!hit) return {};
    const SurfacePoint point = placement.toWorld(surfaceAt(sphere, local, *hit));
    return Ray{.origin = spawnOrigin(point, in.away), .direction = in.away};
}

Placement placedAt(const DVec3& center) {
    DMat4 map(1);
    map[3] = DVec4(center, 1);
    return Placement(map);
}

Ball ballAt(double scale) { return {inFloat(scale * DVec3(3, -2, 10)), static_cast<float>(2 * scale)}; }

MeasuredForms acne(double scale, const StabilityEffort& effort) {
    const Ball ball = ballAt(scale);
    const Placement placement = placedAt(ball.center);
    const auto inputs =
        inputsOf(effort.trials, 4, [&](TrialNumbers& numbers) { return leaving(ball, DVec3(0), numbers); });
    return compared(
        inputs, effort,
        [&](const Leaving& in, auto type) {
            using T = decltype(type);
            const auto left = textbookSpawn<T>(ball, in, 0);
            return left && textbookHit<T>(ball, T(ball.radius), *left).has_value();
        },
        [&](const Leaving& in) {
            const auto left = spawnedBy(ball, placement, in);
            return left && hitBy(ball, placement, *left).has_value();
        },
        [](const Leaving&, bool metAgain) { return metAgain; });
}

/// A shell a thousandth of the radius above the ball: what leaves the ball has to meet it.
MeasuredForms fixedEpsilon(double scale, const StabilityEffort& effort) {
    const Ball ball = ballAt(scale), shell{ball.center, 1.001F * ball.radius};
    const Placement placement = placedAt(ball.center);
    const auto eye = [&](TrialNumbers& numbers) { // between the two, to see the ball
        return ball.center + 1.0005 * ball.radius * numbers.direction();
    };
    const auto inputs = inputsOf(effort.trials, 5, [&](TrialNumbers& numbers) {
        const DVec3 from = eye(numbers);
        return leaving(ball, from, numbers);
    });
    return compared(
        inputs, effort,
        [&](const Leaving& in, auto type) {
            using T = decltype(type);
            const auto left = textbookSpawn<T>(ball, in, T(kOldEpsilon));
            return left && !textbookHit<T>(ball, T(ball.radius), *left) &&
                   textbookHit<T>(shell, T(shell.radius), *left);
        },
        [&](const Leaving& in) {
            const auto left = spawnedBy(ball, placement, in);
            return left && !hitBy(ball, placement, *left) && hitBy(shell, placement, *left);
        },
        [](const Leaving&, bool meetsShell) { return !meetsShell; });
}

MeasuredForms farEye(double distance, const StabilityEffort& effort) {
    const Ball ball{DVec3(0), 1};
    const Placement placement;
    const auto inputs = inputsOf(effort.trials, 6, [&](TrialNumbers& numbers) {
        const DVec3 eye = distance * numbers.direction();
        return leaving(ball, eye, numbers);
    });
    return compared(
        inputs, effort,
        [&](const Leaving& in, auto type) {
            using T = decltype(type);
            const auto hit = hitBy(ball, placement, in.ray);
            if (!hit) return false;
            const auto p = textbook::RayOf<T>(in.ray).at(T(hit->t) + T(hit->u));
            const Vec3 normal(glm::normalize(p));
            const Vec3 start = textbook::spawnOriginByUlps(Vec3(p), normal, in.away);
            return hitBy(ball, placement, {.origin = start, .direction = in.away}).has_value();
        },
        [&](const Leaving& in) {
            const auto left = spawnedBy(ball, placement, in);
            return left && hitBy(ball, placement, *left).has_value();
        },
        [](const Leaving&, bool metAgain) { return metAgain; });
}

constexpr int kLayers = 100;

MeasuredForms layers(double gap, const StabilityEffort& effort) {
    std::vector<Instance<Bvh2>> panes;
    panes.reserve(kLayers);
    for (int i = 0; i < kLayers; ++i)
        panes.push_back({.placement = placedAt({0, -i * gap, 0}), .geometry = Shape(Plane{9, 9, true})});
    const auto geometry = indexInstances<Bvh2>(std::move(panes), {});
    const auto inputs = inputsOf(std::max(1, effort.trials / 1000), 61, [](TrialNumbers& numbers) {
        const DVec3 from(numbers.uniform(-1, 1), 1, numbers.uniform(-1, 1));
        return rayFrom(from,
                       glm::normalize(DVec3(numbers.uniform(-0.3, 0.3), -1, numbers.uniform(-0.3, 0.3))));
    });
    const auto walked = [&](Ray ray, const auto& goOn) {
        int count = 0;
        for (auto hit = closestHit(geometry, ray); hit; hit = closestHit(geometry, ray)) {
            goOn(ray, *hit);
            ++count;
        }
        return count;
    };
    const auto naive = [&](const Ray& ray) {
        return walked(ray, [](Ray& rest, const Hit& hit) { rest.tMin = hit.t + 1e-3F; });
    };
    const auto robust = [&](const Ray& ray) {
        return walked(ray, [&](Ray& rest, const Hit& hit) {
            rest.origin = spawnOrigin(surfaceAt(geometry, rest, hit), rest.direction);
        });
    };
    const auto judge = [](const Ray&, int count) -> Verdict {
        return {std::fabs(1 - count / static_cast<double>(kLayers)), count != kLayers};
    };
    return {tried(inputs, effort, naive, judge), std::nullopt, tried(inputs, effort, robust, judge)};
}

}

std::vector<StabilityCase> spawnCases() {
    return {
        {.id = "F04",
         .title = "A surface hit again by the ray that leaves it",
         .why = "o + t·d lies off the surface, as often under it as over it",
         .fix =
             "the point put back on the surface, then moved out by its error bound (Pharr, Jakob, Humphreys "
             "2023, 6.8.6)",
         .parameter = "scale of the scene",
         .error = "share of rays that meet their own surface",
         .failure = "rays that meet their own surface",
         .sweep = decades(-3, 5),
         .mark = {0, 0},
         .measure = acne},
        {.id = "F05",
         .title = "One epsilon for all scales",
         .why = "10⁻⁴ is less than an error in a large scene, and more than a gap in a small one",
         .fix = "an offset as large as the error bound at each point (Pharr, Jakob, Humphreys 2023, 6.8.6)",
         .parameter = "scale of the scene",
         .error = "share of rays that do not meet the shell above the ball",
         .failure = "rays that meet their own surface or skip what is next",
         .sweep = decades(-3, 5),
         .mark = {0, 0},
         .measure = fixedEpsilon},
        {.id = "F06",
         .title = "An offset alone, under a far eye",
         .why = "256 floats at the point (Wächter, Binder 2019), but the error of t grows with the eye's "
                "distance",
         .fix = "the point put back on the surface first (Pharr, Jakob, Humphreys 2023, 6.8)",
         .parameter = "distance of the eye, radii",
         .error = "share of rays that meet their own surface",
         .failure = "rays that meet their own surface",
         .sweep = decades(1, 6, 2),
         .mark = {0, 0},
         .measure = farEye},
        {.id = "F61",
         .title = "Panes closer than an epsilon",
         .why = "going on at t + 10⁻³ skips whatever is nearer",
         .fix = "going on from the spawned point: no pane twice, and none left out",
         .parameter = "gap between a hundred panes, m",
         .error = "share of panes left out",
         .failure = "rays that do not count a hundred",
         .sweep = decades(-6, -1, 2),
         .mark = {0, 0},
         .measure = layers},
    };
}

}
