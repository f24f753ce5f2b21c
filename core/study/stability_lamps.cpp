// Light on its way, where the renderer itself has to answer: F39, F41, F47.

#include "core/geometry/accel.h"
#include "core/geometry/textbook_triangle.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/integrator.h"
#include "core/transport/textbook_roulette.h"

namespace eyeray {
namespace {

/// The inside of a box that glows with radiance 1 and reflects `albedo`: 1/(1 − albedo) wherever one looks.
Scene furnace(double albedo) {
    TaughtMaterial wall;
    wall.diffuse = Color(static_cast<float>(albedo));
    wall.ambient = Color(0);
    wall.emission = Color(1);
    Scene scene;
    scene.shapes = {Box{Vec3(2, 3, 4)}};
    scene.materials = {{"", wall}};
    scene.objects = {{"", ShapeId{0}, 0}};
    scene.cameras.emplace_back();
    return scene;
}

/// Mean and time of as many paths in it.
Measured traced(double albedo, int depth, const StabilityEffort& effort, int paths) {
    using Clock = std::chrono::steady_clock;
    constexpr int kSide = 64; // pixels
    TraceSettings settings;
    settings.method = Method::Path;
    settings.maxDepth = depth;
    settings.cutoff = 0;
    const Scene scene = furnace(albedo);
    const TraceContext context(buildWorld(std::make_shared<const Scene>(scene), {}), scene.cameras.front(),
                               settings, kSide, kSide, 0, effort.stop);
    const auto integrator = makeIntegrator(settings.method);
    pinned(integrator->renderTile(context, {0, 0, kSide, kSide}, 0)); // brings it into the caches
    double sum = 0;
    const int passes = std::max(1, paths / (kSide * kSide));
    const auto start = Clock::now();
    for (int pass = 0; pass < passes; ++pass)
        for (const Color& c : integrator->renderTile(context, {0, 0, kSide, kSide}, pass).radiance)
            sum += c.r;
    const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
    const double all = static_cast<double>(passes) * kSide * kSide;
    const double error = std::fabs(sum / all * (1 - albedo) - 1);
    return {error, error > 0.02 ? 1e6 : 0, effort.timed ? taken.count() / all : 0};
}

constexpr int kCostly = 5;               // times as much as a ray
constexpr int kLeastPaths = 8 * 64 * 64; // for an error well below the mark
constexpr int kUsualDepth = 5;

int pathsFor(const StabilityEffort& effort) { return std::max(kLeastPaths, effort.trials / kCostly); }

MeasuredForms truncated(double albedo, const StabilityEffort& effort) {
    const int paths = pathsFor(effort);
    return {traced(albedo, kUsualDepth, effort, paths), std::nullopt,
            traced(albedo, kMaxDepth, effort, paths)};
}

MeasuredForms roulette(double albedo, const StabilityEffort& effort) {
    const auto inputs = numbered(pathsFor(effort));
    const auto naive = [&](auto type) -> Measured {
        const auto walk = [&](std::uint32_t trial) {
            TrialNumbers numbers(41, trial);
            return textbook::furnaceByRoulette(static_cast<decltype(type)>(albedo),
                                               [&] { return numbers.uniform(0, 1); });
        };
        double sum = 0;
        for (const std::uint32_t trial : inputs) sum += walk(trial);
        const double error = std::fabs(sum / static_cast<double>(inputs.size()) * (1 - albedo) - 1);
        return {error, error > 0.02 ? 1e6 : 0}; // its time is that of no ray
    };
    return {naive(float()), naive(double()), traced(albedo, kMaxDepth, effort, pathsFor(effort))};
}

// A shadow ray to a random point of a lamp of two triangles, up to t = 1: what is hit can only be the lamp.
MeasuredForms selfShadow(double scale, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
    };
    TriangleMesh lamp;
    for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        lamp.positions.emplace_back(scale * DVec3(x, 3, z + 0.3 * x));
    lamp.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto shared = std::make_shared<const TriangleMesh>(lamp);
    const auto geometry = indexInstances<Bvh2>(
        {{.placement = Placement(), .geometry = indexMesh<Bvh2>(shared, {}), .mask = RayMask::Lamp}}, {});
    const auto inputs = inputsOf(effort.trials, 47, [&](TrialNumbers& numbers) {
        double u = numbers.uniform(0, 1), v = numbers.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const auto& p = lamp.positions;
        const Vec3 target =
            p[0] + static_cast<float>(u) * (p[1] - p[0]) + static_cast<float>(v) * (p[2] - p[0]);
        const DVec3 from = numbers.inCube(scale);
        return Input{{.origin = Vec3(from), .direction = target - Vec3(from), .tMax = 1}};
    });
    return compared(
        inputs, effort,
        [&](const Input& in, auto type) {
            using T = decltype(type);
            const auto corner = [&](std::size_t i) { return textbook::Vector<T>(lamp.positions[i]); };
            return textbook::intersectTriangle<T>({corner(0), corner(1), corner(2)},
                                                  textbook::RayOf<T>(in.ray), 0)
                .has_value();
        },
        [&](const Input& in) { return anyHit(geometry, in.ray, RayMask::Objects); },
        [](const Input&, bool shadowed) { return shadowed; });
}

}

std::vector<StabilityCase> lampCases() {
    return {
        {.id = "F39",
         .title = "Recursion cut at a depth",
         .why = "at depth 5 all later reflections are missing: ρ⁷ of the light of a closed room",
         .fix = "paths to depth 64, ended by roulette (Arvo, Kirk 1990)",
         .parameter = "albedo of a glowing room",
         .error = "relative error of its radiance",
         .failure = "off by more than 2 %",
         .sweep = {0.1, 0.3, 0.5, 0.7, 0.8, 0.9},
         .logarithmic = false,
         .mark = {0.02, 0},
         .measure = truncated},
        {.id = "F41",
         .title = "Roulette without 1/p",
         .why = "paths that survive stand for those that did not, and have to weigh as much more",
         .fix = "weight / p (Arvo, Kirk 1990)",
         .parameter = "albedo of a glowing room",
         .error = "relative error of its radiance",
         .failure = "off by more than 2 %",
         .sweep = {0.1, 0.3, 0.5, 0.7, 0.8, 0.9},
         .logarithmic = false,
         .mark = {0.02, 0},
         .measure = roulette},
        {.id = "F47",
         .title = "A lamp that shades itself",
         .why = "t of a shadow ray that ends on the lamp is 1, or by rounding less",
         .fix = "shadow rays do not see the surfaces of lamps",
         .parameter = "scale of the scene",
         .error = "share of shadow rays that are stopped",
         .failure = "shadow rays that the lamp itself stops",
         .sweep = decades(-3, 5),
         .mark = {0, 0},
         .measure = selfShadow},
    };
}

}
