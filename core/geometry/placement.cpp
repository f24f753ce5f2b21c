#include "core/geometry/placement.h"

namespace eyeray {
namespace {

// Covers the rounding of the few float operations that apply a bound.
constexpr double kSlack = 1 + 0x1p-20;

DMat3 absolute(const Mat3& m) {
    return {glm::abs(DVec3(m[0])), glm::abs(DVec3(m[1])), glm::abs(DVec3(m[2]))};
}

double largestEntry(const DMat3& m) {
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::fabs(m[column][row]));
    return largest;
}

// The signs of the diagonal of a map that scales all axes alike and may mirror some; else zero.
Vec3 mirrorsOf(const Mat3& m) {
    const float scale = std::fabs(m[0][0]);
    const Vec3 signs(std::copysign(1.0F, m[0][0]), std::copysign(1.0F, m[1][1]),
                     std::copysign(1.0F, m[2][2]));
    const Mat3 even(Vec3(scale * signs.x, 0, 0), Vec3(0, scale * signs.y, 0), Vec3(0, 0, scale * signs.z));
    return scale > 0 && m == even ? signs : Vec3(0);
}

}

Placement::Placement(const DMat4& objectToWorld)
    : objectToWorld_(Affine::from(objectToWorld)), worldToObject_(Affine::from(glm::inverse(objectToWorld))) {
    const DMat3 normals = glm::transpose(DMat3(worldToObject_.linear));
    normals_ = Mat3(normals / largestEntry(normals));
    translates_ = objectToWorld_.linear == Mat3(1);
    mirrors_ = mirrorsOf(objectToWorld_.linear);

    const DMat3 there = absolute(objectToWorld_.linear), back = absolute(worldToObject_.linear);
    const DVec3 moved = glm::abs(DVec3(objectToWorld_.translation));
    const DVec3 movedBack = glm::abs(DVec3(worldToObject_.translation));
    const double way = kSlack * gammaBound(6), result = kSlack * gammaBound(2);
    errorGrowth_ = Mat3(way * (there * back * there) + result * there);
    errorBase_ = Vec3(way * (there * (back * moved + movedBack)) + result * moved);
}

Bounds Placement::worldBounds(const Bounds& object) const {
    Bounds world = boundsOf(objectToWorld_, object);
    if (!world.finite()) return world;
    const Vec3 error = errorAt(glm::max(glm::abs(object.lo), glm::abs(object.hi)));
    world.lo -= error;
    world.hi += error;
    return world;
}

}
