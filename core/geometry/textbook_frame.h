#pragma once
// Axes around a normal.

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

template <class T>
struct FrameOf {
    Vector<T> tangent, bitangent, normal;
};

/// J. R. Frisvad 2012, "Building an Orthonormal Basis from a 3D Unit Vector Without Normalization", Journal
/// of Graphics Tools 16(3). F24: 1 + n.z cancels close to −z, just before the branch that is to save it.
template <class T>
FrameOf<T> frameAround(const Vector<T>& n) {
    if (n.z < T(-0.9999999)) return {{0, -1, 0}, {-1, 0, 0}, n};
    const T a = 1 / (1 + n.z), b = -n.x * n.y * a;
    return {{1 - n.x * n.x * a, b, -n.x}, {b, 1 - n.y * n.y * a, -n.y}, n};
}

}
