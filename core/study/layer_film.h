#pragma once
// Layers of one picture, pass by pass.

#include <mutex>
#include <vector>

#include "core/base/thread_pool.h"
#include "core/image/pixels.h"
#include "core/render/render_settings.h"
#include "core/study/layer.h"
#include "core/transport/integrator.h"

namespace eyeray {

struct LayerImage {
    Layer layer;
    int samples = 0;   // whole passes
    ColorImage values; // a layer of one number has it three times; where there is none: normal 0, depth ∞,
                       // object kNoObject
};

/// Sums of some layers over the samples of each pixel, in double and in the order of the passes: so the same
/// bits on any number of threads, Cost left out, and of the colour those of the Film.
class LayerFilm {
public:
    /// Throws Failure if there is no memory for it.
    LayerFilm(std::vector<Layer>, int width, int height);

    /// Traces sample `pass` of every pixel on the pool's threads and adds it, tile by tile. False if the
    /// context's stop came first. To be called by one thread.
    bool addPass(const TraceContext&, const Integrator&, int pass, ThreadPool&);

    // The others are thread-safe.
    const std::vector<Layer>& layers() const { return layers_; }
    int passes() const; // whole ones
    RayCounts counts() const;

    /// Mean over the samples that each tile has had so far.
    LayerImage image(std::size_t layer) const;

private:
    using Value = std::optional<DVec3>;
    struct Plane {
        std::vector<double> sums;   // one or three a pixel
        std::vector<double> second; // of Normal and Depth how many values, of Error the sum of squares
    };
    void addTile(std::size_t tile, const std::vector<Value>&, const RayCounts&);
    void add(const Layer&, Plane&, std::size_t pixel, const Value&, bool first) const;
    Color mean(const Layer&, const Plane&, std::size_t pixel, int samples) const;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    const std::vector<Layer> layers_;
    const int width_, height_;
    std::vector<Tile> tiles_;

    mutable std::mutex mutex_;  // of all below
    std::vector<Plane> planes_; // of each layer
    std::vector<int> tilePasses_;
    int passes_ = 0;
    RayCounts counts_;
};

/// Adds the passes that the settings ask for, from settings.firstPass on, until `stop`; 0 threads: one per
/// core.
void traceLayers(LayerFilm&, const std::shared_ptr<const World>&, const Camera&, const RenderSettings&,
                 int threads, const std::stop_token& stop);

}
