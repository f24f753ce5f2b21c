#pragma once
// Rays through Bvh8 as the renderer's streams send them: as many at once as a register has lanes.

#include <vector>

#include "core/geometry/accel.h"
#include "core/study/ray_bench.h"

namespace eyeray::bench {

/// t of the closest hit of each ray, infinite if there is none; or 1 and 0 for any hit.
void tracePackets(const IndexedGeometry<Bvh8>&, const RaySet&, std::vector<float>& answers);

}
