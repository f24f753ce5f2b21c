// Rays through Bvh8 with a log of their way, by the code of accel_bvh8.cpp; in a file of its own, so that the
// compiler treats the code without a log as if this were not there.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/geometry/accel_bvh8_log.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/bvh8_hits.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

std::optional<Hit> loggedClosestHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask,
                                     TraversalLog& log) {
    return closest(geometry, ray, mask, Watched(log));
}

bool loggedAnyHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask, TraversalLog& log) {
    return any(geometry, ray, mask, Watched(log));
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(loggedClosestHit8);
HWY_EXPORT(loggedAnyHit8);

template <>
std::optional<Hit> closestHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask,
                              TraversalLog& log) {
    return HWY_DYNAMIC_DISPATCH(loggedClosestHit8)(geometry, ray, mask, log);
}

template <>
bool anyHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask, TraversalLog& log) {
    return HWY_DYNAMIC_DISPATCH(loggedAnyHit8)(geometry, ray, mask, log);
}

}
#endif
