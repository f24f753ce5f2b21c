#pragma once
// The watertight intersection of a triangle: S. Woop, C. Benthin, I. Wald 2013, "Watertight Ray/Triangle
// Intersection", JCGT 2(1).

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/math.h"
#include "core/geometry/ray.h"

namespace eyeray {

/// Counter-clockwise as seen from the front.
using TriangleCorners = std::array<std::array<float, 3>, 3>;

inline std::array<float, 3> toArray(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What the test needs of a ray, computed once per ray: the shear to a space where the ray runs along +z
/// through the origin. It maps a vertex to the same place for all triangles around it: hence no gaps.
struct RayShear {
    explicit RayShear(const Ray& ray) : origin(toArray(ray.origin)), direction(toArray(ray.direction)) {
        const Vec3 size = glm::abs(ray.direction);
        const bool x = size.x > size.y, ofXY = (x ? size.x : size.y) > size.z;
        // Without branches, for they would be taken at random.
        kz = ofXY ? (x ? 0U : 1U) : 2U;
        const std::size_t turned = std::signbit(direction[kz]) ? 1 : 0; // keeps the winding
        kx = kAxes[kz + 1 + turned];
        ky = kAxes[kz + 2 - turned];
        sx = direction[kx] / direction[kz];
        sy = direction[ky] / direction[kz];
    }

    Vec2 operator()(const std::array<float, 3>& vertex) const {
        const float z = vertex[kz] - origin[kz];
        return {vertex[kx] - origin[kx] - sx * z, vertex[ky] - origin[ky] - sy * z};
    }

    std::array<float, 3> origin, direction;
    std::size_t kx, ky, kz; // kz is the axis along which the direction is longest
    float sx, sy;

private:
    static constexpr std::array<std::size_t, 5> kAxes{0, 1, 2, 0, 1};
};

namespace detail {
/// The rest of the test for a triangle that its sheared corners do not rule out.
std::optional<Hit> finishTriangle(const TriangleCorners&, const std::array<Vec2, 3>& sheared,
                                  bool doubleSided, const RayShear&, float tMin, float tMax);
}

/// Closest hit of one triangle in (tMin, tMax), or nothing; `primitive` and `instance` stay 0. Neighbours
/// that share an edge or vertex leave no gap between them. Zero-area triangles are never hit. Never returns
/// NaN. Thread-safe.
inline std::optional<Hit> intersectCorners(const TriangleCorners& corners, bool doubleSided,
                                           const RayShear& shear, float tMin, float tMax) {
    const Vec2 a = shear(corners[0]), b = shear(corners[1]), c = shear(corners[2]);
    const float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    // Rounding is monotonic, so each has the sign of its exact value or is 0: both signs are a miss for sure.
    if (std::min(u, std::min(v, w)) < 0 && std::max(u, std::max(v, w)) > 0) return {};
    return detail::finishTriangle(corners, {a, b, c}, doubleSided, shear, tMin, tMax);
}

}
