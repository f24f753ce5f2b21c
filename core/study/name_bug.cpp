#include "core/study/name_bug.h"

#include <algorithm>
#include <cmath>

#include "core/image/metrics.h"
#include "core/render/film.h"

namespace eyeray {
namespace {

constexpr int kNoisySamples = 16; // of methods that scatter; others need the one through the pixel's centre

/// What the screen shows of the scene under the settings; empty if `stop` was requested.
ByteImage rendered(const std::shared_ptr<const World>& world, const Camera& camera,
                   const RenderSettings& settings, ThreadPool& pool, const std::stop_token& stop) {
    const TraceContext context(world, camera, settings.trace, settings.width, settings.height, settings.seed,
                               stop);
    const auto integrator = makeIntegrator(settings.trace.method);
    Film film(settings.width, settings.height);
    film.reset(settings.trace.faults.has(Fault::EightBit));
    const int samples = isPhysical(settings.trace.method) ? kNoisySamples : 1;
    for (int pass = 0; pass < samples; ++pass) {
        const bool whole = pool.forEach(film.tiles(), stop, [&](int tile) {
            const TileResult result = integrator->renderTile(context, film.tile(tile), pass);
            if (result.complete) film.add(tile, result, pass);
        });
        if (!whole || stop.stop_requested()) return {};
    }
    return display(film.mean(samples), shownDisplay(settings));
}

FaultMatch matchOf(FaultSet faults, const ByteImage& ours, const ByteImage& theirs) {
    FaultMatch match{.faults = faults};
    double squares = 0;
    for (std::size_t i = 0; i < ours.values().size(); ++i) {
        const Rgba8 &a = ours.values()[i], &b = theirs.values()[i];
        for (const int difference : {a.r - b.r, a.g - b.g, a.b - b.b}) squares += difference * difference;
        match.differing += clearlyDiffers(a, b) ? 1 : 0;
    }
    match.rmse = std::sqrt(squares / (3.0 * static_cast<double>(ours.values().size()))) / 255;
    return match;
}

/// Whether a colour is none that lies between those of the pixel and its neighbours, as at a smoothed edge.
bool standsOut(const ByteImage& right, int x, int y, const Rgba8& color) {
    Rgba8 least{255, 255, 255, 255}, most{0, 0, 0, 255};
    for (int j = std::max(0, y - 1); j <= std::min(y + 1, right.height() - 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(x + 1, right.width() - 1); ++i) {
            const Rgba8& near = right.at(i, j);
            least = {std::min(least.r, near.r), std::min(least.g, near.g), std::min(least.b, near.b), 255};
            most = {std::max(most.r, near.r), std::max(most.g, near.g), std::max(most.b, near.b), 255};
        }
    const Rgba8 within{std::clamp(color.r, least.r, most.r), std::clamp(color.g, least.g, most.g),
                       std::clamp(color.b, least.b, most.b), color.a};
    return clearlyDiffers(within, color);
}

std::optional<WrongPixel> firstWrong(const ByteImage& right, const ByteImage& picture) {
    for (int y = 0; y < right.height(); ++y)
        for (int x = 0; x < right.width(); ++x)
            if (standsOut(right, x, y, picture.at(x, y))) return WrongPixel{x, y};
    return std::nullopt;
}

}

std::optional<NamedBug> nameBug(const std::shared_ptr<const World>& world, const Camera& camera,
                                RenderSettings settings, const ByteImage& picture, ThreadPool& pool,
                                const std::stop_token& stop) {
    settings.width = picture.width();
    settings.height = picture.height();
    NamedBug bug{.ranked = {}, .pixels = picture.values().size(), .firstWrong = {}};
    for (int i = -1; i < kFaults; ++i) {
        settings.trace.faults = i < 0 ? FaultSet() : FaultSet(static_cast<Fault>(i));
        const ByteImage shown = rendered(world, camera, settings, pool, stop);
        if (shown.empty()) return std::nullopt;
        if (i < 0) bug.firstWrong = firstWrong(shown, picture);
        const FaultMatch match = matchOf(settings.trace.faults, shown, picture);
        const auto worse =
            std::upper_bound(bug.ranked.begin(), bug.ranked.end(), match,
                             [](const FaultMatch& a, const FaultMatch& b) { return a.rmse < b.rmse; });
        bug.ranked.insert(worse, match);
    }
    return bug;
}

}
