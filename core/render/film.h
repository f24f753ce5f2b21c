#pragma once
// Sums of samples per pixel, that workers write and others read while they do.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "core/image/pixels.h"
#include "core/render/display.h"
#include "core/transport/integrator.h"

namespace eyeray {

inline constexpr int kTileSize = 32;

/// What a viewer shows: kept by the reader, brought up to date by Film::read.
struct Picture {
    ColorImage radiance;                 // mean of the samples so far, or the coarse preview
    std::vector<std::uint32_t> versions; // of each tile, as last read
    std::uint64_t film = 0;              // which film it was read from
};

/// One pixel of a film.
struct FilmPixel {
    Color mean{0};          // over its passes; the coarse preview before the first
    int passes = 0;         // that its tile has had
    std::uint64_t film = 0; // Film::id
};

/// Two sums per pixel, for passes of even and odd number: the sum over whole passes stays readable while the
/// next pass is written. All functions are thread-safe unless they say otherwise.
class Film {
public:
    /// Throws Failure if there is no memory for it.
    Film(int width, int height);

    /// Forgets all passes, for a new picture of the same size. Not while others use the film. `eightBit`:
    /// keep the running mean in 8 bits a channel, as Fault::EightBit has it.
    void reset(bool eightBit = false);

    int width() const { return width_; }
    int height() const { return height_; }
    int tiles() const { return static_cast<int>(tiles_.size()); }
    Tile tile(int index) const { return tiles_[static_cast<std::size_t>(index)].area; }
    std::uint64_t id() const { return id_; }

    /// Passes that a tile has had.
    int passes(int tileIndex) const;

    /// Adds a tile's samples of pass number `pass` (counted from 0 in this film) to the sums of the pass
    /// before.
    void add(int tileIndex, const TileResult&, int pass);

    /// Shows a coarse result in a tile until its first pass is there.
    void preview(int tileIndex, const TileResult&);

    /// Copies the tiles that have changed since `picture` was last read. Returns the changed tile indices.
    std::vector<int> read(Picture& picture) const;

    FilmPixel pixel(int x, int y) const;

    /// Mean over the first `passes` passes, which must be the last or the one before the last that is
    /// complete. To be called between passes.
    ColorImage mean(int passes) const;

    /// Standard error of the displayed values (0 to 1) as root mean square over each tile; the largest one.
    /// To be called between passes. `passes` ≥ 2.
    double estimatedError(int passes, const DisplaySettings&) const;

private:
    struct TileState {
        Tile area;
        int passes = 0;
        std::uint32_t version = 0;
    };
    /// Of so many samples, to multiples of 1/255.
    void roundMeans(const Tile&, std::size_t now, int count);
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    std::mutex& mutexOf(int tileIndex) const {
        return mutexes_[static_cast<std::size_t>(tileIndex) % kMutexes];
    }

    static constexpr std::size_t kMutexes = 64;
    int width_, height_;
    std::uint64_t id_;
    bool eightBit_ = false;
    // Not initialised: the first pass writes before anything reads, and a page that is not needed is not
    // touched.
    std::array<std::unique_ptr<DVec3[]>, 2> sums_;
    std::array<std::unique_ptr<double[]>, 2> squares_; // of luminance, likewise
    ColorImage shown_;
    std::vector<TileState> tiles_;
    mutable std::array<std::mutex, kMutexes> mutexes_;
};

}
