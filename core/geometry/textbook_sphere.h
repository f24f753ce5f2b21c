#pragma once
// A sphere by the quadratic formula.

#include "core/geometry/textbook_quadratic.h"
#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// Closest t in (tMin, tMax) at which the ray meets the sphere around the origin, or nothing. F01: far from
/// the sphere all digits of b² − 4ac are lost, so that misses are hits; F02: close to a huge one those of c =
/// p·p − r². As in many lectures, t = −d·p ± √((d·p)² − p·p + 1), and Glassner 1989, "An Introduction to Ray
/// Tracing", chapter 2.
template <class T>
std::optional<T> intersectSphere(T radius, const RayOf<T>& ray) {
    const Vector<T>&p = ray.origin, &d = ray.direction;
    const auto roots = quadraticRoots(glm::dot(d, d), 2 * glm::dot(d, p), glm::dot(p, p) - radius * radius);
    if (!roots) return {};
    if (ray.holds(roots->lower)) return roots->lower;
    if (ray.holds(roots->upper)) return roots->upper;
    return {};
}

/// The angle of a point on the sphere from its top, as a share of π, by the arc cosine. F25: where o + t·d
/// lies outside, which by rounding is so for every third point near the top, that is NaN; for the others half
/// of the digits are lost.
template <class T>
T latitude(T radius, const Vector<T>& point) {
    return std::acos(point.y / radius) / static_cast<T>(kPiD);
}

}
