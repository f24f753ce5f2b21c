#include <fmt/format.h>

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

std::string lineOf(const BenchedScene& scene, std::size_t index, int threads) {
    const World& world = *scene.indices[index].world;
    std::string line =
        fmt::format("{:<8}{:>8}", kAccelNames[static_cast<std::size_t>(world.accelKind)], threads);
    bool any = false;
    for (const RayKind kind : kColumns) {
        std::string cell = "-";
        for (const BenchFigure& f : scene.figures)
            if (f.index == index && f.threads == threads && f.kind == kind) {
                cell = speedOf(f);
                any = true;
            }
        line += fmt::format("{:>15}", cell);
    }
    if (!any) return {};
    return line + fmt::format("{:>11.1f}{:>10.1f}\n", scene.indices[index].buildSeconds * 1e3,
                              static_cast<double>(world.bytes) /
                                  static_cast<double>(std::max<std::size_t>(1, world.primitives)));
}

nlohmann::json jsonOf(const BenchedScene& scene, const BenchFigure& figure) {
    const BenchedIndex& index = scene.indices[figure.index];
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
              {"build", index.buildSeconds},
              {"first_image", seconds},
              {"render", seconds},
              {"spread", figure.seconds.spread}}},
            {"rays", rays},
            {"hits", figure.hits},
            {"mrays_per_second", figure.mraysPerSecond()},
            {"accelerator", acceleratorFigures(*index.world)},
            {"invalid_samples", 0},
            {"peak_rss_bytes", peakRssBytes()}};
}

}

std::string textOf(const BenchedScene& scene) {
    std::string text =
        fmt::format("{}: {} primitives, Mrays/s (median and spread of rounds in turn)\n{:<8}{:>8}",
                    scene.reference, scene.indices.front().world->primitives, "index", "threads");
    for (const RayKind kind : kColumns) text += fmt::format("{:>15}", name(kind));
    text += fmt::format("{:>11}{:>10}\n", "build ms", "B/prim.");
    for (std::size_t index = 0; index < scene.indices.size(); ++index) {
        int last = 0;
        for (const BenchFigure& figure : scene.figures) {
            if (figure.threads <= last) continue;
            last = figure.threads;
            text += lineOf(scene, index, last);
        }
    }
    return text + "\n";
}

std::string jsonOf(const std::vector<BenchedScene>& scenes) {
    nlohmann::json list = nlohmann::json::array();
    for (const BenchedScene& scene : scenes)
        for (const BenchFigure& figure : scene.figures) list.push_back(jsonOf(scene, figure));
    return list.dump(2) + "\n";
}

}
