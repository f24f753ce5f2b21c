// eyeray_rays_bench [NAME]: millions of rays a second on one thread by index and kind of ray, beside Embree,
// which is asked in turn with the same rays; building time, memory, and how often the answers differ. NAME:
// part of a mesh's name.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "core/base/thread_pool.h"
#include "tests/bench/rays/embree.h"
#include "tests/bench/rays/packets.h"
#include "tests/bench/rays/rays.h"

namespace eyeray::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kRounds = 9;

double secondsOf(const std::function<void()>& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Answers of one tracer to one set of rays: t of the closest hit, or 1 and 0.
using Answers = std::vector<float>;

/// Rays as single ones, and in the columns that packets are taken from.
struct Rays {
    explicit Rays(RaySet rays) : set(std::move(rays)), columns(set.rays) {}

    RaySet set;
    RayColumns columns;
};

struct Tracer {
    std::string name;
    std::function<void(const Rays&, Answers&)> trace;
    double buildSeconds = 0;
    std::size_t bytes = 0; // 0: not of its own
};

template <class Index>
void traceSingly(const IndexedGeometry<Index>& scene, const RaySet& set, Answers& answers) {
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        if (set.anyHit) {
            answers[i] = anyHit(scene, set.rays[i]) ? 1.0F : 0.0F;
        } else {
            const auto hit = closestHit(scene, set.rays[i]);
            answers[i] = hit ? hit->t : kInfinity;
        }
    }
}

template <class Index>
Tracer ours(std::string name, const TestMesh& test) {
    auto scene = std::make_shared<IndexedGeometry<Index>>();
    const double seconds = secondsOf([&] {
        *scene = indexInstances<Index>({{.placement = {}, .geometry = indexMesh<Index>(test.mesh, {})}}, {});
    });
    const auto trace = [scene](const Rays& rays, Answers& answers) {
        traceSingly(*scene, rays.set, answers);
    };
    return {std::move(name), trace, seconds, scene->bytes};
}

Tracer inPackets(const TestMesh& test) {
    auto scene = std::make_shared<const IndexedGeometry<Bvh8>>(
        indexInstances<Bvh8>({{.placement = {}, .geometry = indexMesh<Bvh8>(test.mesh, {})}}, {}));
    const auto trace = [scene](const Rays& rays, Answers& answers) {
        if (rays.set.anyHit)
            traceSingly(*scene, rays.set, answers); // as streams do
        else
            tracePackets(*scene, rays.columns, answers);
    };
    return {.name = "bvh8, packets", .trace = trace};
}

Tracer embreePackets(const TestMesh& test) {
    auto scene = std::make_shared<const EmbreeScene>(*test.mesh, false);
    const auto trace = [scene](const Rays& rays, Answers& answers) {
        rays.set.anyHit ? scene->any(rays.columns, answers) : scene->closest(rays.columns, answers);
    };
    return {.name = "Embree, packets", .trace = trace};
}

Tracer embree(std::string name, const TestMesh& test, bool robust) {
    auto scene = std::make_shared<EmbreeScene>(*test.mesh, robust);
    const auto trace = [scene](const Rays& rays, Answers& answers) {
        const RaySet& set = rays.set;
        for (std::size_t i = 0; i < set.rays.size(); ++i)
            answers[i] = set.anyHit ? (scene->any(set.rays[i]) ? 1.0F : 0.0F) : scene->closest(set.rays[i]);
    };
    return {std::move(name), trace, scene->buildSeconds(), scene->bytes()};
}

// Another hit, or t that differs by more than a few roundings.
std::size_t differences(const Answers& a, const Answers& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && !(std::fabs(a[i] - b[i]) <= 1e-4F * std::fabs(a[i]))) ++count;
    return count;
}

void compare(const TestMesh& test) {
    const auto triangles = static_cast<double>(test.mesh->triangles.size());
    const std::vector<Tracer> tracers{ours<Bvh2>("bvh2", test),
                                      ours<Bvh8>("bvh8", test),
                                      embree("Embree", test, false),
                                      embree("Embree robust", test, true),
                                      inPackets(test),
                                      embreePackets(test)};
    const std::vector<RaySet> sets = raysFor(test);
    fmt::print("\n{:<20}{:>10}{:>10}{:>10}{:>10}{:>11}{:>9}\n", test.name, "eye", "shadow", "mirror",
               "diffuse", "build ms", "B/tri");
    std::vector<std::vector<double>> speeds(tracers.size());
    std::vector<std::vector<std::size_t>> differ(tracers.size());
    for (const RaySet& set : sets) {
        const Rays rays(set);
        std::vector<Answers> answers(tracers.size(), Answers(set.rays.size()));
        std::vector<std::vector<double>> seconds(tracers.size());
        for (int round = 0; round < kRounds; ++round)
            for (std::size_t i = 0; i < tracers.size(); ++i)
                seconds[i].push_back(secondsOf([&] { tracers[i].trace(rays, answers[i]); }));
        for (std::size_t i = 0; i < tracers.size(); ++i) {
            speeds[i].push_back(static_cast<double>(set.rays.size()) * 1e-6 / seriesOf(seconds[i]).median);
            differ[i].push_back(differences(answers[i], answers[1]));
        }
    }
    for (std::size_t i = 0; i < tracers.size(); ++i) {
        fmt::print("{:<20}", tracers[i].name);
        for (const double speed : speeds[i]) fmt::print("{:>10.2f}", speed);
        if (tracers[i].bytes > 0)
            fmt::print("{:>11.1f}{:>9.1f}", tracers[i].buildSeconds * 1e3,
                       static_cast<double>(tracers[i].bytes) / triangles);
        fmt::print("\n");
    }
    fmt::print("{:<20}", "bvh8 / Embree");
    for (std::size_t k = 0; k < sets.size(); ++k) fmt::print("{:>10.2f}", speeds[1][k] / speeds[2][k]);
    fmt::print("\n{:<20}", "the same of packets");
    for (std::size_t k = 0; k < sets.size(); ++k) fmt::print("{:>10.2f}", speeds[4][k] / speeds[5][k]);
    const Accel accel =
        indexInstances<Bvh8>({{.placement = {}, .geometry = indexMesh<Bvh8>(test.mesh, {})}}, {});
    std::vector<TraversalCounts> counts(sets.size());
    for (std::size_t k = 0; k < sets.size(); ++k) counts[k] = countTraversal(accel, sets[k]);
    const auto perRay = [&](std::size_t k, std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(sets[k].rays.size());
    };
    fmt::print("\n{:<20}", "nodes a ray");
    for (std::size_t k = 0; k < sets.size(); ++k) fmt::print("{:>10.1f}", perRay(k, counts[k].nodes));
    fmt::print("\n{:<20}", "triangles a ray");
    for (std::size_t k = 0; k < sets.size(); ++k) fmt::print("{:>10.1f}", perRay(k, counts[k].primitives));
    fmt::print("\n{:<20}", "differ from Embree");
    for (const std::size_t count : differ[2]) fmt::print("{:>10}", count);
    fmt::print("\n{:<20}", "of rays");
    for (const RaySet& set : sets) fmt::print("{:>10}", set.rays.size());
    fmt::print("\n");
}

}
}

int main(int argc, char** argv) {
    const std::string_view part = argc > 1 ? argv[1] : "";
    const eyeray::FloatEnvironment environment;
    fmt::print("Mrays/s on one thread, medians of {} rounds in turn\n", eyeray::bench::kRounds);
    for (const eyeray::bench::TestMesh& test : eyeray::bench::testMeshes())
        if (test.name.find(part) != std::string::npos) eyeray::bench::compare(test);
    return 0;
}
