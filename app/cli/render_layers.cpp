#include <chrono>
#include <future>

#include <fmt/format.h>

#include "app/cli/interruption.h"
#include "app/cli/render_job.h"
#include "core/base/errors.h"
#include "core/study/layer_picture.h"

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kProgressInterval = std::chrono::milliseconds(50);

bool wantsAll(const RenderOptions& options) { return options.layer == kAllLayers; }

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

RenderStatus statusOf(const LayerFilm& film, Clock::time_point start) {
    RenderStatus status;
    status.samples = film.passes();
    status.seconds = secondsSince(start);
    status.counts = film.counts();
    return status;
}

/// Traces until done, interrupted or out of time.
RenderStatus trace(LayerFilm& film, const RenderJob& job, bool progress) {
    const StopSettings& limits = job.settings.stop;
    const auto start = Clock::now();
    std::stop_source stop;
    auto tracing = std::async(std::launch::async, [&] {
        traceLayers(film, job.world, job.document.camera, job.settings, job.document.threads,
                    stop.get_token());
    });
    double firstPass = 0;
    while (tracing.wait_for(kProgressInterval) != std::future_status::ready) {
        const RenderStatus status = statusOf(film, start);
        if (firstPass == 0 && status.samples > 0) firstPass = status.seconds;
        const bool late = limits.seconds > 0 && status.samples > 0 && status.seconds >= limits.seconds;
        if (interrupted() || late) stop.request_stop();
        if (progress) showProgress(status, limits);
    }
    if (progress) endProgress();
    tracing.get();
    RenderStatus status = statusOf(film, start);
    status.secondsToFirstPass = firstPass > 0 ? firstPass : status.seconds;
    status.threads = ThreadPool(job.document.threads).threads();
    return status;
}

}

std::vector<Layer> layersFor(const RenderJob& job, const RenderOptions& options) {
    std::vector<Layer> layers;
    if (wantsAll(options)) {
        layers = layersOf(*job.document.scene);
        if (formatOf(options.output) != ImageFormat::Exr)
            throw InputError(options.output.string(), "only an .exr file can hold all layers",
                             "end the name in .exr, or ask for one layer");
    } else if (const Layer layer = shownLayer(job.document); layer.quantity != Quantity::Picture) {
        checkLayerFile(options.output, layer);
        layers = {layer};
    }
    if (!layers.empty() && !isSampleMap(layers) && job.settings.stop.error > 0)
        throw InputError("--error", "only the picture itself and its samples stop by the error",
                         "give --samples or --seconds with --layer");
    return layers;
}

bool isSampleMap(const std::vector<Layer>& layers) {
    return layers.size() == 1 && layers.front().quantity == Quantity::Samples;
}

void writeOneLayer(const RenderJob& job, const RenderOptions& options, const LayerImage& image) {
    writeLayer(options.output, image, shownDisplay(job.document.render), stateOf(job));
    if (hasRange(image.layer.quantity) && !holdsRadiance(formatOf(options.output)))
        fmt::print(stderr, "eyeray: {}\n", rangeText(image, rangeOf(image)));
}

std::optional<RenderStatus> renderLayers(RenderJob& job, const RenderOptions& options,
                                         const std::vector<Layer>& layers) {
    const bool meters = job.opened.meterExposure && layers.front().quantity != Quantity::Picture;
    std::vector<Layer> traced = layers;
    if (meters) traced.push_back(layersOf(*job.document.scene).front()); // the picture, to meter by
    LayerFilm film(traced, job.settings.width, job.settings.height);
    RenderStatus status = trace(film, job, showsProgress(options));
    if (status.samples < 1) return std::nullopt;

    std::vector<LayerImage> images;
    images.reserve(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) images.push_back(film.image(i));
    meterExposure(job, meters ? film.image(layers.size()).values : images.front().values);
    if (wantsAll(options)) {
        writeLayers(options.output, images, stateOf(job));
        return status;
    }
    writeOneLayer(job, options, images.front());
    return status;
}

}
