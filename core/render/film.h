#pragma once
// Sums of samples per pixel, that workers write and others read while they do.

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/large_pages.h"
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
    Color mean{0};          // over its samples; the coarse preview before the first
    int samples = 0;        // that it has had
    std::uint64_t film = 0; // Film::id
};

/// Two sums per pixel, for passes of even and odd number: the sum over whole passes stays readable while the
/// next pass is written. A pixel takes part in every pass until its limit. All functions are thread-safe
/// unless they say otherwise.
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

    /// Sets how many samples each pixel, row by row, is to have; without, there is no end. A pixel that has
    /// reached its limit keeps it. To be called between passes.
    void limit(std::span<const int> samples);

    /// Whether every pixel has reached its limit after so many passes.
    bool ended(int passes) const;

    /// Which pixels of a tile take part in a pass: Tile::wanted.
    std::vector<std::uint8_t> wanted(int tileIndex, int pass) const;

    /// Adds the samples that a tile's wanted pixels have in pass number `pass` (counted from 0 in this film)
    /// to the sums of the pass before.
    void add(int tileIndex, const TileResult&, int pass);

    /// Shows a coarse result in a tile until its first pass is there.
    void preview(int tileIndex, const TileResult&);

    /// Copies the tiles that have changed since `picture` was last read. Returns the changed tile indices.
    std::vector<int> read(Picture& picture) const;

    FilmPixel pixel(int x, int y) const;

    // To be called between passes. `passes` must be the last pass or the one before it that is complete.

    /// Mean over the samples of the first `passes` passes.
    ColorImage mean(int passes) const;

    /// The same, in the memory of the film itself where no tile has gone further. Then the film is of no use
    /// until it is reset.
    ColorImage takeMean(int passes);

    /// How many samples each pixel, row by row, has after `passes`.
    std::vector<int> samples(int passes) const;

    /// Variance of one sample of each pixel, row by row, as far as a display (0 to 1) may show it: the slope
    /// is that of the darkest radiance that the mean's own error leaves likely, so that noise about a mean
    /// beyond white counts. At most 1e4. `passes` ≥ 2.
    std::vector<double> displayedVariances(int passes, const DisplaySettings&) const;

    /// Standard error of the displayed values (0 to 1) as root mean square over each tile; the largest one.
    /// `passes` ≥ 2.
    double estimatedError(int passes, const DisplaySettings&) const;

private:
    static constexpr int kNoLimit = std::numeric_limits<int>::max();
    struct TileState {
        Tile area;
        int passes = 0;
        bool blank = true; // nothing has been shown in it
        std::uint32_t version = 0;
        int leastLimit = kNoLimit, mostLimit = kNoLimit; // of its pixels
    };
    /// Luminance of a pixel: mean, and the variance of the mean.
    struct Estimate {
        double mean, variance;
    };
    Estimate estimate(std::size_t pixel, int samples, std::size_t last) const;
    int samplesOf(const TileState& tile, std::size_t pixel, int passes) const {
        return tile.leastLimit >= passes ? passes : std::min(limits_[pixel], passes);
    }
    void showFirst(const TileState&, const TileResult&);
    void keepFirst(const TileState&);
    void addAll(const TileState&, const TileResult&, int pass);
    void addWanted(const TileState&, const TileResult&, int pass);
    void copyRow(const TileState&, int y, ColorImage& to) const;
    void roundMeans(const TileState&, int pass);
    std::size_t pixels() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
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
    // Not initialised: a page that nothing has written is not touched. The sums of the first pass lie in
    // `shown_` until the second, so that a picture of one sample needs no more memory than it shows.
    std::array<LargeArray<DVec3>, 2> sums_;
    std::array<LargeArray<double>, 2> squares_; // of luminance, likewise
    std::unique_ptr<int[]> limits_;             // of samples; read where a tile has any
    LargeArray<Color> shown_;                   // mean of each tile's passes, or its preview
    std::vector<TileState> tiles_;
    mutable std::array<std::mutex, kMutexes> mutexes_;
};

}
