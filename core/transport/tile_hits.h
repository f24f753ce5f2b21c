#pragma once
// What the eye rays of a tile hit: one picture finds it, the next one need not while only shading changes.

#include <optional>

#include "core/geometry/ray.h"

namespace eyeray {

/// Columns by sample of a tile, in the order of eachTraced and the names of Hit; memory of whoever wants hits
/// kept, or null.
struct TileHits {
    static constexpr std::uint32_t kMissed = 0xffffffff; // instance of a ray that meets the background

    float *t = nullptr, *u = nullptr, *v = nullptr;
    std::uint32_t *primitive = nullptr, *instance = nullptr;
    bool known = false; // they are there already: no eye ray is traced

    bool kept() const { return t != nullptr; }

    std::optional<Hit> at(std::size_t sample) const {
        if (instance[sample] == kMissed) return std::nullopt;
        return Hit{t[sample], u[sample], v[sample], primitive[sample], instance[sample]};
    }
    void set(std::size_t sample, const std::optional<Hit>& found) const {
        const Hit hit = found.value_or(Hit{.instance = kMissed});
        t[sample] = hit.t, u[sample] = hit.u, v[sample] = hit.v;
        primitive[sample] = hit.primitive, instance[sample] = hit.instance;
    }
};

}
