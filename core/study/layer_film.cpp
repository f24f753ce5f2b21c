#include "core/study/layer_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>

#include "core/study/ray_traversal.h"

namespace eyeray {
namespace {

constexpr int kTileSide = 32;

std::size_t channelCount(const Layer& layer) { return isVector(layer.quantity) ? 3 : 1; }

bool hasSecond(Quantity quantity) {
    return quantity == Quantity::Normal || quantity == Quantity::Depth || quantity == Quantity::Error;
}

/// The same eye rays and nothing after them: all that layers of the first hit look at.
TraceContext ofFirstHit(TraceContext context) {
    context.settings.maxDepth = 0;
    context.settings.shadows = false;
    return context;
}

/// Microseconds that one sample takes the tracer as it renders: the lesser of two times, for now and then
/// the machine does something else meanwhile.
double costOf(const TraceContext& context, const Integrator& integrator, int x, int y, int pass) {
    const auto once = [&] {
        const auto start = std::chrono::steady_clock::now();
        integrator.renderTile(context, {x, y, x + 1, y + 1, 1}, pass);
        return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    };
    return std::min(once(), once());
}

DVec3 workOf(Quantity quantity, const TraversalCounts& counts) {
    return DVec3(static_cast<double>(quantity == Quantity::Visits ? counts.nodes : counts.primitives));
}

}

LayerFilm::LayerFilm(std::vector<Layer> layers, int width, int height)
    : layers_(std::move(layers)), width_(width), height_(height), planes_(layers_.size()) {
    ENSURE(!layers_.empty() && width >= 1 && height >= 1);
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    try {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            planes_[i].sums.assign(channelCount(layers_[i]) * pixels, 0);
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

bool LayerFilm::addPass(const TraceContext& context, const Integrator& integrator, int pass,
                        ThreadPool& pool) {
    const bool eyeRaysSuffice = std::all_of(layers_.begin(), layers_.end(),
                                            [](const Layer& layer) { return isOfFirstHit(layer.quantity); });
    const bool ofIndex = std::any_of(layers_.begin(), layers_.end(),
                                     [](const Layer& layer) { return isOfIndex(layer.quantity); });
    const TraceContext traced = eyeRaysSuffice ? ofFirstHit(context) : context;
    const bool whole = pool.forEach(static_cast<int>(tiles_.size()), context.stop, [&](int i) {
        const auto tile = static_cast<std::size_t>(i);
        std::vector<Value> values; // of each pixel and layer
        const auto counts = integrator.retraceTile(
            traced, tiles_[tile], pass, [&](int x, int y, const SampleRecord& record, const Color& radiance) {
                const TraversalCounts work =
                    ofIndex ? traversalOf(*traced.world, traced.settings, record) : TraversalCounts{};
                for (const Layer& layer : layers_)
                    values.push_back(layer.quantity == Quantity::Cost
                                         ? DVec3(costOf(traced, integrator, x, y, pass))
                                     : isOfIndex(layer.quantity) ? workOf(layer.quantity, work)
                                                                 : layerValue(layer, record, radiance));
            });
        if (counts) addTile(tile, values, *counts);
    });
    if (!whole || context.stop.stop_requested()) return false;
    const std::scoped_lock lock(mutex_);
    ++passes_;
    return true;
}

void LayerFilm::addTile(std::size_t tile, const std::vector<Value>& values, const RayCounts& counts) {
    const std::scoped_lock lock(mutex_);
    const bool first = tilePasses_[tile]++ == 0;
    counts_ += counts;
    std::size_t next = 0;
    for (int y = tiles_[tile].y0; y < tiles_[tile].y1; ++y)
        for (int x = tiles_[tile].x0; x < tiles_[tile].x1; ++x)
            for (std::size_t i = 0; i < layers_.size(); ++i)
                add(layers_[i], planes_[i], index(x, y), values[next++], first);
}

void LayerFilm::add(const Layer& layer, Plane& plane, std::size_t pixel, const std::optional<DVec3>& value,
                    bool first) const {
    if (layer.quantity == Quantity::Object) {
        if (first) plane.sums[pixel] = value ? value->x : kNoObject;
        return;
    }
    if (!value) return;
    const std::size_t channels = channelCount(layer);
    for (std::size_t c = 0; c < channels; ++c)
        plane.sums[channels * pixel + c] += (*value)[static_cast<int>(c)];
    if (layer.quantity == Quantity::Error)
        plane.second[pixel] += value->x * value->x;
    else if (hasSecond(layer.quantity))
        plane.second[pixel] += 1;
}

Color LayerFilm::mean(const Layer& layer, const Plane& plane, std::size_t pixel, int samples) const {
    const double* const sums = &plane.sums[channelCount(layer) * pixel];
    const double n = std::max(1, samples);
    switch (layer.quantity) {
    case Quantity::Object:
        return Color(static_cast<float>(samples > 0 ? sums[0] : kNoObject));
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
        return channelCount(layer) == 3 ? Color(DVec3(sums[0], sums[1], sums[2]) / n)
                                        : Color(static_cast<float>(sums[0] / n));
    }
}

LayerImage LayerFilm::image(std::size_t layer) const {
    ENSURE(layer < layers_.size());
    LayerImage result{layers_[layer], 0, ColorImage(width_, height_)};
    const std::scoped_lock lock(mutex_);
    result.samples = passes_;
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        for (int y = tiles_[i].y0; y < tiles_[i].y1; ++y)
            for (int x = tiles_[i].x0; x < tiles_[i].x1; ++x)
                result.values.at(x, y) = mean(layers_[layer], planes_[layer], index(x, y), tilePasses_[i]);
    return result;
}

int LayerFilm::passes() const {
    const std::scoped_lock lock(mutex_);
    return passes_;
}

RayCounts LayerFilm::counts() const {
    const std::scoped_lock lock(mutex_);
    return counts_;
}

void traceLayers(LayerFilm& film, const std::shared_ptr<const World>& world, const Camera& camera,
                 const RenderSettings& settings, int threads, const std::stop_token& stop) {
    lowerThreadPriority();
    ThreadPool pool(threads);
    const auto integrator = makeIntegrator(settings.trace.method);
    const TraceContext context(world, camera, settings.trace, settings.width, settings.height, settings.seed,
                               stop);
    for (int pass = 0; pass < settings.stop.samples; ++pass)
        if (!film.addPass(context, *integrator, settings.firstPass + pass, pool)) return;
}

}
