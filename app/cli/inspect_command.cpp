#include <fmt/format.h>

#include <cstdio>

#include "app/cli/inspected.h"
#include "app/cli/run.h"
#include "core/base/errors.h"
#include "core/base/thread_pool.h"
#include "core/image/atomic_file.h"
#include "core/study/tree_svg.h"

namespace eyeray {
namespace {

Inspected inspect(const InspectOptions& options) {
    const OpenedScene opened = openFor(options.picture);
    const Document& document = opened.document;
    Inspected result{.reference = opened.reference,
                     .world = nullptr,
                     .settings = document.render,
                     .pixel = options.pixel,
                     .sample = options.sample,
                     .film = Color(0),
                     .trace = {},
                     .ledger = {},
                     .traversal = {}};
    RenderSettings& settings = result.settings;
    setSize(settings, options.picture, document.aspect);
    const auto [x, y] = options.pixel;
    if (x >= settings.width || y >= settings.height)
        throw InputError(
            fmt::format("--pixel {},{}", x, y),
            fmt::format("outside the picture of {}x{}", settings.width, settings.height),
            fmt::format("give X from 0 to {} and Y from 0 to {}", settings.width - 1, settings.height - 1));
    result.world = buildWorld(document.scene, buildSettings(document));
    const TraceContext context(result.world, document.camera, settings.trace, settings.width, settings.height,
                               settings.seed, {});
    const auto integrator = makeIntegrator(settings.trace.method);
    const int pass = options.picture.firstPass + options.sample;
    const FloatEnvironment environment;
    result.film = integrator->renderTile(context, {x, y, x + 1, y + 1}, pass).radiance.front();
    result.trace = integrator->retrace(context, x, y, pass);
    result.ledger = ledgerOf(result.trace);
    for (std::size_t i = 0; i < result.trace.rays.size(); ++i)
        result.traversal.push_back(
            traversalOf(*result.world, context.settings, result.trace, static_cast<int>(i)));
    return result;
}

std::string svgOf(const Inspected& inspected, float leastWeight) {
    TreeFilter filter;
    filter.leastWeight = leastWeight;
    return svgOf(diagramOf(inspected.trace, *inspected.world->scene, filter), inspected.title(),
                 inspected.settings.display, false);
}

std::string told(const Inspected& inspected, const InspectOptions& options) {
    switch (options.format) {
    case InspectFormat::Text:
        return textOf(inspected);
    case InspectFormat::Json:
        return jsonOf(inspected);
    case InspectFormat::Csv:
        return csvOf(inspected);
    case InspectFormat::Svg:
        return svgOf(inspected, options.leastWeight);
    }
    return {};
}

}

std::string Inspected::title() const {
    return fmt::format("pixel ({}, {}) of {}, {}×{}, sample {}", pixel.x, pixel.y, reference, settings.width,
                       settings.height, sample);
}

int run(const InspectOptions& options) {
    if (options.output) checkFolder(*options.output);
    const std::string text = told(inspect(options), options);
    if (options.output) {
        writeFileAtomically(*options.output, std::as_bytes(std::span(text)));
        return 0;
    }
    const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!whole || std::fflush(stdout) != 0)
        throw Failure("standard output", "cannot be written", "see that there is room, or use -o FILE");
    return 0;
}

}
