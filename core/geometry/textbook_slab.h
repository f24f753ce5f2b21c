#pragma once
// When a ray is inside a box. T. Kay, J. Kajiya 1986, "Ray Tracing Complex Scenes".

#include <algorithm>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// By std::min and std::max. F12: 0·∞ = NaN for an origin in the plane of a face that the ray runs along, and
/// whether NaN or the other value survives depends on the order of the arguments; F14: rounding rejects rays
/// that touch an edge.
template <class T>
bool meetsSlabs(const Vector<T>& lo, const Vector<T>& hi, const RayOf<T>& ray) {
    T enters = ray.tMin, leaves = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const T inverse = 1 / ray.direction[axis];
        const T a = (lo[axis] - ray.origin[axis]) * inverse, b = (hi[axis] - ray.origin[axis]) * inverse;
        enters = std::max(std::min(a, b), enters);
        leaves = std::min(std::max(a, b), leaves);
    }
    return enters <= leaves;
}

/// Breaking off as soon as nothing is left: P. Shirley 2016, "Ray Tracing: The Next Week". F13: `leaves <=
/// enters` rejects every ray at a box without thickness.
template <class T>
bool meetsThickSlabs(const Vector<T>& lo, const Vector<T>& hi, const RayOf<T>& ray) {
    T enters = ray.tMin, leaves = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const T inverse = 1 / ray.direction[axis];
        T a = (lo[axis] - ray.origin[axis]) * inverse, b = (hi[axis] - ray.origin[axis]) * inverse;
        if (inverse < 0) std::swap(a, b);
        enters = a > enters ? a : enters;
        leaves = b < leaves ? b : leaves;
        if (leaves <= enters) return false;
    }
    return true;
}

}
