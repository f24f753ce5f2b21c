#include "core/study/layer_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>

namespace eyeray {
namespace {

constexpr int kTileSide = 32;

std::size_t channelsOf(const Layer& layer) { return isVector(layer.quantity) ? 3 : 1; }

bool hasSecond(Quantity quantity) {
    return quantity == Quantity::Normal || quantity == Quantity::Depth || quantity == Quantity::Error;
}

/// The same eye rays and nothing after them: all that layers of the first hit look at.
TraceContext ofFirstHit(TraceContext context) {
    context.settings.maxDepth = 0;
    context.settings.shadows = false;
    return context;
}

/// Microseconds that one sample takes the tracer as it renders.
double costOf(const TraceContext& context, const Integrator& integrator, int x, int y, int pass) {
    const auto start = std::chrono::steady_clock::now();
    integrator.renderTile(context, {x, y, x + 1, y + 1, 1}, pass);
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

}

LayerFilm::LayerFilm(std::vector<Layer> layers, int width, int height)
    : layers_(std::move(layers)), planes_(layers_.size()), width_(width), height_(height) {
    ENSURE(!layers_.empty() && width >= 1 && height >= 1);
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    try {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            planes_[i].sums.assign(channelsOf(layers_[i]) * pixels, 0);
            if (hasSecond(layers_[i].quantity)) planes_[i].second.assign(pixels, 0);
        }
    } catch (const std::bad_alloc&) {
        throw Failure(fmt::format("{} layers of {}x{}", layers_.size(), width, height),
                      "there is not enough memory", "choose a smaller size or fewer layers");
    }
    for (int y = 0; y < height; y += kTileSide)
        for (int x = 0; x < width; x += kTileSide)
            tiles_.push_back({x, y, std::min(x + kTileSide, width), std::min(y + kTileSide, height), 1});
    tilePasses_.assign(tiles_.size(), 0);
}

bool LayerFilm::addPass(const TraceContext& context, const Integrator& integrator, int pass, ThreadPool& pool,
                        const std::stop_token& stop) {
    const bool eyeRaysSuffice = std::all_of(layers_.begin(), layers_.end(),
                                            [](const Layer& layer) { return isOfFirstHit(layer.quantity); });
    const TraceContext traced = eyeRaysSuffice ? ofFirstHit(context) : context;
    std::mutex mutex;
    const bool whole = pool.forEach(static_cast<int>(tiles_.size()), stop, [&](int i) {
        const RayCounts counts = addTile(traced, integrator, static_cast<std::size_t>(i), pass);
        const std::scoped_lock lock(mutex);
        counts_ += counts;
    });
    if (whole) ++passes_;
    return whole;
}

RayCounts LayerFilm::addTile(const TraceContext& context, const Integrator& integrator, std::size_t tile,
                             int pass) {
    const bool first = tilePasses_[tile]++ == 0;
    return integrator.retraceTile(
        context, tiles_[tile], pass, [&](int x, int y, const SampleRecord& record, const Color& radiance) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
            for (std::size_t i = 0; i < layers_.size(); ++i) {
                const Layer& layer = layers_[i];
                std::optional<DVec3> value(DVec3(1)); // of Samples: this one
                if (layer.quantity == Quantity::Cost)
                    value = DVec3(costOf(context, integrator, x, y, pass));
                else if (layer.quantity == Quantity::Error)
                    value = DVec3(luminance(DVec3(radiance)));
                else if (layer.quantity != Quantity::Samples)
                    value = layerValue(layer, record, radiance);
                add(layer, planes_[i], pixel, value, first);
            }
        });
}

void LayerFilm::add(const Layer& layer, Plane& plane, std::size_t pixel, const std::optional<DVec3>& value,
                    bool first) const {
    if (layer.quantity == Quantity::Object) {
        if (first) plane.sums[pixel] = value ? value->x : kNoObject;
        return;
    }
    if (!value) return;
    const std::size_t channels = channelsOf(layer);
    for (std::size_t c = 0; c < channels; ++c)
        plane.sums[channels * pixel + c] += (*value)[static_cast<int>(c)];
    if (layer.quantity == Quantity::Error)
        plane.second[pixel] += value->x * value->x;
    else if (hasSecond(layer.quantity))
        plane.second[pixel] += 1;
}

Color LayerFilm::mean(const Layer& layer, const Plane& plane, std::size_t pixel, int samples) const {
    const double* const sums = &plane.sums[channelsOf(layer) * pixel];
    const double n = samples;
    switch (layer.quantity) {
    case Quantity::Object:
    case Quantity::Samples:
        return Color(static_cast<float>(sums[0]));
    case Quantity::Normal: {
        const double hits = std::max(1.0, plane.second[pixel]);
        return Color(DVec3(sums[0], sums[1], sums[2]) / hits);
    }
    case Quantity::Depth:
        return Color(plane.second[pixel] > 0 ? static_cast<float>(sums[0] / plane.second[pixel]) : kInfinity);
    case Quantity::Error: {
        if (samples < 2) return Color(0);
        const double average = sums[0] / n, variance = plane.second[pixel] / n - average * average;
        return Color(static_cast<float>(std::sqrt(std::max(0.0, variance) / (n - 1))));
    }
    default:
        return channelsOf(layer) == 3 ? Color(DVec3(sums[0], sums[1], sums[2]) / n)
                                      : Color(static_cast<float>(sums[0] / n));
    }
}

LayerImage LayerFilm::image(std::size_t layer) const {
    ENSURE(layer < layers_.size() && passes_ > 0);
    LayerImage result{layers_[layer], passes_, ColorImage(width_, height_)};
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        for (int y = tiles_[i].y0; y < tiles_[i].y1; ++y)
            for (int x = tiles_[i].x0; x < tiles_[i].x1; ++x) {
                const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(x);
                result.values.at(x, y) = mean(layers_[layer], planes_[layer], pixel, tilePasses_[i]);
            }
    return result;
}

}
