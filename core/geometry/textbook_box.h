#pragma once
// Which face of a box a point is on.

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// Sum of the normals of all faces of the box of half extents `half` around the origin that the point is
/// within `epsilon` of. F15: none in a big box, where the point is off by more, and several in a small one; a
/// unit vector for exactly one.
template <class T>
Vector<T> boxNormal(const Vector<T>& point, const Vector<T>& half, T epsilon) {
    Vector<T> normal(0);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(point[axis] - half[axis]) < epsilon) normal[axis] += 1;
        if (std::abs(point[axis] + half[axis]) < epsilon) normal[axis] -= 1;
    }
    return normal;
}

}
