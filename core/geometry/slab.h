#pragma once
// When a ray is inside a box: what the indices cull by.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/base/math.h"
#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"

namespace eyeray {

/// A ray prepared for tests against many boxes, which may answer yes in doubt, never no: T. Ize 2013, "Robust
/// BVH Ray Traversal", JCGT 2(2), for the rounding of the test itself; and boxes count as grown a little, so
/// that they hold whatever the leaf's own test finds in spite of its rounding.
class RaySlab {
public:
    /// `world` is a box around all boxes that will be tested.
    RaySlab(const Ray& ray, const Bounds& world) : tMin_(ray.tMin) {
        const float growth = kGrowth * reach(ray.origin, world);
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            inverse_[i] = finite(1.0F / ray.direction[axis]);
            inverseFar_[i] = finite(inverse_[i] * kLater);
            near_[i] = std::bit_cast<std::uint32_t>(ray.direction[axis]) >> 31U;
            const float outward = std::copysign(growth, ray.direction[axis]);
            originNear_[i] = ray.origin[axis] + outward;
            originFar_[i] = ray.origin[axis] - outward;
        }
    }

    /// Least t in [tMin, limit] at which the ray is in the box, infinite if there is none. `corners` are its
    /// lower and upper one.
    float enter(const std::array<std::array<float, 3>, 2>& corners, float limit) const {
        float enters = tMin_, leaves = limit;
        for (std::size_t i = 0; i < 3; ++i) {
            const float t0 = (corners[near_[i]][i] - originNear_[i]) * inverse_[i];
            const float t1 = (corners[1U - near_[i]][i] - originFar_[i]) * inverseFar_[i];
            enters = t0 > enters ? t0 : enters;
            leaves = t1 < leaves ? t1 : leaves;
        }
        return enters <= leaves ? enters : kInfinity;
    }

    // The parts of the test, for one that takes many boxes at once.
    float tMin() const { return tMin_; }
    std::size_t near(std::size_t axis) const { return near_[axis]; }
    float originNear(std::size_t axis) const { return originNear_[axis]; }
    float originFar(std::size_t axis) const { return originFar_[axis]; }
    float inverse(std::size_t axis) const { return inverse_[axis]; }
    /// A little more, for the sides where the ray leaves: so that rounding makes no box smaller.
    float inverseFar(std::size_t axis) const { return inverseFar_[axis]; }
    // Rounding of three operations on either side.
    static constexpr float kLater = 1.0F + 2.0F * gammaBound(3);
    // Stands for 1/0: so a ray in the plane of a face is at 0 there, not at 0·∞ = NaN.
    static constexpr float kLargest = std::numeric_limits<float>::max();
    // The shear of a triangle's vertices rounds by up to 4 units of 2⁻²⁴ of their distance, the ray's map to
    // an instance by up to 12.
    static constexpr float kGrowth = 16 * 0x1p-24F;

private:
    // Without branches, as all that is done for each ray: the signs of directions come at random.
    static float finite(float x) { return std::min(std::max(x, -kLargest), kLargest); }

    static float reach(const Vec3& origin, const Bounds& world) {
        const Vec3 farthest = glm::max(world.hi - origin, origin - world.lo);
        return std::max(farthest.x, std::max(farthest.y, farthest.z));
    }

    float tMin_;
    std::array<float, 3> originNear_, originFar_, inverse_, inverseFar_;
    std::array<std::size_t, 3> near_; // which corner the ray meets first on each axis
};

}
