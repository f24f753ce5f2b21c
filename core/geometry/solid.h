#pragma once
// What the convex solids share: a line is inside them in one piece, from one crossing to another.

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/math.h"
#include "core/geometry/ray.h"

namespace eyeray {

/// Where a line crosses the surface of a solid.
struct Crossing {
    double t;
    std::uint32_t face;
};

/// The piece of a line inside a convex solid; `in` comes after `out` where there is none.
struct Passage {
    Crossing in{-std::numeric_limits<double>::infinity(), 0};
    Crossing out{std::numeric_limits<double>::infinity(), 0};
};

inline constexpr Passage kNoPassage{{std::numeric_limits<double>::infinity(), 0},
                                    {-std::numeric_limits<double>::infinity(), 0}};

/// The first end of the passage that lies in the ray's (tMin, tMax) as a float. An end that is NaN is none.
inline std::optional<Hit> firstEnd(const Passage& passage, const Ray& ray) {
    if (!(passage.in.t <= passage.out.t)) return {};
    for (const Crossing& end : {passage.in, passage.out}) {
        const float t = static_cast<float>(end.t);
        if (t > ray.tMin && t < ray.tMax)
            return Hit{.t = t, .u = static_cast<float>(end.t - t), .primitive = end.face};
    }
    return {};
}

/// The point of the ray at a hit that firstEnd returned.
inline DVec3 pointAtHit(const Ray& ray, const Hit& hit) {
    const double t = static_cast<double>(hit.t) + hit.u;
    return DVec3(ray.origin) + t * DVec3(ray.direction);
}

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

/// Angle around the y axis seen from outside, left to right, as a share of a turn in [0, 1]; 0.5 towards +z.
inline float turn(double x, double z) {
    return std::clamp(static_cast<float>(0.5 + std::atan2(x, z) / (2 * kPiD)), 0.0F, 1.0F);
}

}
