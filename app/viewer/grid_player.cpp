#include "app/viewer/grid_player.h"

#include <algorithm>
#include <numeric>

namespace eyeray {

void GridPlayer::begin(const PixelGrid& grid) {
    on_ = true;
    grid_ = grid;
    played_ = 0;
    traced_.clear();
}

std::optional<int> GridPlayer::current() const {
    return on_ && played_ > 0 ? std::optional(played_ - 1) : std::nullopt;
}

std::size_t GridPlayer::rays() const {
    return std::accumulate(traced_.begin(), traced_.end(), std::size_t{0},
                           [](std::size_t sum, const GridPixel& pixel) { return sum + pixel.rays; });
}

std::optional<Retrace> GridPlayer::traceNext(const Trace& trace) {
    const int cell = static_cast<int>(traced_.size());
    if (cell == grid_.cells()) return std::nullopt;
    auto sample = trace(grid_.middleX(cell), grid_.middleY(cell));
    if (sample) traced_.push_back({sample->radiance, sample->rays.size()});
    return sample;
}

/// True if it had to trace and could.
bool GridPlayer::catchUp(const Trace& trace) {
    const std::size_t before = traced_.size();
    while (static_cast<int>(traced_.size()) < played_ && traceNext(trace)) {
    }
    return traced_.size() > before;
}

void GridPlayer::go(PlayTo to, const Trace& trace) {
    if (to == PlayTo::Start) return goTo(0, trace);
    if (to == PlayTo::End) return goTo(grid_.cells(), trace);
    if (to == PlayTo::Back) return goTo(played_ - 1, trace);
    if (to == PlayTo::Next) return goTo(played_ + 1, trace);
    catchUp(trace);
    while (const auto sample = traceNext(trace))
        if (stopsIn(*sample, to)) break;
    played_ = static_cast<int>(traced_.size());
}

void GridPlayer::goTo(int cells, const Trace& trace) {
    played_ = std::clamp(cells, 0, grid_.cells());
    const auto most = std::min(traced_.size(), static_cast<std::size_t>(played_));
    traced_.resize(most);
    catchUp(trace);
}

void GridPlayer::retrace(const PixelGrid& grid, const Trace& trace) {
    grid_ = grid;
    traced_.clear();
    goTo(played_, trace);
}

void GridPlayer::run(bool on, Clock::time_point now) {
    clock_.run(on, now);
    if (on && played_ == grid_.cells()) played_ = 0, traced_.clear();
}

bool GridPlayer::update(const Trace& trace, Clock::time_point now) {
    const int steps = clock_.due(now);
    if (steps > 0) goTo(played_ + steps, trace);
    if (played_ == grid_.cells()) clock_.run(false);
    return catchUp(trace) || steps > 0;
}

}
