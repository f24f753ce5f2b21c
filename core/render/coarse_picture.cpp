#include "core/render/coarse_picture.h"

#include <chrono>
#include <vector>

#include "core/render/film.h"

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFirstStep = 16;          // when nothing is known
constexpr std::size_t kTilesOfOne = 16; // how many tiles one of them speaks for

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double blocksOf(std::size_t tiles, int step) {
    return static_cast<double>(tiles) * kTileSize * kTileSize / (step * step);
}

}

std::optional<int> CoarsePicture::trace(ThreadPool& pool, std::span<const int> tiles, double seconds,
                                        const std::stop_token& stop,
                                        const std::function<void(int tile, int step)>& traceTile) {
    const auto traceAll = [&](std::span<const int> some, int step) {
        if (some.empty()) return true;
        const auto begin = Clock::now();
        const bool whole = pool.forEach(static_cast<int>(some.size()), stop,
                                        [&](int i) { traceTile(some[static_cast<std::size_t>(i)], step); });
        if (!whole || stop.stop_requested()) return false; // its time would say nothing
        secondsPerBlock_ = secondsSince(begin) / blocksOf(some.size(), step);
        return true;
    };
    if (seconds == kInfinity) return traceAll(tiles, kFinestStep) ? std::optional(kFinestStep) : std::nullopt;
    const auto start = Clock::now();
    std::vector<int> few, others;
    for (std::size_t i = 0; i < tiles.size(); ++i) (i % kTilesOfOne == 0 ? few : others).push_back(tiles[i]);
    const int foreseen = stepWithin(seconds, tiles.size());
    if (!traceAll(few, foreseen)) return std::nullopt;
    const double left = seconds - secondsSince(start);
    if (stepWithin(left, others.size()) == foreseen)
        return traceAll(others, foreseen) ? std::optional(foreseen) : std::nullopt;
    const int step = stepWithin(left, tiles.size());
    return traceAll(few, step) && traceAll(others, step) ? std::optional(step) : std::nullopt;
}

int CoarsePicture::stepWithin(double seconds, std::size_t tiles) const {
    if (secondsPerBlock_ < 0) return kFirstStep;
    int step = kFinestStep;
    while (step < kCoarsestStep && secondsPerBlock_ * blocksOf(tiles, step) > seconds) step *= 2;
    return step;
}

}
