#pragma once
// A triangle by its own barycentric coordinates.

#include <array>
#include <cmath>
#include <optional>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

template <class T>
using Corners = std::array<Vector<T>, 3>;

template <class T>
struct TriangleHit {
    T t, u, v; // barycentric weights of the second and third corner
};

inline constexpr double kMollerTrumboreEpsilon = 1e-6; // of the paper's listing

/// Closest hit of a double-sided triangle in (tMin, tMax), or nothing. T. Möller, B. Trumbore 1997, "Fast,
/// Minimum Storage Ray-Triangle Intersection", Journal of Graphics Tools 2(1). F07: u and v are rounded for
/// each triangle alone, so two neighbours may both say "outside"; F08: a determinant below `epsilon` counts
/// as parallel, and so is every small triangle; F09: with an epsilon of 0 a triangle without area divides by
/// 0, and NaN passes tests of the form u < 0.
template <class T>
std::optional<TriangleHit<T>> intersectTriangle(const Corners<T>& corners, const RayOf<T>& ray, T epsilon) {
    const Vector<T> edge1 = corners[1] - corners[0], edge2 = corners[2] - corners[0];
    const Vector<T> p = glm::cross(ray.direction, edge2);
    const T determinant = glm::dot(edge1, p);
    if (determinant > -epsilon && determinant < epsilon) return {};
    const T inverse = 1 / determinant;
    const Vector<T> toOrigin = ray.origin - corners[0];
    const T u = glm::dot(toOrigin, p) * inverse;
    if (u < 0 || u > 1) return {};
    const Vector<T> q = glm::cross(toOrigin, edge1);
    const T v = glm::dot(ray.direction, q) * inverse;
    if (v < 0 || u + v > 1) return {};
    const T t = glm::dot(edge2, q) * inverse;
    if (t <= ray.tMin || t >= ray.tMax) return {};
    return TriangleHit<T>{t, u, v};
}

/// Twice the signed area of the origin with p and q, as a compiler that contracts a·b − c·d to one FMA
/// computes it. F19: one product is rounded and the other is not, so side(p, p) is not 0 and side(p, q) is
/// not −side(q, p).
template <class T>
T contractedSide(const glm::vec<2, T>& p, const glm::vec<2, T>& q) {
    return std::fma(p.x, q.y, -(p.y * q.x));
}

}
