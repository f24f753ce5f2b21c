#include "core/geometry/quadric.h"
#include "core/geometry/shapes.h"

namespace eyeray {
namespace {

constexpr std::uint32_t face(int axis, bool positive) {
    return 2U * static_cast<std::uint32_t>(axis) + (positive ? 1U : 0U);
}

struct Passage {
    Crossing in{-std::numeric_limits<double>::infinity(), 0};
    Crossing out{std::numeric_limits<double>::infinity(), 0};
};

// The part of the line inside the three slabs; `in` is behind `out` if there is none.
Passage passThrough(const Box& box, const Ray& ray) {
    Passage passage;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis], half = 0.5 * box.size[axis];
        const bool positive = !std::signbit(d); // ±0 then gives ∓∞ and ±∞ inside the slab
        // In a face and along it: 0/0 = NaN, which moves neither end.
        const double in = ((positive ? -half : half) - o) / d, out = ((positive ? half : -half) - o) / d;
        if (in > passage.in.t) passage.in = {in, face(axis, !positive)};
        if (out < passage.out.t) passage.out = {out, face(axis, positive)};
    }
    return passage;
}

}

std::optional<Hit> intersect(const Box& box, const Ray& ray) {
    const Passage passage = passThrough(box, ray);
    if (!(passage.in.t <= passage.out.t)) return {};
    return firstInside(ray, passage.in, passage.out);
}

SurfacePoint surfaceAt(const Box& box, const Ray& ray, const Hit& hit) {
    const Passage passage = passThrough(box, ray);
    const double t = passage.in.face == hit.primitive ? passage.in.t : passage.out.t;
    const DVec3 half = 0.5 * DVec3(box.size);
    const int axis = static_cast<int>(hit.primitive / 2);
    const double side = hit.primitive % 2 == 1 ? 1.0 : -1.0;
    DVec3 normal(0);
    normal[axis] = side;
    DVec3 position = glm::clamp(DVec3(ray.origin) + t * DVec3(ray.direction), -half, half);
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
