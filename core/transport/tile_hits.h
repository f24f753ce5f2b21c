#pragma once
// What the eye rays of a tile hit: one picture finds it, the next one need not while only shading changes.

#include <array>
#include <optional>

#include "core/geometry/ray.h"

namespace eyeray {

/// Columns by pixel of a tile, row by row, in the names of Hit.
struct TileHits {
    static constexpr std::size_t kPixels = 1024;         // no tile has more
    static constexpr std::uint32_t kMissed = 0xffffffff; // instance of a ray that meets the background

    // Not initialised: a page that is not needed is not touched.
    std::array<float, kPixels> t, u, v;
    std::array<std::uint32_t, kPixels> primitive, instance;

    std::optional<Hit> at(std::size_t pixel) const {
        if (instance[pixel] == kMissed) return std::nullopt;
        return Hit{t[pixel], u[pixel], v[pixel], primitive[pixel], instance[pixel]};
    }
    void set(std::size_t pixel, const std::optional<Hit>& found) {
        const Hit hit = found.value_or(Hit{.instance = kMissed});
        t[pixel] = hit.t, u[pixel] = hit.u, v[pixel] = hit.v;
        primitive[pixel] = hit.primitive, instance[pixel] = hit.instance;
    }
};

}
