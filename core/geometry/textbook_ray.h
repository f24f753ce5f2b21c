#pragma once
// A ray in the number type that a formula is tried in. The files textbook_*.h hold formulas as they are
// taught, each with the failure (F01 to F64 of tests/STABILITY.md) that it shows: for comparison only.

#include <limits>

#include "core/geometry/ray.h"

namespace eyeray::textbook {

template <class T>
using Vector = glm::vec<3, T>;

template <class T>
struct RayOf {
    Vector<T> origin{0}, direction{0, 0, -1};
    T tMin = 0, tMax = std::numeric_limits<T>::infinity();

    RayOf() = default;
    RayOf(const Vector<T>& o, const Vector<T>& d) : origin(o), direction(d) {}
    explicit RayOf(const Ray& ray)
        : origin(ray.origin), direction(ray.direction), tMin(ray.tMin), tMax(ray.tMax) {}

    Vector<T> at(T t) const { return origin + t * direction; }
    bool holds(T t) const { return t > tMin && t < tMax; }
};

}
