#include "core/geometry/shapes.h"
#include "core/geometry/solid.h"

namespace eyeray {

namespace {

Passage passThrough(const Sphere& sphere, const Ray& ray) {
    const double radius = sphere.radius;
    const DVec3 o(ray.origin), d(ray.direction);
    const double a = glm::dot(d, d), b = glm::dot(o, d);
    // By the ray's distance from the centre, not b² − ac: that cancels far from the sphere. The products of
    // floats are exact in double.
    const DVec3 aside = glm::cross(o, d);
    const double discriminant = a * (radius * radius) - glm::dot(aside, aside);
    if (!(discriminant >= 0 && radius > 0)) return kNoPassage;
    // As quadraticRoots, but which root is the lower is known from signs, as a is positive.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double larger = q / a, smaller = (glm::dot(o, o) - radius * radius) / q; // but for rounding
    if (q > 0) return {{smaller, 0}, {std::max(larger, smaller), 0}};
    return {{std::min(larger, smaller), 0}, {smaller, 0}};
}

}

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray) {
    return firstEnd(passThrough(sphere, ray), ray);
}

SurfacePoint surfaceAt(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    const DVec3 normal = safeNormalize(pointAtHit(ray, hit));
    return surfacePoint(static_cast<double>(sphere.radius) * normal, normal);
}

Vec2 textureCoordinates(const Sphere&, const SurfacePoint& point, std::uint32_t) {
    const DVec3 p(point.position);
    return {turn(p.x, p.z), static_cast<float>(std::atan2(std::hypot(p.x, p.z), p.y) / kPiD)};
}

}
