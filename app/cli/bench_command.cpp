#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "app/cli/bench.h"
#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/run.h"

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSide = 512; // pixels
constexpr int kLeastRounds = 7;
constexpr std::size_t kRaysToTry = 2048;      // to find how many fill a round
constexpr std::size_t kMostForBrute = 20'000; // primitives
constexpr std::array kDefaultScenes = {"homage", "knot"};

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<int> threadCounts(const BenchOptions& options) {
    if (options.threads) return {*options.threads};
    const int cores = ThreadPool().threads();
    std::vector<int> counts = {1};
    if (cores > 1) counts.push_back(2);
    if (cores > 2) counts.push_back(cores);
    return counts;
}

class SceneBench {
public:
    SceneBench(const std::string& scene, const BenchOptions& options, double seconds)
        : threads_(threadCounts(options)) {
        const OpenedScene opened = openScene(scene);
        result_ = {opened.reference, kSide, opened.loadSeconds, {}, {}};
        for (const AccelKind accel : {AccelKind::Bvh8, AccelKind::Bvh2, AccelKind::Brute}) {
            if (options.accel && *options.accel != accel) continue;
            if (!result_.indices.empty() && accel == AccelKind::Brute &&
                result_.indices.front()->primitives > kMostForBrute)
                continue;
            result_.indices.push_back(buildWorld(opened.document.scene, {accel}));
        }
        sets_ = raySets(*result_.indices.front(), opened.document.camera, kSide);
        std::erase_if(sets_, [](const RaySet& set) { return set.rays.empty(); });
        setSeconds_ = seconds / static_cast<double>(steps());
    }

    /// Until done or interrupted.
    BenchedScene measure() {
        Progress progress(steps());
        for (const int threads : threads_) {
            ThreadPool pool(threads);
            for (const RaySet& set : sets_) measure(set, pool, progress);
        }
        return std::move(result_);
    }

private:
    std::size_t steps() const { return std::max<std::size_t>(1, threads_.size() * sets_.size()); }

    /// As many of the rays as fill a round.
    RaySet filling(const RaySet& set, const Accel& accel, ThreadPool& pool) const {
        RaySet few{set.kind, set.anyHit, thinned(set.rays, kRaysToTry)};
        const double roundSeconds = setSeconds_ / static_cast<double>(kLeastRounds * result_.indices.size());
        trace(accel, few, pool); // brings what it reads into the caches
        const double each = trace(accel, few, pool).seconds / static_cast<double>(few.rays.size());
        few.rays = thinned(set.rays, static_cast<std::size_t>(roundSeconds / each));
        return few;
    }

    void measure(const RaySet& set, ThreadPool& pool, Progress& progress) {
        std::vector<RaySet> sets;
        std::vector<BenchFigure> figures;
        std::vector<std::vector<double>> seconds(result_.indices.size());
        for (std::size_t i = 0; i < result_.indices.size(); ++i) {
            sets.push_back(filling(set, *result_.indices[i]->accel, pool));
            figures.push_back({i, pool.threads(), set.kind, sets.back().rays.size(), 0, {}, {}, 0});
            const RaySet few{set.kind, set.anyHit, thinned(sets.back().rays, kRaysToTry)};
            figures.back().counts = countTraversal(*result_.indices[i]->accel, few);
            figures.back().counted = few.rays.size();
        }
        const auto start = Clock::now();
        for (int round = 0; round < kLeastRounds || secondsSince(start) < setSeconds_; ++round)
            for (std::size_t i = 0; i < sets.size(); ++i) {
                if (interrupted()) return;
                const TracedSet traced = trace(*result_.indices[i]->accel, sets[i], pool);
                seconds[i].push_back(traced.seconds);
                figures[i].hits = traced.hits;
            }
        for (std::size_t i = 0; i < figures.size(); ++i) figures[i].seconds = seriesOf(seconds[i]);
        result_.figures.insert(result_.figures.end(), figures.begin(), figures.end());
        progress.step(
            fmt::format("{}, {} rays, {} threads", result_.reference, name(set.kind), pool.threads()));
    }

    std::vector<int> threads_;
    BenchedScene result_;
    std::vector<RaySet> sets_;
    double setSeconds_; // for one kind of rays and number of threads, by all indices
};

}

int run(const BenchOptions& options) {
    heedInterrupts();
    std::vector<std::string> names(kDefaultScenes.begin(), kDefaultScenes.end());
    if (!options.scene.empty()) names = {options.scene};
    std::vector<BenchedScene> scenes;
    for (const std::string& scene : names) {
        if (interrupted()) break;
        scenes.push_back(
            SceneBench(scene, options, options.seconds / static_cast<double>(names.size())).measure());
        if (!options.json) printWhole(textOf(scenes.back()));
    }
    if (options.json) printWhole(jsonOf(scenes));
    if (interrupted()) fmt::print(stderr, "eyeray: interrupted: only what had been measured is told\n");
    return 0;
}

}
