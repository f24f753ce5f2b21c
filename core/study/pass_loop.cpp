#include "core/study/pass_loop.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/render/adaptive.h"

namespace eyeray {
namespace {

/// Of the calling thread.
double workedSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}

Mosaic mosaicOf(int width, int height, int across) {
    const auto tilesIn = [](int side) { return (side + kTileSize - 1) / kTileSize; };
    const int columns = tilesIn(width), rows = tilesIn(height);
    Mosaic mosaic{width, height, {}};
    int wide = columns, high = rows;
    if (columns > across) {
        wide = across;
        // whole tiles alone, which fill the mosaic without gaps
        high = std::clamp(static_cast<int>(std::lround(static_cast<double>(across) * rows / columns)), 1,
                          std::max(1, height / kTileSize));
        mosaic.width = wide * kTileSize;
        mosaic.height = high * std::min(kTileSize, height);
    }
    const auto place = [](int i, int count, int of) { return (2 * i + 1) * of / (2 * count) * kTileSize; };
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            const int x0 = place(x, wide, wide < columns ? width / kTileSize : columns);
            const int y0 = place(y, high, wide < columns ? std::max(1, height / kTileSize) : rows);
            mosaic.tiles.push_back(
                {x0, y0, std::min(x0 + kTileSize, width), std::min(y0 + kTileSize, height)});
        }
    return mosaic;
}

PassLoop::PassLoop(std::shared_ptr<const Integrator> integrator, const TraceContext& context,
                   ThreadPool& pool)
    : PassLoop(std::move(integrator), context, pool, mosaicOf(context.width, context.height, context.width)) {
}

PassLoop::PassLoop(std::shared_ptr<const Integrator> integrator, const TraceContext& context,
                   ThreadPool& pool, Mosaic mosaic)
    : integrator_(std::move(integrator)), context_(context), pool_(pool), tiles_(std::move(mosaic.tiles)),
      film_(mosaic.width, mosaic.height) {}

void PassLoop::sampleAdaptively(double error, const DisplaySettings& display) {
    ENSURE(passes_ == 0);
    goal_ = {error, display};
}

std::vector<int> PassLoop::likelySamples(double error, const DisplaySettings& display, int most) const {
    return eyeray::likelySamples(film_, passes_, error, display, most);
}

bool PassLoop::pass(double limitSeconds, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [&] {
        return seconds_ + std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::stop_source broken;
    const std::stop_callback forward(stop, [&] { broken.request_stop(); });
    context_.stop = broken.get_token();
    std::vector<TileResult> results(static_cast<std::size_t>(film_.tiles()));
    std::vector<double> worked(results.size());
    const bool started = pool_.forEach(film_.tiles(), context_.stop, [&](int i) {
        if (elapsed() > limitSeconds) broken.request_stop();
        const auto tile = static_cast<std::size_t>(i);
        const double before = workedSeconds();
        const std::vector<std::uint8_t> wanted = film_.wanted(i, passes_);
        Tile traced = tiles_[tile];
        traced.wanted = wanted;
        results[tile] = integrator_->renderTile(context_, traced, passes_);
        results[tile].tile = film_.tile(i);
        worked[tile] = workedSeconds() - before;
    });
    threadSeconds_ += std::accumulate(worked.begin(), worked.end(), 0.0);
    seconds_ = elapsed();
    if (!started || broken.stop_requested()) return false;
    for (int i = 0; i < film_.tiles(); ++i) {
        const TileResult& result = results[static_cast<std::size_t>(i)];
        film_.add(i, result, passes_);
        counts_ += result.counts;
    }
    ++passes_;
    if (goal_ && isAdaptiveStage(passes_)) decideSamples(film_, passes_, goal_->error, goal_->display);
    return true;
}

}
