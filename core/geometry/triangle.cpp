#include "core/geometry/triangle.h"

namespace eyeray {
namespace {

DVec3 toDouble(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// Twice the signed area of the origin with p and q: exact but for one rounding, since products of floats are
// exact in double; its sign is that of the exact value.
double edge(const Vec2& p, const Vec2& q) {
    return static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x;
}

/// Where the corners of a triangle lie along the longest axis of the ray, from its origin on and ahead.
struct Ahead {
    Ahead(const TriangleCorners& corners, const RayShear& shear)
        : along(std::fabs(shear.direction[shear.kz])) {
        const double sign = shear.direction[shear.kz] < 0 ? -1 : 1;
        const auto ahead = [&](std::size_t corner) {
            return sign * (static_cast<double>(corners[corner][shear.kz]) - shear.origin[shear.kz]);
        };
        const double a = ahead(0), b = ahead(1), c = ahead(2);
        nearest = std::min(a, std::min(b, c));
        farthest = std::max(a, std::max(b, c));
    }

    double along; // for one unit of t
    double nearest, farthest;
};

}

std::optional<Hit> detail::finishTriangle(const TriangleCorners& corners, const std::array<Vec2, 3>& sheared,
                                          bool doubleSided, const RayShear& shear, float tMin, float tMax) {
    const auto& [a, b, c] = sheared;
    const double u = edge(c, b), v = edge(a, c), w = edge(b, a);
    const bool front = u >= 0 && v >= 0 && w >= 0, back = u <= 0 && v <= 0 && w <= 0;
    if (!front && !(doubleSided && back)) return {};
    const double sum = u + v + w;
    if (!(std::fabs(sum) > 0)) return {};

    const DVec3 normal =
        glm::cross(toDouble(corners[1]) - toDouble(corners[0]), toDouble(corners[2]) - toDouble(corners[0]));
    if (normal == DVec3(0)) return {};
    // Where the ray meets the plane of the triangle. From the unsheared corners: a ray that starts beside the
    // plane by one unit in the last place knows on which side.
    const double distance = glm::dot(normal, toDouble(corners[0]) - toDouble(shear.origin));
    const double approach = glm::dot(normal, toDouble(shear.direction));
    const Ahead ahead(corners, shear);
    // Kept within the t of its corners: so it is bounded also for a triangle seen edge-on.
    const double atNearest = ahead.nearest / ahead.along, atFarthest = ahead.farthest / ahead.along;
    const auto t = static_cast<float>(std::min(std::max(atNearest, distance / approach), atFarthest));
    if (!(t > tMin && t < tMax)) return {};
    const double share = 1 / sum;
    return Hit{.t = t, .u = static_cast<float>(v * share), .v = static_cast<float>(w * share)};
}

}
