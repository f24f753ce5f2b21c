#include "core/geometry/shapes.h"
#include "core/geometry/solid.h"

namespace eyeray {
namespace {

constexpr std::uint32_t face(int axis, bool positive) {
    return 2U * static_cast<std::uint32_t>(axis) + (positive ? 1U : 0U);
}

Passage passThrough(const Box& box, const Ray& ray) {
    Passage passage;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis], half = 0.5 * box.size[axis];
        if (d == 0) {
            if (std::fabs(o) <= half) continue;
            return kNoPassage;
        }
        const double lower = (-half - o) / d, upper = (half - o) / d;
        const bool positive = d > 0;
        const double in = positive ? lower : upper, out = positive ? upper : lower;
        if (!(in <= out)) return kNoPassage; // not a number
        if (in > passage.in.t) passage.in = {in, face(axis, !positive)};
        if (out < passage.out.t) passage.out = {out, face(axis, positive)};
    }
    return passage;
}

}

std::optional<Hit> intersect(const Box& box, const Ray& ray) { return firstEnd(passThrough(box, ray), ray); }

SurfacePoint surfaceAt(const Box& box, const Ray& ray, const Hit& hit) {
    const DVec3 half = 0.5 * DVec3(box.size);
    const int axis = static_cast<int>(hit.primitive / 2);
    const double side = hit.primitive % 2 == 1 ? 1.0 : -1.0;
    DVec3 normal(0);
    normal[axis] = side;
    DVec3 position = glm::clamp(pointAtHit(ray, hit), -half, half);
    position[axis] = side * half[axis];
    return surfacePoint(position, normal);
}

Vec2 textureCoordinates(const Box& box, const SurfacePoint& point, std::uint32_t face) {
    const auto share = [&](int axis, float sign) {
        const float size = box.size[axis];
        return size > 0 ? std::clamp(0.5F + sign * point.position[axis] / size, 0.0F, 1.0F) : 0.5F;
    };
    switch (face) { // upright as seen from outside, from the top left
    case 0:
        return {share(2, 1), share(1, -1)};
    case 1:
        return {share(2, -1), share(1, -1)};
    case 2:
        return {share(0, 1), share(2, -1)};
    case 3:
        return {share(0, 1), share(2, 1)};
    case 4:
        return {share(0, -1), share(1, -1)};
    default:
        return {share(0, 1), share(1, -1)};
    }
}

}
