#pragma once
// One picture, pass after pass on the caller's time: for measuring.

#include <memory>
#include <optional>
#include <stop_token>

#include "core/base/thread_pool.h"
#include "core/render/film.h"
#include "core/transport/integrator.h"

namespace eyeray {

/// Tiles of a picture side by side in a smaller one: its tile i shows what tiles[i] of the picture does.
struct Mosaic {
    int width = 0, height = 0; // pixels
    std::vector<Tile> tiles;
};

/// Spread evenly over a picture, no more than `across` in a row and as many rows as have its shape; the whole
/// picture if it has no more tiles.
Mosaic mosaicOf(int width, int height, int across);

class PassLoop {
public:
    /// The context's own stop is not heeded.
    PassLoop(std::shared_ptr<const Integrator>, const TraceContext&, ThreadPool&);
    /// Of a mosaic of the context's picture.
    PassLoop(std::shared_ptr<const Integrator>, const TraceContext&, ThreadPool&, Mosaic);

    /// From the first pass on, pixels end as core/render/adaptive.h says.
    void sampleAdaptively(double error, const DisplaySettings&);

    /// Traces one sample more of every pixel that has not ended. False, and nothing is added, if it is broken
    /// off: because tracing has taken `limitSeconds` in all, or by `stop`.
    bool pass(double limitSeconds, const std::stop_token& stop);

    int passes() const { return passes_; }
    /// On average.
    double samplesPerPixel() const {
        return static_cast<double>(counts_[RayKind::Eye]) /
               (static_cast<double>(film_.width()) * film_.height());
    }
    /// Spent tracing.
    double seconds() const { return seconds_; }
    /// What the threads have worked on it: whatever else the machine has to do, this stays the same.
    double threadSeconds() const { return threadSeconds_; }
    const RayCounts& counts() const { return counts_; }
    /// Mean over the passes; there is at least one.
    ColorImage picture() const { return film_.mean(passes_); }
    /// As Film::estimatedError; there are at least two passes.
    double estimatedError(const DisplaySettings& display) const {
        return film_.estimatedError(passes_, display);
    }
    /// As eyeray::likelySamples; there are at least two passes.
    std::vector<int> likelySamples(double error, const DisplaySettings&, int most) const;

private:
    struct AdaptiveGoal {
        double error;
        DisplaySettings display;
    };
    std::optional<AdaptiveGoal> goal_;
    std::shared_ptr<const Integrator> integrator_;
    TraceContext context_;
    ThreadPool& pool_;
    std::vector<Tile> tiles_; // of the picture, by tile of the film
    Film film_;
    int passes_ = 0;
    double seconds_ = 0, threadSeconds_ = 0;
    RayCounts counts_;
};

}
