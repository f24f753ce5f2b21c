#pragma once
// Rays through Bvh8 as the renderer's streams send them.

#include <span>

#include "core/geometry/accel.h"
#include "tests/bench/rays/ray_columns.h"

namespace eyeray::bench {

/// t of the closest hit of each ray, infinite if there is none.
void tracePackets(const IndexedGeometry<Bvh8>&, const RayColumns&, std::span<float> answers);

}
