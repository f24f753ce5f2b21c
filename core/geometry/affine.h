#pragma once
// Affine maps in float, prepared from double.

#include "core/base/math.h"
#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"

namespace eyeray {

/// x ↦ linear·x + translation.
struct Affine {
    Mat3 linear{1};
    Vec3 translation{0};

    static Affine from(const DMat4& m) { return {Mat3(DMat3(m)), Vec3(m[3])}; }

    Vec3 point(const Vec3& p) const { return linear * p + translation; }
    Vec3 vector(const Vec3& v) const { return linear * v; }
    /// The direction is not renormalised, so t means the same in both spaces.
    Ray ray(const Ray& r) const { return {point(r.origin), vector(r.direction), r.tMin, r.tMax}; }
};

/// Box around the mapped box; conservative against the rounding of this map.
Bounds boundsOf(const Affine&, const Bounds&);

}
