#include "core/geometry/ray.h"

namespace eyeray {

SurfacePoint surfacePoint(const DVec3& position, const DVec3& unitNormal) {
    const Vec3 p(position), n(unitNormal);
    return {.position = p, .error = gammaBound(1) * glm::abs(p), .geometricNormal = n, .shadingNormal = n};
}

Vec3 spawnOrigin(const SurfacePoint& point, const Vec3& direction) {
    const DVec3 normal(point.geometricNormal);
    const double side = glm::dot(normal, DVec3(direction)) < 0 ? -1.0 : 1.0;
    const double distance = glm::dot(glm::abs(normal), DVec3(point.error));
    Vec3 origin;
    for (int axis = 0; axis < 3; ++axis) {
        const double offset = side * distance * normal[axis];
        origin[axis] = static_cast<float>(point.position[axis] + offset);
        if (offset != 0) origin[axis] = nextTowards(origin[axis], offset > 0);
    }
    return origin;
}

}
