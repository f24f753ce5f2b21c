#pragma once
// What every method of image synthesis offers. Each method is one file.

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "core/base/math.h"
#include "core/transport/ray_counts.h"
#include "core/transport/recorder.h"
#include "core/transport/tile_hits.h"
#include "core/transport/trace_context.h"

namespace eyeray {

/// Pixels [x0, x1) × [y0, y1), of which every `step`-th in x and y is traced, starting at the middle of the
/// first block.
struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int step = 1;
    // Of each pixel, row by row: 0 leaves it out; empty: none is. Only with step 1.
    // NOLINTNEXTLINE(readability-redundant-member-init): GCC warns of members left out without
    std::span<const std::uint8_t> wanted = {};
    TileHits hits = {}; // NOLINT(readability-redundant-member-init): as above
};

/// Calls `each(x, y)` for the pixels of a tile that are traced, row by row.
template <class Each>
void eachTraced(const Tile& tile, const Each& each) {
    const int first = tile.step / 2;
    std::size_t place = 0;
    for (int y = tile.y0 + first; y < tile.y1 + first; y += tile.step)
        for (int x = tile.x0 + first; x < tile.x1 + first; x += tile.step)
            if (tile.wanted.empty() || tile.wanted[place++] != 0)
                each(std::min(x, tile.x1 - 1), std::min(y, tile.y1 - 1));
}

/// One sample for each traced pixel of a tile, row by row.
struct TileResult {
    Tile tile;
    std::vector<Color> radiance; // an invalid sample is black
    RayCounts counts;
    bool complete = false; // false: stop was requested on the way
};

/// One sample traced with all that happened on record.
struct Retrace : SampleRecord {
    Color radiance{0}; // the very bits that went into the film
};

/// Trees larger than this are cut and counted: glass inside glass at depth 64 would never end.
inline constexpr int kMaxTreeNodes = 1 << 16;

class Integrator {
public:
    virtual ~Integrator() = default;

    /// Traces sample `pass` of a tile's pixels. Thread-safe. Returns early when the context's stop is
    /// requested.
    virtual TileResult renderTile(const TraceContext&, const Tile&, int pass) const = 0;

    /// Traces sample `pass` of one pixel again, by the same code.
    virtual Retrace retrace(const TraceContext&, int x, int y, int pass) const = 0;

    /// Traces sample `pass` of all pixels of a tile again, row by row, and hands each to `each`, which may
    /// keep no reference to it. Returns what was traced, or nothing if stop was requested on the way.
    /// Thread-safe.
    using EachSample = std::function<void(int x, int y, const SampleRecord&, const Color& radiance)>;
    virtual std::optional<RayCounts> retraceTile(const TraceContext&, const Tile&, int pass,
                                                 const EachSample& each) const = 0;
};

std::unique_ptr<Integrator> makeIntegrator(Method);

}
