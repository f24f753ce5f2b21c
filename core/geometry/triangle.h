#pragma once
// The watertight intersection of a triangle: S. Woop, C. Benthin, I. Wald 2013, "Watertight Ray/Triangle
// Intersection", JCGT 2(1).

#include <algorithm>
#include <array>
#include <bit>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "core/base/math.h"
#include "core/geometry/ray.h"

namespace eyeray {

/// Counter-clockwise as seen from the front.
using TriangleCorners = std::array<std::array<float, 3>, 3>;

inline std::array<float, 3> toArray(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What the test needs of a ray, computed once per ray: axes turned so that the direction is longest along
/// the third, and the shear to a space where the ray runs along it through the origin. That maps a vertex to
/// the same place for all triangles around it: hence no gaps.
struct RayShear {
    explicit RayShear(const Ray& ray) {
        const float* const from = glm::value_ptr(ray.origin);
        const float* const along = glm::value_ptr(ray.direction);
        const std::size_t longest = longestAxis(ray.direction);
        const std::size_t backward = std::bit_cast<std::uint32_t>(along[longest]) >> 31U; // keeps the winding
        axes = {kAxes[longest + 1 + backward], kAxes[longest + 2 - backward], longest};
        origin = {from[axes[0]], from[axes[1]], from[axes[2]]};
        direction = {along[axes[0]], along[axes[1]], along[axes[2]]};
        sx = direction[0] / direction[2];
        sy = direction[1] / direction[2];
    }
    /// Of parts that are known.
    RayShear(const std::array<std::size_t, 3>& turnedAxes, const std::array<float, 3>& turnedOrigin,
             const std::array<float, 3>& turnedDirection, float shearX, float shearY)
        : axes(turnedAxes), origin(turnedOrigin), direction(turnedDirection), sx(shearX), sy(shearY) {}

    /// A vertex along the turned axes.
    std::array<float, 3> turned(const std::array<float, 3>& vertex) const {
        return {vertex[axes[0]], vertex[axes[1]], vertex[axes[2]]};
    }
    TriangleCorners turned(const TriangleCorners& corners) const {
        return {turned(corners[0]), turned(corners[1]), turned(corners[2])};
    }

    /// Where the shear maps a turned vertex to.
    Vec2 operator()(const std::array<float, 3>& vertex) const {
        const float z = vertex[2] - origin[2];
        return {vertex[0] - origin[0] - sx * z, vertex[1] - origin[1] - sy * z};
    }

    std::array<std::size_t, 3> axes;
    std::array<float, 3> origin, direction; // turned
    float sx, sy;

private:
    static constexpr std::array<std::size_t, 5> kAxes{0, 1, 2, 0, 1};
};

namespace detail {
inline DVec3 toDouble(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// Twice the signed area of the origin with p and q: exact but for one rounding, since products of floats are
// exact in double; its sign is that of the exact value.
inline double edge(const Vec2& p, const Vec2& q) {
    return static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x;
}

/// t where the ray meets the plane of a triangle, of turned corners; infinite behind the origin, and where it
/// has no plane.
inline float meetPlane(const TriangleCorners& corners, const RayShear& shear) {
    const DVec3 origin = toDouble(shear.origin), direction = toDouble(shear.direction);
    const DVec3 first = toDouble(corners[0]), second = toDouble(corners[1]), third = toDouble(corners[2]);
    const DVec3 normal = glm::cross(second - first, third - first);
    // From the unsheared corners: a ray that starts beside the plane by one unit in the last place knows on
    // which side.
    const double distance = glm::dot(normal, first - origin), approach = glm::dot(normal, direction);
    // Where the corners lie along the longest axis of the ray, from its origin on and ahead.
    const double along = std::fabs(direction.z), sign = std::copysign(1.0, direction.z);
    const double a = sign * (first.z - origin.z), b = sign * (second.z - origin.z),
                 c = sign * (third.z - origin.z);
    const double nearest = std::min(a, std::min(b, c)), farthest = std::max(a, std::max(b, c));
    if (nearest <= 0 && distance * approach < 0) return kInfinity; // like the triangle that a ray leaves
    if (approach == 0 && normal == DVec3(0)) return kInfinity;
    // Kept within the t of its corners: so it is bounded also for a triangle seen edge-on.
    return static_cast<float>(std::min(std::max(nearest / along, distance / approach), farthest / along));
}

/// The hit at t of a triangle whose sheared corners are around the ray.
inline std::optional<Hit> hitWithin(const std::array<Vec2, 3>& sheared, bool doubleSided, float t) {
    const double u = edge(sheared[2], sheared[1]), v = edge(sheared[0], sheared[2]),
                 w = edge(sheared[1], sheared[0]);
    const bool front = u >= 0 && v >= 0 && w >= 0, back = u <= 0 && v <= 0 && w <= 0;
    if (!front && !(doubleSided && back)) return {};
    const double sum = u + v + w;
    if (!(std::fabs(sum) > 0)) return {};
    const double share = 1 / sum;
    return Hit{.t = t, .u = static_cast<float>(v * share), .v = static_cast<float>(w * share)};
}

/// The rest of the test for a triangle, of turned corners, that its sheared ones do not rule out.
inline std::optional<Hit> finishTriangle(const TriangleCorners& corners, const std::array<Vec2, 3>& sheared,
                                         bool doubleSided, const RayShear& shear, float tMin, float tMax) {
    const float t = meetPlane(corners, shear);
    if (!(t > tMin && t < tMax)) return {}; // first, for it rules out the triangle that a ray leaves
    return hitWithin(sheared, doubleSided, t);
}
}

/// Closest hit of one triangle in (tMin, tMax), or nothing; `primitive` and `instance` stay 0. Neighbours
/// that share an edge or vertex leave no gap between them. Zero-area triangles are never hit. Never returns
/// NaN. Thread-safe.
inline std::optional<Hit> intersectCorners(const TriangleCorners& corners, bool doubleSided,
                                           const RayShear& shear, float tMin, float tMax) {
    const TriangleCorners turned = shear.turned(corners);
    const Vec2 a = shear(turned[0]), b = shear(turned[1]), c = shear(turned[2]);
    const float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    // Rounding is monotonic, so each has the sign of its exact value or is 0: both signs are a miss for sure.
    if (std::min(u, std::min(v, w)) < 0 && std::max(u, std::max(v, w)) > 0) return {};
    return detail::finishTriangle(turned, {a, b, c}, doubleSided, shear, tMin, tMax);
}

}
