#pragma once
// How many rays of each kind were traced.

#include <array>
#include <cstdint>

#include "core/base/ray_kind.h"

namespace eyeray {

struct RayCounts {
    std::array<std::uint64_t, kRayKinds> rays{};
    int deepest = 0;                    // depth of the deepest ray traced
    std::uint64_t invalidSamples = 0;   // not finite: left out of the picture
    std::uint64_t truncatedSamples = 0; // whose tree outgrew kMaxTreeNodes

    std::uint64_t& operator[](RayKind kind) { return rays[static_cast<std::size_t>(kind)]; }
    std::uint64_t operator[](RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
    std::uint64_t total() const;
    RayCounts& operator+=(const RayCounts&);
};

}
