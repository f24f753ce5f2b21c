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
    /// `world` is a box around all boxes that will be tested. `growth`: how far they grow on all sides, in
    /// units of the way from the origin to their farthest side.
    /// Inlined, so that it is compiled for the instruction set of the traversal.
    [[gnu::always_inline]] RaySlab(const Ray& ray, const Bounds& world, float growth = kGrowth)
        : tMin_(ray.tMin * kSooner) {
        const Four origin = four(ray.origin), direction = four(ray.direction);
        const Four below = origin - four(world.lo), above = four(world.hi) - origin;
        const Four farthest = below > above ? below : above;
        const float reach = std::max(farthest[0], std::max(farthest[1], farthest[2]));
        const Four inverse = 1.0F / direction, steepness = abs(inverse);
        const float least = std::min(steepness[0], std::min(steepness[1], steepness[2]));
        const Four steepest = Four{} + kSteepest * least;
        inverse_ = inverse < -steepest ? -steepest : inverse > steepest ? steepest : inverse;
        const Four grown = (growth * reach + kRounded * abs(origin)) * abs(inverse_);
        const Four atOrigin = origin * inverse_;
        toNear_ = atOrigin + (grown + kBefore * reach * least);
        toFar_ = atOrigin - (grown + kBehind * reach * least * kBesideLongest[longestAxis(ray.direction)]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            near_[axis] = std::bit_cast<std::uint32_t>(direction[axis]) >> 31U;
    }

    /// Least t in [tMin, limit] at which the ray is in the box, infinite if there is none. `corners` are its
    /// lower and upper one.
    float enter(const std::array<std::array<float, 3>, 2>& corners, float limit) const {
        float enters = tMin_, leaves = limit;
        for (std::size_t i = 0; i < 3; ++i) {
            const float t0 = corners[near_[i]][i] * inverse_[i] - toNear_[i];
            const float t1 = corners[1U - near_[i]][i] * inverse_[i] - toFar_[i];
            enters = t0 > enters ? t0 : enters;
            leaves = t1 < leaves ? t1 : leaves;
        }
        return enters <= leaves ? enters : kInfinity;
    }

    // The parts of the test, for one that takes many boxes at once: a side at x is met at inverse·x − toNear,
    // or toFar, where these hold the origin.
    float tMin() const { return tMin_; }
    std::size_t near(std::size_t axis) const { return near_[axis]; }
    float inverse(std::size_t axis) const { return inverse_[axis]; }
    float toNear(std::size_t axis) const { return toNear_[axis]; }
    float toFar(std::size_t axis) const { return toFar_[axis]; }

    // A ray's map to an instance rounds its direction by up to 12 units of 2⁻²⁴ of the way; and what shapes
    // take.
    static constexpr float kGrowth = 16 * 0x1p-24F;
    // Of triangles: what keeps a ray in the plane of a box's side, which counts as one of slope 1/kSteepest.
    static constexpr float kGrowthOfTriangles = 0x1p-32F;

    // Of a test with (x − origin)·inverse instead: rounding of three operations on either side, and what
    // stands for 1/0.
    static constexpr float kLater = 1.0F + 2.0F * gammaBound(3);
    static constexpr float kLargest = std::numeric_limits<float>::max();

private:
    static constexpr float kSteepest = 0x1p32F; // 1 / direction of any axis, by that of the longest
    // The shear of a triangle's vertices rounds, beside the longest axis, by up to 4 units of 2⁻²⁴ of their
    // distance along that axis times the slope of the ray. So boxes grow by the same t on either side.
    // Where the ray enters them it may be more: rounding of t and of the test itself.
    static constexpr float kBehind = 4.001F * 0x1p-24F, kBefore = 16 * 0x1p-24F;
    // Rounding of toNear and toFar, and of a product, each one unit of the origin's coordinate.
    static constexpr float kRounded = 3.001F * 0x1p-24F;
    static constexpr float kSooner = 1 - 8 * 0x1p-24F;

    // By axis, all three in one register; the fourth counts for nothing.
    using Four = float __attribute__((vector_size(16)));
    using Bits = std::uint32_t __attribute__((vector_size(16)));
    static constexpr std::array<Four, 3> kBesideLongest{Four{0, 1, 1}, Four{1, 0, 1}, Four{1, 1, 0}};
    static Four four(const Vec3& v) { return Four{v.x, v.y, v.z, v.z}; }
    static Four abs(Four v) { return std::bit_cast<Four>(std::bit_cast<Bits>(v) & 0x7fffffffU); }

    float tMin_;
    Four inverse_, toNear_, toFar_;
    std::array<std::size_t, 3> near_; // which corner the ray meets first on each axis
};

}
