#pragma once
// Layers of one picture, pass by pass.

#include <vector>

#include "core/base/thread_pool.h"
#include "core/image/pixels.h"
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
/// Used by one thread.
class LayerFilm {
public:
    /// Throws Failure if there is no memory for it.
    LayerFilm(std::vector<Layer>, int width, int height);

    /// Traces sample `pass` of every pixel on the pool's threads and adds it. False if `stop` came first:
    /// then some tiles have one sample more than others.
    bool addPass(const TraceContext&, const Integrator&, int pass, ThreadPool&, const std::stop_token& stop);

    int passes() const { return passes_; } // whole ones
    const RayCounts& counts() const { return counts_; }
    const std::vector<Layer>& layers() const { return layers_; }

    /// Mean over each pixel's samples; at least one pass must be whole.
    LayerImage image(std::size_t layer) const;

private:
    struct Plane {
        std::vector<double> sums;   // one or three a pixel
        std::vector<double> second; // of Normal and Depth how many values, of Error the sum of squares
    };
    RayCounts addTile(const TraceContext&, const Integrator&, std::size_t tile, int pass);
    void add(const Layer&, Plane&, std::size_t pixel, const std::optional<DVec3>& value, bool first) const;
    Color mean(const Layer&, const Plane&, std::size_t pixel, int samples) const;

    std::vector<Layer> layers_;
    std::vector<Plane> planes_; // of each layer
    std::vector<Tile> tiles_;
    std::vector<int> tilePasses_;
    int width_, height_;
    int passes_ = 0;
    RayCounts counts_;
};

}
