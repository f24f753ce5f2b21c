#include "core/geometry/affine.h"

namespace eyeray {
namespace {

DMat3 absolute(const Mat3& m) {
    return {glm::abs(DVec3(m[0])), glm::abs(DVec3(m[1])), glm::abs(DVec3(m[2]))};
}

}

Vec3 mapError(const Affine& objectToWorld, const Affine& worldToObject, const Vec3& point) {
    const DMat3 there = absolute(objectToWorld.linear), back = absolute(worldToObject.linear);
    const DVec3 size = there * glm::abs(DVec3(point)) + glm::abs(DVec3(objectToWorld.translation));
    const DVec3 inObject = back * size + glm::abs(DVec3(worldToObject.translation));
    return Vec3(static_cast<double>(gammaBound(6)) * (there * inObject) +
                static_cast<double>(gammaBound(2)) * size);
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

SurfacePoint toWorld(const SurfacePoint& point, const Affine& objectToWorld, const Affine& worldToObject) {
    const DMat3 linear(objectToWorld.linear);
    const DMat3 normals = glm::transpose(DMat3(worldToObject.linear));
    SurfacePoint result;
    result.position = Vec3(linear * DVec3(point.position) + DVec3(objectToWorld.translation));
    result.error = Vec3(absolute(objectToWorld.linear) * DVec3(point.error)) +
                   mapError(objectToWorld, worldToObject, point.position);
    result.geometricNormal = Vec3(safeNormalize(normals * DVec3(point.geometricNormal)));
    result.shadingNormal = Vec3(safeNormalize(normals * DVec3(point.shadingNormal)));
    return result;
}

}
