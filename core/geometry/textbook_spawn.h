#pragma once
// Where a ray that leaves a surface starts.

#include <cmath>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// `point` moved by the same distance everywhere, to the side of the normal that `direction` points to. F04:
/// with an epsilon of 0 the ray meets the surface that it leaves; F05: any other is too small in a big scene
/// and skips what lies close by in a small one. As in P. Shirley 2016, "Ray Tracing in One Weekend".
template <class T>
Vector<T> spawnOrigin(const Vector<T>& point, const Vector<T>& normal, const Vector<T>& direction,
                      T epsilon) {
    return point + std::copysign(epsilon, glm::dot(normal, direction)) * normal;
}

/// `point` moved by up to 256 floats per axis, near the origin by 2⁻¹⁶: C. Wächter, N. Binder 2019, "A Fast
/// and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6. F06: grows with the place
/// of the point, whereas the error of o + t·d grows with the distance of the eye.
inline Vec3 spawnOriginByUlps(const Vec3& point, const Vec3& normal, const Vec3& direction) {
    constexpr float kUlps = 256, kNearOrigin = 0x1p-5F, kNearOffset = 0x1p-16F;
    const Vec3 outward = std::copysign(1.0F, glm::dot(normal, direction)) * normal;
    Vec3 origin;
    for (int axis = 0; axis < 3; ++axis) {
        const auto steps = static_cast<std::int32_t>(kUlps * outward[axis]);
        const float p = point[axis];
        const auto moved =
            std::bit_cast<float>(std::bit_cast<std::int32_t>(p) + (std::signbit(p) ? -steps : steps));
        origin[axis] = std::abs(p) < kNearOrigin ? p + kNearOffset * outward[axis] : moved;
    }
    return origin;
}

}
