#include "core/transport/ray_counts.h"

#include <algorithm>
#include <numeric>

namespace eyeray {

std::uint64_t RayCounts::total() const { return std::accumulate(rays.begin(), rays.end(), std::uint64_t{0}); }

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    deepest = std::max(deepest, other.deepest);
    invalidSamples += other.invalidSamples;
    truncatedSamples += other.truncatedSamples;
    return *this;
}

}
