#pragma once
// Rays into the space of an object, normals out of it.

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// The ray in object space, its direction made a unit vector again. F21: t is then in units of the object, so
/// hits of objects of different scales are compared wrongly.
template <class T>
RayOf<T> toObject(const glm::mat<4, 4, T>& worldToObject, const RayOf<T>& ray) {
    RayOf<T> result(Vector<T>(worldToObject * glm::vec<4, T>(ray.origin, 1)),
                    glm::normalize(Vector<T>(worldToObject * glm::vec<4, T>(ray.direction, 0))));
    result.tMin = ray.tMin;
    result.tMax = ray.tMax;
    return result;
}

/// The normal turned by the matrix of the points. F22: right for rotations and even scales only; 78.58° off
/// where a sphere is squashed to a tenth.
template <class T>
Vector<T> toWorldNormal(const glm::mat<3, 3, T>& objectToWorld, const Vector<T>& normal) {
    return glm::normalize(objectToWorld * normal);
}

}
