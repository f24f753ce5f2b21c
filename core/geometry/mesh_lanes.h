// The surfaces at hits of a mesh, several at once, through the same steps as mesh.cpp takes one: the results
// are the same bits. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_MESH_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_MESH_LANES_H
#undef EYERAY_MESH_LANES_H
#else
#define EYERAY_MESH_LANES_H
#endif

#include <span>

#include "core/geometry/hit_lanes.h"
#include "core/geometry/mesh.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// What the vertices of the triangles that were hit have, by corner.
using CornerLanes = std::array<DVec3Lanes, 3>;

inline CornerLanes cornersAt(const TriangleMesh& mesh, std::span<const Vec3> values,
                             const SpreadInt& triangles, FloatMask asked) {
    Spread3 corners[3];
    eachLane(asked, [&](std::size_t lane) {
        const auto& vertices = mesh.triangles[triangles.at(lane)];
        for (std::size_t i = 0; i < 3; ++i) corners[i].set(lane, values[vertices[i]]);
    });
    return {widen(gathered(corners[0])), widen(gathered(corners[1])), widen(gathered(corners[2]))};
}

/// As safeNormalize where that needs no scaling, and not numbers elsewhere.
HWY_INLINE DVec3Lanes plainlyNormalized(const DVec3Lanes& v) {
    const auto square = dot(v, v);
    const auto plain = both(square > all(1e-280), square < all(1e280));
    return v * select(plain, all(1.0) / sqrt(square), all(std::numeric_limits<double>::quiet_NaN()));
}

/// Surfaces in object space, and the lanes that are not so plain: these go one by one.
struct MeshSurfaces {
    SurfaceLanes points;
    FloatMask others;
};

/// At hits of the `asked` rays of these directions, as surfaceAt.
inline MeshSurfaces surfacesOn(const TriangleMesh& mesh, const Vec3Lanes& direction, const HitLanes& hits,
                               FloatMask asked) {
    const FloatTag f;
    const SpreadInt triangles = spread(hits.primitive);
    const auto u = widen(hits.u), v = widen(hits.v);
    const std::array weights{all(1.0) - u - v, u, v};
    const auto interpolated = [&](const CornerLanes& at) HWY_ATTR {
        return at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2];
    };
    const CornerLanes positions = cornersAt(mesh, mesh.positions, triangles, asked);
    const DVec3Lanes position = interpolated(positions);
    const Vec3Lanes normal =
        narrow(plainlyNormalized(cross(positions[1] - positions[0], positions[2] - positions[0])));
    MeshSurfaces result{surfaceAt(position, normal), hn::And(hn::IsNaN(normal.x), asked)};
    if (mesh.normals.empty()) return result;
    const CornerLanes normals = cornersAt(mesh, mesh.normals, triangles, asked);
    const Vec3Lanes shading = narrow(plainlyNormalized(interpolated(normals)));
    result.others = hn::Or(result.others, hn::And(hn::IsNaN(shading.x), asked));
    SurfaceLanes& point = result.points;
    const auto zero = hn::Zero(f);
    const auto agree = dot(shading, normal) >= zero, front = dot(normal, direction) <= zero;
    const auto otherSide = hn::Xor(front, agree);
    const auto outward = widen(hn::IfThenElse(otherSide, all(-1.0F), all(1.0F))) > all(0.0);
    point.shadingNormal = select(agree, shading, -shading);
    DVec3Lanes lift = all(DVec3(0));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto height = dot(positions[i] - position, normals[i]);
        const auto lifts = either(both(outward, height > all(0.0)), butNot(outward, height <= all(0.0)));
        lift = select(lifts, lift + normals[i] * (weights[i] * height), lift);
    }
    point.lift = narrow(lift);
    return result;
}

}
HWY_AFTER_NAMESPACE();

#endif
