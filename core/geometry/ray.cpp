#include "core/geometry/ray.h"

namespace eyeray {

Vec3 spawnOrigin(const SurfacePoint& point, const Vec3& direction) {
    const Vec3& normal = point.geometricNormal;
    const float distance = glm::dot(glm::abs(normal), point.error) * kSpawnSlack;
    const Vec3 offset = std::copysign(distance, glm::dot(normal, direction)) * normal;
    const Vec3 origin = point.position + offset;
    const auto outward = [&](int axis) {
        return offset[axis] == 0 ? origin[axis] : nextTowards(origin[axis], offset[axis] > 0);
    };
    return {outward(0), outward(1), outward(2)};
}

}
