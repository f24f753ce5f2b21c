#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/rays/packets.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/accel_lanes.h"
#include "tests/bench/rays/packets.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

void traceRays(const IndexedGeometry<Bvh8>& geometry, const RaySet& set, std::vector<float>& answers) {
    Spread3 origin, direction;
    Spread tMin, tMax;
    for (std::size_t first = 0; first < set.rays.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, set.rays.size() - first);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const Ray& ray = set.rays[first + lane];
            origin.set(lane, ray.origin), direction.set(lane, ray.direction);
            tMin.lane[lane] = ray.tMin, tMax.lane[lane] = ray.tMax;
        }
        const RayLanes rays{gathered(origin), gathered(direction), gathered(tMin), gathered(tMax)};
        const auto there = hn::FirstN(FloatTag(), count);
        const Spread found =
            spread(set.anyHit ? hn::IfThenElseZero(anyHits(geometry, rays, there, RayMask::All), all(1.0F))
                              : closestHits(geometry, rays, there, RayMask::All).t);
        std::copy_n(found.lane, count, answers.begin() + static_cast<std::ptrdiff_t>(first));
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(traceRays);

void bench::tracePackets(const IndexedGeometry<Bvh8>& geometry, const RaySet& set,
                         std::vector<float>& answers) {
    HWY_DYNAMIC_DISPATCH(traceRays)(geometry, set, answers);
}

}
#endif
