// Rays through Bvh8: the whole way of a ray is compiled for each instruction set, and chosen once per ray.
// SIMD only rules out; what is left is decided by the same scalar tests that all indices use, so all find the
// same hits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/geometry/accel_bvh8.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/bvh8_hits.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

std::optional<Hit> closestHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return closest(geometry, ray, mask, Unwatched{});
}

bool anyHit8(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return any(geometry, ray, mask, Unwatched{});
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(closestHit8);
HWY_EXPORT(anyHit8);

// HWY_DYNAMIC_DISPATCH would call the library for each ray.
static const hwy::ChosenTarget& chosenTarget = hwy::GetChosenTarget();

template <>
std::optional<Hit> closestHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return HWY_DISPATCH_TABLE(closestHit8)[chosenTarget.GetIndex()](geometry, ray, mask);
}

template <>
bool anyHit(const IndexedGeometry<Bvh8>& geometry, const Ray& ray, RayMask mask) {
    return HWY_DISPATCH_TABLE(anyHit8)[chosenTarget.GetIndex()](geometry, ray, mask);
}

}
#endif
