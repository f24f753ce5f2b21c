#pragma once
// The plane n·p = distance.

#include <optional>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// t = (distance − n·o) / (n·d) where no test says that it is outside. F16: NaN for a ray in the plane passes
/// as a hit, and so does ±∞ for a parallel one under a tMax of infinity.
template <class T>
std::optional<T> intersectPlane(const Vector<T>& normal, T distance, const RayOf<T>& ray) {
    const T t = (distance - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
    if (t <= ray.tMin || t > ray.tMax) return {};
    return t;
}

}
