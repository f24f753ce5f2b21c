#include "core/geometry/shapes.h"

namespace eyeray {
namespace {

double meetsPlane(const Ray& ray) {
    return -static_cast<double>(ray.origin.y) / static_cast<double>(ray.direction.y);
}

DVec3 pointAt(const Ray& ray, double t) {
    return {ray.origin.x + t * ray.direction.x, 0.0, ray.origin.z + t * ray.direction.z};
}

bool contains(const Plane& plane, const DVec3& p) {
    const double x = 2 * std::fabs(p.x), z = 2 * std::fabs(p.z);
    if (!plane.round) return x <= plane.sizeX && z <= plane.sizeZ;
    const double a = x / static_cast<double>(plane.sizeX), b = z / static_cast<double>(plane.sizeZ);
    return a * a + b * b <= 1;
}

}

std::optional<Hit> intersect(const Plane& plane, const Ray& ray) {
    if (!plane.doubleSided && !(ray.direction.y < 0)) return {};
    const double t = meetsPlane(ray); // NaN for a ray in the plane
    const float rounded = static_cast<float>(t);
    if (!(rounded > ray.tMin && rounded < ray.tMax)) return {};
    if (!contains(plane, pointAt(ray, t))) return {};
    return Hit{.t = rounded};
}

SurfacePoint surfaceAt(const Plane&, const Ray& ray, const Hit&) {
    return surfacePoint(pointAt(ray, meetsPlane(ray)), DVec3(0, 1, 0));
}

Vec2 textureCoordinates(const Plane&, const SurfacePoint& point, std::uint32_t) {
    return {point.position.x, point.position.z};
}

}
