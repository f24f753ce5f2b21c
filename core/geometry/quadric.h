#pragma once
// What the shapes share: roots of a quadratic in double, the choice of the hit, the surface point.

#include <algorithm>
#include <optional>

#include "core/base/math.h"
#include "core/geometry/ray.h"

namespace eyeray {

struct Roots {
    double lower, upper;
};

/// Real roots of a·t² + 2b·t + c = 0, given its discriminant b² − ac ≥ 0; infinite or NaN where a is 0. Free
/// of cancellation: W. H. Press et al. 2007, "Numerical Recipes" 3rd ed., section 5.6.
inline Roots quadraticRoots(double a, double b, double c, double discriminant) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double r = q / a, s = c / q;
    return r < s ? Roots{r, s} : Roots{s, r};
}

/// Where a line crosses the surface of a solid.
struct Crossing {
    double t;
    std::uint32_t face;
};

/// The first of two crossings in order that lies in the ray's (tMin, tMax) as a float.
inline std::optional<Hit> firstInside(const Ray& ray, const Crossing& first, const Crossing& second) {
    for (const Crossing& crossing : {first, second}) {
        const float t = static_cast<float>(crossing.t);
        if (t > ray.tMin && t < ray.tMax) return Hit{.t = t, .primitive = crossing.face};
    }
    return {};
}

/// The surface at a point known in double: all the error is that of rounding to float.
inline SurfacePoint surfacePoint(const DVec3& position, const DVec3& normal) {
    const Vec3 p(position), n(normal);
    return {.position = p, .error = gammaBound(1) * glm::abs(p), .geometricNormal = n, .shadingNormal = n};
}

/// Angle around the y axis seen from outside, left to right, as a share of a turn in [0, 1]; 0.5 towards +z.
inline float turn(double x, double z) {
    return std::clamp(static_cast<float>(0.5 + std::atan2(x, z) / (2 * kPiD)), 0.0F, 1.0F);
}

}
