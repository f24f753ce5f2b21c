// Light that goes round in a room, where the renderer itself has to answer: F39 to F42.

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

/// The renderer beside a series that is added up term by term, in no time that would compare with a ray's.
template <class Series>
MeasuredForms besideSeries(double albedo, const StabilityEffort& effort, const Series& sum) {
    const auto naive = [&](auto type) -> Measured {
        const double error = std::fabs(sum(type) * (1 - albedo) - 1);
        return {error, error > 0.02 ? 1e6 : 0};
    };
    return {naive(float()), naive(double()), traced(albedo, kMaxDepth, effort, pathsFor(effort))};
}

MeasuredForms cutOff(double cutoff, const StabilityEffort& effort) {
    constexpr double kAlbedo = 0.9;
    return besideSeries(kAlbedo, effort, [=](auto type) -> double {
        using T = decltype(type);
        return textbook::furnaceCutOff(T(kAlbedo), static_cast<T>(cutoff));
    });
}

MeasuredForms litTwice(double albedo, const StabilityEffort& effort) {
    return besideSeries(albedo, effort, [=](auto type) -> double {
        return textbook::furnaceLitTwice(static_cast<decltype(type)>(albedo));
    });
}

MeasuredForms roulette(double albedo, const StabilityEffort& effort) {
    const int paths = pathsFor(effort);
    return besideSeries(albedo, effort, [=](auto type) {
        double sum = 0;
        for (int trial = 0; trial < paths; ++trial) {
            TrialNumbers numbers(41, static_cast<std::uint32_t>(trial));
            sum += textbook::furnaceByRoulette(static_cast<decltype(type)>(albedo),
                                               [&] { return numbers.uniform(0, 1); });
        }
        return sum / paths;
    });
}

}

std::vector<StabilityCase> seriesCases() {
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
        {.id = "F40",
         .title = "Faint rays cut off",
         .why =
             "what is left away is not the one ray but all that it would have brought: the rest of a series",
         .fix = "roulette in place of a cutoff: paths to depth 64 (Arvo, Kirk 1990)",
         .parameter = "cutoff, in a glowing room of albedo 0.9",
         .error = "relative error of its radiance",
         .failure = "off by more than 2 %",
         .sweep = decades(-3, 0, 4),
         .mark = {0.02, 0},
         .measure = cutOff},
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
        {.id = "F42",
         .title = "Emission counted twice",
         .why = "light found by shadow rays, and found again where the path goes on",
         .fix = "each weighed by how likely it was to find it (Veach, Guibas 1995)",
         .parameter = "albedo of a glowing room",
         .error = "relative error of its radiance",
         .failure = "off by more than 2 %",
         .sweep = {0.1, 0.3, 0.5, 0.7, 0.8, 0.9},
         .logarithmic = false,
         .mark = {0.02, 0},
         .measure = litTwice},
    };
}

}
