#include "core/geometry/affine.h"

namespace eyeray {
namespace {

DMat3 absolute(const Mat3& m) {
    return {glm::abs(DVec3(m[0])), glm::abs(DVec3(m[1])), glm::abs(DVec3(m[2]))};
}

}

Bounds boundsOf(const Affine& map, const Bounds& box) {
    if (box.empty()) return box;
    const DVec3 lo(box.lo), hi(box.hi);
    const DVec3 center = DMat3(map.linear) * (0.5 * (lo + hi)) + DVec3(map.translation);
    const DVec3 half = absolute(map.linear) * (0.5 * (hi - lo));
    Bounds result;
    for (int axis = 0; axis < 3; ++axis) {
        // From double to float moves by half a unit in the last place; the next float covers it.
        result.lo[axis] = std::nextafter(static_cast<float>(center[axis] - half[axis]), -kInfinity);
        result.hi[axis] = std::nextafter(static_cast<float>(center[axis] + half[axis]), kInfinity);
    }
    return result;
}

}
