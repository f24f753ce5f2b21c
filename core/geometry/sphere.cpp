#include "core/geometry/quadric.h"
#include "core/geometry/shapes.h"

namespace eyeray {

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray) {
    const double radius = sphere.radius;
    if (!(radius > 0)) return {};
    const DVec3 o(ray.origin), d(ray.direction);
    const double a = glm::dot(d, d), b = glm::dot(o, d);
    // The square of the ray's distance from the centre, not b² − ac: that cancels far from the sphere.
    const DVec3 nearest = o - b / a * d;
    const double discriminant = a * (radius * radius - glm::dot(nearest, nearest));
    if (!(discriminant >= 0)) return {};
    const Roots roots = quadraticRoots(a, b, glm::dot(o, o) - radius * radius, discriminant);
    return firstInside(ray, {roots.lower, 0}, {roots.upper, 0});
}

SurfacePoint surfaceAt(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    const DVec3 normal = safeNormalize(DVec3(ray.origin) + static_cast<double>(hit.t) * DVec3(ray.direction));
    return surfacePoint(static_cast<double>(sphere.radius) * normal, normal);
}

Vec2 textureCoordinates(const Sphere&, const SurfacePoint& point, std::uint32_t) {
    const DVec3 p(point.position);
    return {turn(p.x, p.z), static_cast<float>(std::atan2(std::hypot(p.x, p.z), p.y) / kPiD)};
}

}
