#pragma once
// A ray, what it hits, and where that is.

#include <algorithm>
#include <cstdint>

#include "core/base/math.h"

namespace eyeray {

/// Half line origin + t·direction with t in (tMin, tMax), 0 ≤ tMin. The direction need not be of unit length.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, -1};
    float tMin = 0, tMax = kInfinity;

    Vec3 at(float t) const { return origin + t * direction; }
};

/// The axis along which a direction is longest; of equal ones the last. Without branches, for they would be
/// taken at random.
inline std::size_t longestAxis(const Vec3& direction) {
    const float x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
    const std::size_t yOverX = x > y ? 0 : 1, zOverBoth = std::max(x, y) > z ? 0 : 1;
    return yOverX + zOverBoth * (2 - yOverX);
}

/// The least that a hit must carry; all else is derived from it.
struct Hit {
    float t = kInfinity;
    float u = 0, v = 0;          // barycentric weights of a triangle's second and third vertex; for a shape
                                 // u is what t lacks of the root in double, v is 0
    std::uint32_t primitive = 0; // triangle of a mesh; face of a shape
    std::uint32_t instance = 0;
};

/// The surface at a hit.
struct SurfacePoint {
    Vec3 position{0}; // on the surface, reprojected, not origin + t·direction
    Vec3 error{0};    // bound on |position − exact| per axis, transforms included
    Vec3 geometricNormal{
        0}; // unit, the surface's own side: outward for solids, counter-clockwise for triangles
    Vec3 shadingNormal{0}; // unit, interpolated where a mesh has normals; else the geometric one
    Vec3 lift{0}; // from the position to the rounded surface that the shading normals of a mesh stand for,
                  // where that lies on the side from which the ray came
};

/// The surface at a point known in double: all the error is that of rounding to float.
inline SurfacePoint surfacePoint(const DVec3& position, const DVec3& unitNormal) {
    const Vec3 p(position), n(unitNormal);
    return {.position = p, .error = gammaBound(1) * glm::abs(p), .geometricNormal = n, .shadingNormal = n};
}

/// Origin of a ray that leaves `point` along `direction` and cannot meet the same surface again through
/// rounding. Moves along the geometric normal by the error bound, then to the next float outward. Pharr,
/// Jakob, Humphreys 2023, "Physically Based Rendering" 4th ed., section 6.8.6.
Vec3 spawnOrigin(const SurfacePoint& point, const Vec3& direction);
inline constexpr float kSpawnSlack = 1 + 0x1p-20F; // covers the rounding of what follows the bound

}
