#include "core/geometry/triangle.h"

namespace eyeray {
namespace {

DVec3 toDouble(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// Twice the signed area of the origin with p and q: exact but for one rounding, since products of floats are
// exact in double; its sign is that of the exact value.
double edge(const Vec2& p, const Vec2& q) {
    return static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x;
}

// t where the ray meets the plane of the triangle, kept within the t of its corners: so it is bounded also
// for a triangle seen edge-on. From the unsheared corners: a ray that starts beside the plane by one unit in
// the last place knows on which side.
double meetsPlane(const TriangleCorners& corners, const DVec3& normal, const RayShear& shear) {
    const DVec3 toCorner = toDouble(corners[0]) - toDouble(shear.origin);
    const double t = glm::dot(normal, toCorner) / glm::dot(normal, toDouble(shear.direction));
    const auto ahead = [&](std::size_t corner) {
        return static_cast<double>(corners[corner][shear.kz]) - shear.origin[shear.kz];
    };
    const double a = ahead(0), b = ahead(1), c = ahead(2), along = shear.direction[shear.kz];
    const double first = std::min(a, std::min(b, c)) / along, last = std::max(a, std::max(b, c)) / along;
    return along > 0 ? std::min(std::max(first, t), last) : std::min(std::max(last, t), first);
}

}

RayShear::RayShear(const Ray& ray) : origin(toArray(ray.origin)), direction(toArray(ray.direction)) {
    const Vec3 size = glm::abs(ray.direction);
    kz = size.x > size.y ? (size.x > size.z ? 0U : 2U) : (size.y > size.z ? 1U : 2U);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (direction[kz] < 0) std::swap(kx, ky); // keeps the winding
    sx = direction[kx] / direction[kz];
    sy = direction[ky] / direction[kz];
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
    const float t = static_cast<float>(meetsPlane(corners, normal, shear));
    if (!(t > tMin && t < tMax)) return {};
    const double share = 1 / sum;
    return Hit{.t = t, .u = static_cast<float>(v * share), .v = static_cast<float>(w * share)};
}

}
