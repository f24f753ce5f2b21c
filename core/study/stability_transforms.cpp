// Places, maps and cameras: F20 to F25, F63.

#include "core/geometry/shapes.h"
#include "core/geometry/textbook_frame.h"
#include "core/geometry/textbook_sphere.h"
#include "core/geometry/textbook_transform.h"
#include "core/scene/camera.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/textbook_camera.h"
#include "core/transport/trace_context.h"

namespace eyeray {
namespace {

DMat4 scaledBy(const DVec3& scale) {
    DMat4 map(1);
    for (int axis = 0; axis < 3; ++axis) map[axis][axis] = scale[axis];
    return map;
}

// A ball of 1 m, 5 m in front of the eye, both `away` from the origin of the scene.
MeasuredForms farAway(double away, const StabilityEffort& effort) {
    constexpr int kSide = 512; // pixels
    constexpr double kDistance = 5;
    struct Input {
        int x, y;
        DVec3 direction, point; // the hit relative to the ball's centre
    };
    const DVec3 center(away, 0.3 * away, -0.7 * away), eye = center + DVec3(0, 0, kDistance);
    Scene scene;
    scene.shapes = {Sphere{1}};
    scene.materials.emplace_back();
    DMat4 map(1);
    map[3] = DVec4(center, 1);
    scene.objects.push_back({"", ShapeId{0}, 0, map});
    const Camera camera{.name = "", .eye = eye, .target = center};
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    const EyeRays eyeRays(camera, world->origin, kSide, kSide);
    const auto inputs = inputsOf(effort.trials, 20, [&](TrialNumbers& numbers) {
        const int x = 180 + numbers.below(152), y = 180 + numbers.below(152); // within the ball's outline
        const double plane = std::tan(camera.verticalFov / 2) / kSide;
        const DVec3 d = glm::normalize(DVec3(plane * (2 * x + 1 - kSide), -plane * (2 * y + 1 - kSide), -1));
        const double along = -kDistance * d.z;
        const double t = along - std::sqrt(1 - kDistance * kDistance + along * along);
        return Input{x, y, d, DVec3(0, 0, kDistance) + t * d};
    });
    return compared(
        inputs, effort,
        [&](const Input& in, auto type) {
            using T = decltype(type);
            const textbook::Vector<T> ball(center), from(eye), direction(in.direction);
            const auto t = textbook::intersectSphere<T>(1, {from - ball, direction});
            return t ? DVec3(from + *t * direction) - center : DVec3(NAN);
        },
        [&](const Input& in) {
            const Ray ray = eyeRays.through(in.x, in.y, Vec2(0.5F));
            return std::visit(
                [&](const auto& geometry) {
                    const auto hit = closestHit(geometry, ray);
                    if (!hit) return DVec3(NAN);
                    return DVec3(surfaceAt(geometry, ray, *hit).position) + (world->origin - center);
                },
                *world->accel);
        },
        [](const Input& in, const DVec3& point) -> Verdict {
            const double error = glm::length(point - in.point);
            return {error, error > 1e-3};
        });
}

MeasuredForms renormalised(double scale, const StabilityEffort& effort) {
    constexpr double kDistance = 5; // of the instance; other things are a metre before and behind
    struct Input {
        Ray ray;
        double t;
    };
    const DMat4 map = scaledBy(DVec3(scale));
    const Placement placement(map);
    const auto inputs = inputsOf(effort.trials, 21, [&](TrialNumbers& numbers) {
        const DVec3 out = numbers.direction();
        const Ray ray = rayFrom((kDistance + scale) * out, -out);
        return Input{ray, glm::length(DVec3(ray.origin)) - scale};
    });
    return compared(
        inputs, effort,
        [inverse = glm::inverse(map)](const Input& in, auto type) -> std::optional<double> {
            using T = decltype(type);
            const glm::mat<4, 4, T> worldToObject(inverse);
            return textbook::intersectSphere<T>(
                1, textbook::toObject<T>(worldToObject, textbook::RayOf<T>(in.ray)));
        },
        [&](const Input& in) -> std::optional<double> {
            const auto hit = intersect(Sphere{1}, placement.toObject(in.ray));
            return hit ? std::optional<double>(hit->t) : std::nullopt;
        },
        [](const Input& in, const std::optional<double>& t) -> Verdict {
            if (!t) return {0, true};
            return {std::fabs(*t / in.t - 1), std::fabs(*t - kDistance) > 1};
        });
}

MeasuredForms squashedNormal(double squash, const StabilityEffort& effort) {
    const DMat4 map = scaledBy({1, 1, squash});
    const Placement placement(map);
    const auto inputs = inputsOf(effort.trials, 22, [](TrialNumbers& numbers) {
        return Vec3(numbers.direction()); // point and normal of the unit sphere
    });
    return compared(
        inputs, effort,
        [&](const Vec3& normal, auto type) {
            using T = decltype(type);
            return DVec3(
                textbook::toWorldNormal<T>(glm::mat<3, 3, T>(DMat3(map)), textbook::Vector<T>(normal)));
        },
        [&](const Vec3& normal) {
            return DVec3(placement.toWorld(surfacePoint(DVec3(normal), DVec3(normal))).geometricNormal);
        },
        [=](const Vec3& normal, const DVec3& mapped) -> Verdict {
            const DVec3 truth = glm::normalize(DVec3(normal) / DVec3(1, 1, squash));
            const double angle =
                degrees(2 * std::asin(std::min(1.0, glm::length(glm::normalize(mapped) - truth) / 2)));
            return {angle, angle > 0.1};
        });
}

/// Times and judges `step` applied over and over; the error is how far `distance` has drifted from 1.
template <class State, class Step, class Distance>
Measured stepped(State state, int steps, const StabilityEffort& effort, const Step& step,
                 const Distance& distance) {
    using Clock = std::chrono::steady_clock;
    pinned(step(state)); // brings the code into the cache
    const auto start = Clock::now();
    for (int i = 0; i < steps; ++i) state = step(state);
    const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
    const double error = std::fabs(distance(state) - 1);
    return {error, error > 1e-3 ? 1e6 : 0, effort.timed ? taken.count() / steps : 0};
}

template <class T>
Measured turned(int steps, const StabilityEffort& effort) {
    const T c = std::cos(static_cast<T>(radians(1))), s = std::sin(static_cast<T>(radians(1)));
    const glm::mat<3, 3, T> turn(c, 0, -s, 0, 1, 0, s, 0, c);
    return stepped(
        glm::mat<3, 3, T>(1), steps, effort, [&](const auto& all) { return turn * all; },
        [](const auto& all) { return static_cast<double>(glm::length(all * textbook::Vector<T>(0, 0, 1))); });
}

MeasuredForms orbits(double count, const StabilityEffort& effort) {
    const int steps = static_cast<int>(std::lround(count));
    const Camera camera{.name = "", .eye = DVec3(0, 0, 1), .target = DVec3(0)};
    return {turned<float>(steps, effort), turned<double>(steps, effort),
            stepped(
                camera, steps, effort, [](const Camera& c) { return orbited(c, radians(1), 0); },
                [](const Camera& c) { return c.distance(); })};
}

template <class T>
double skewOf(const glm::mat<3, 3, T>& frame) {
    const DMat3 f(frame), product = glm::transpose(f) * f;
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const double off = std::fabs(product[i][k] - (i == k ? 1 : 0));
            worst = off > worst || std::isnan(off) ? off : worst;
        }
    return worst;
}

MeasuredForms frames(double angle, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials, 24, [&](TrialNumbers& numbers) {
        const double around = numbers.uniform(0, 2 * kPiD), off = angle * numbers.uniform(0.3, 1);
        return DVec3(std::sin(off) * std::cos(around), std::sin(off) * std::sin(around), -std::cos(off));
    });
    return compared(
        inputs, effort,
        [](const DVec3& normal, auto type) {
            using T = decltype(type);
            const auto frame = textbook::frameAround<T>(textbook::Vector<T>(normal));
            return DMat3(glm::mat<3, 3, T>(frame.tangent, frame.bitangent, frame.normal));
        },
        [](const DVec3& normal) {
            const Frame frame = Frame::around(Vec3(normal));
            return DMat3(Mat3(frame.tangent, frame.bitangent, frame.normal));
        },
        [](const DVec3&, const DMat3& frame) -> Verdict {
            const double skew = skewOf(frame);
            return {skew, skew > 1e-3};
        });
}

