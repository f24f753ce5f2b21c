#pragma once
// A film to put samples into, for cases about sums of them.

#include "core/render/film.h"
#include "core/study/stability_trials.h"

namespace eyeray {

inline constexpr int kTilePixels = kTileSize * kTileSize;

/// A film of one tile, or of one pixel, that takes the same sample in each pixel.
class EvenFilm {
public:
    explicit EvenFilm(int side) : film_(side, side) {
        const auto pixels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
        sample_ = {.tile = film_.tile(0), .radiance = {pixels, Color(0)}, .counts = {}, .complete = true};
    }
    TileResult& sample() { return sample_; }
    void add() { film_.add(0, sample_, passes_++); }
    /// Of the values as they are, without a display curve.
    double estimatedError() const { return film_.estimatedError(passes_, {.toneMap = ToneMap::None}); }
    ColorImage mean() const { return film_.mean(passes_); }

private:
    Film film_;
    TileResult sample_;
    int passes_ = 0;
};

/// Of a sample in a film, for each pixel.
inline double filmNanoseconds(const StabilityEffort& effort) {
    EvenFilm film(kTileSize);
    const std::vector<int> passes(64);
    return nanosecondsOf(passes, effort,
                         [&](int) {
                             film.add();
                             return 0;
                         }) /
           kTilePixels;
}

}
