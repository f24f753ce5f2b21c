#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/bench.h"
#include "app/cli/figures.h"

namespace eyeray {
namespace {

constexpr std::array kColumns = {RayKind::Eye, RayKind::Shadow, RayKind::Reflection, RayKind::Diffuse};

std::string speedOf(const BenchFigure& figure) {
    const double relative = figure.seconds.spread / figure.seconds.median;
    return fmt::format("{:.2f} ±{:2.0f}%", figure.mraysPerSecond(), 100 * relative);
}

double perRay(const BenchFigure& figure, std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(figure.counted);
}

std::string workOf(const BenchFigure& figure) {
    return fmt::format("{:.1f} + {:.1f}", perRay(figure, figure.counts.nodes),
                       perRay(figure, figure.counts.primitives));
}

/// A cell for each kind of rays; empty if no figure has this index and number of threads.
std::string cellsOf(const BenchedScene& scene, std::size_t index, int threads,
                    std::string (*cell)(const BenchFigure&)) {
    std::string cells;
    bool any = false;
    for (const RayKind kind : kColumns) {
        const auto figure = std::ranges::find_if(scene.figures, [&](const BenchFigure& f) {
            return f.index == index && f.threads == threads && f.kind == kind;
        });
        any |= figure != scene.figures.end();
        cells += fmt::format("{:>15}", figure != scene.figures.end() ? cell(*figure) : "-");
    }
    return any ? cells : "";
}

/// A line for each number of threads, and one for the work that a ray makes.
std::string linesOf(const BenchedScene& scene, std::size_t index) {
    const World& world = *scene.indices[index];
    const std::size_t primitives = std::max<std::size_t>(1, world.primitives);
    std::string lines;
    int last = 0;
    for (const BenchFigure& figure : scene.figures) { // by ascending numbers of threads
        if (figure.threads <= last) continue;
        last = figure.threads;
        lines += fmt::format("{:<8}{:>8}{}{:>11.1f}{:>10.1f}\n",
                             kAccelNames[static_cast<std::size_t>(world.accelKind)], last,
                             cellsOf(scene, index, last, speedOf), world.buildSeconds * 1e3,
                             static_cast<double>(world.bytes) / static_cast<double>(primitives));
    }
    if (last == 0) return {};
    return lines +
           fmt::format("  nodes + tests {}\n", cellsOf(scene, index, scene.figures.front().threads, workOf));
}

nlohmann::json jsonOf(const BenchedScene& scene, const BenchFigure& figure) {
    const World& world = *scene.indices[figure.index];
    nlohmann::json rays;
    for (const std::string_view kind : kRayKindNames)
        rays[std::string(kind)] = kind == name(figure.kind) ? figure.rays : 0;
    const double seconds = figure.seconds.median;
    return {{"scene", scene.reference},
            {"width", scene.side},
            {"height", scene.side},
            {"samples", 1},
            {"threads", figure.threads},
            {"method", "rays"},
            {"kind", name(figure.kind)},
            {"seconds",
             {{"load", scene.loadSeconds},
              {"build", world.buildSeconds},
              {"first_image", seconds},
              {"render", seconds},
              {"spread", figure.seconds.spread}}},
            {"rays", rays},
            {"hits", figure.hits},
            {"per_ray",
             {{"nodes", perRay(figure, figure.counts.nodes)},
              {"boxes", perRay(figure, figure.counts.boxes)},
              {"primitives", perRay(figure, figure.counts.primitives)}}},
            {"mrays_per_second", figure.mraysPerSecond()},
            {"accelerator", acceleratorFigures(world)},
            {"invalid_samples", 0},
            {"peak_rss_bytes", peakRssBytes()}};
}

}

std::string textOf(const BenchedScene& scene) {
    std::string text =
        fmt::format("{}: {} primitives, Mrays/s (median and spread of rounds in turn); nodes and primitives "
                    "tested a ray\n{:<8}{:>8}",
                    scene.reference, scene.indices.front()->primitives, "index", "threads");
    for (const RayKind kind : kColumns) text += fmt::format("{:>15}", name(kind));
    text += fmt::format("{:>11}{:>10}\n", "build ms", "B/prim.");
    for (std::size_t index = 0; index < scene.indices.size(); ++index) text += linesOf(scene, index);
    return text + "\n";
}

std::string jsonOf(const std::vector<BenchedScene>& scenes) {
    nlohmann::json list = nlohmann::json::array();
    for (const BenchedScene& scene : scenes)
        for (const BenchFigure& figure : scene.figures) list.push_back(jsonOf(scene, figure));
    return list.dump(2) + "\n";
}

}