MeasuredForms nearPole(double angle, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
        double share; // of π from the top
    };
    const auto inputs = inputsOf(effort.trials, 25, [&](TrialNumbers& numbers) {
        const double around = numbers.uniform(0, 2 * kPiD), off = angle * numbers.uniform(0.1, 1);
        const DVec3 target(std::sin(off) * std::cos(around), std::cos(off), std::sin(off) * std::sin(around));
        const DVec3 eye(Vec3(DVec3(0, 3, 0) + numbers.inCube(1)));
        const Ray ray = rayFrom(eye, glm::normalize(target - eye));
        const glm::vec<3, Real> o(ray.origin), d(ray.direction);
        const Real a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1;
        const auto p = o + c / (std::sqrt(b * b - a * c) - b) * d;
        return Input{ray, static_cast<double>(std::atan2(std::hypot(p.x, p.z), p.y)) / kPiD};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using T = decltype(type);
            const textbook::RayOf<T> ray(in.ray);
            const auto t = textbook::intersectSphere<T>(1, ray);
            return t ? textbook::latitude<T>(1, ray.at(*t)) : T(NAN);
        },
        [](const Input& in) -> double {
            const auto hit = intersect(Sphere{1}, in.ray);
            return hit ? textureCoordinates(Sphere{1}, surfaceAt(Sphere{1}, in.ray, *hit), 0).y : NAN;
        },
        [](const Input& in, double v) -> Verdict { return {std::fabs(v - in.share)}; });
}

