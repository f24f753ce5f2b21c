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

/// How far the world position of an object-space point, mapped back as a ray's origin, may lie from the point
/// through rounding: of both maps' entries, of both results. In world space, per axis.
Vec3 mapError(const Affine& objectToWorld, const Affine& worldToObject, const Vec3& point);

/// A surface point of object space in world space. Normals by the inverse transpose (Turkowski 1990,
/// "Properties of Surface-Normal Transformations", Graphics Gems): what is in front of the surface in object
/// space stays in front of it, also under a map that mirrors, as glTF says of the winding of triangles. The
/// error bound grows by mapError (Pharr, Jakob, Humphreys 2023, "Physically Based Rendering" 4th ed.,
/// section 6.8.4).
SurfacePoint toWorld(const SurfacePoint&, const Affine& objectToWorld, const Affine& worldToObject);

}