MeasuredForms pixels(double width, const StabilityEffort& effort) {
    const int side = static_cast<int>(std::lround(width));
    const Camera camera;
    const EyeRays eyeRays(camera, DVec3(0), side, side);
    const auto inputs =
        inputsOf(effort.trials, 63, [&](TrialNumbers& numbers) { return numbers.below(side); });
    return compared(
        inputs, effort,
        [=](int x, auto type) -> double { return textbook::pixelPosition<decltype(type)>(x, side); },
        [&](int x) {
            const Ray ray = eyeRays.through(x, side / 2, Vec2(0.5F));
            return ray.direction.x / -ray.direction.z / std::tan(camera.verticalFov / 2);
        },
        [=](int x, double position) -> Verdict {
            const double truth = (2.0 * x + 1 - side) / side, error = std::fabs(position - truth) * side / 2;
            return {error, error > 0.1};
        });
}

}

std::vector<StabilityCase> transformCases() {
    return {
        {.id = "F20",
         .title = "Far from the origin",
         .why = "at 10⁵ m the next float is 8 mm away, so eye, ball and hit all jump",
         .fix = "transforms in double, and floats relative to an origin of the scene's own",
         .parameter = "distance from the origin, m",
         .error = "error of the hit point, m (5 m from the eye)",
         .failure = "off by more than 1 mm, a quarter of a pixel",
         .sweep = decades(0, 7),
         .mark = {1e-5, 0},
         .measure = farAway},
        {.id = "F21",
         .title = "Direction renormalised in object space",
         .why = "t is then in units of the object, and hits of two objects are compared wrongly",
         .fix = "the direction is mapped as it is, so t stays the world's",
         .parameter = "scale of the instance",
         .error = "relative error of t",
         .failure = "more than a metre off at 5 m: hidden by what is behind, or before what hides it",
         .sweep = decades(-3, 2, 2),
         .mark = {1e-5, 0},
         .measure = renormalised},
        {.id = "F22",
         .title = "Normals by the matrix of points",
         .why = "a squashed ball gets normals that lean the wrong way",
         .fix = "the inverse transpose (Turkowski 1990, Graphics Gems)",
         .parameter = "height of the squashed ball",
         .error = "error of the normal, degrees",
         .failure = "off by more than 0.1°",
         .sweep = decades(-3, 0, 2),
         .mark = {1e-3, 0},
         .measure = squashedNormal},
        {.id = "F23",
         .title = "Products of rotations",
         .why = "each product rounds, and nothing brings it back to a rotation",
         .fix = "angles are what changes; the axes are made from them anew",
         .parameter = "orbits by a degree",
         .error = "relative drift of the distance to the target",
         .failure = "off by more than 0.1 %",
         .sweep = decades(1, 6),
         .mark = {1e-9, 0},
         .measure = orbits},
        {.id = "F24",
         .title = "Axes around a normal near −z",
         .why = "1 + n.z cancels before the branch that is to catch it (Frisvad 2012)",
         .fix = "the sign of n.z keeps the sum from cancelling (Duff et al. 2017, JCGT 6(1))",
         .parameter = "angle from −z, radians",
         .error = "largest entry of FᵀF − I",
         .failure = "off by more than 10⁻³",
         .sweep = decades(-8, 0),
         .mark = {1e-6, 0},
         .measure = frames},
        {.id = "F25",
         .title = "Arc cosine near a pole",
         .why = "a rounded cosine above 1 has no angle, and below it half of the digits are lost",
         .fix = "atan2(√(x² + z²), y) (Kahan)",
         .parameter = "angle from the pole, radians",
         .error = "error of v",
         .failure = "not a number",
         .sweep = decades(-6, -1),
         .mark = {1e-6, 0},
         .measure = nearPole},
        {.id = "F63",
         .title = "Corners of pixels for centres",
         .why = "x/(W − 1) puts the first and the last pixel on the edges of the picture",
         .fix = "(2x + 1 − W)/W: centres, exactly antisymmetric",
         .parameter = "width of the picture, pixels",
         .error = "place in the picture, pixels",
         .failure = "off by more than a tenth of a pixel",
         .sweep = {8, 32, 128, 512, 2048, 8192},
         .mark = {1e-2, 0},
         .measure = pixels},
    };
}

}
