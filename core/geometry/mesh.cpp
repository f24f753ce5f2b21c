#include "core/geometry/mesh.h"

namespace eyeray {
namespace {

// Weighted sum of one array's values at the corners of the triangle that was hit, in double.
template <class Wide, class Value>
Wide interpolate(const TriangleMesh& mesh, const std::vector<Value>& values, const Hit& hit) {
    const auto& [a, b, c] = mesh.triangles[hit.primitive];
    const double u = hit.u, v = hit.v;
    return (1.0 - u - v) * Wide(values[a]) + u * Wide(values[b]) + v * Wide(values[c]);
}

DVec3 faceNormal(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const DVec3 origin(mesh.positions[a]);
    return safeNormalize(glm::cross(DVec3(mesh.positions[b]) - origin, DVec3(mesh.positions[c]) - origin));
}

// To the planes through the corners across their normals, those of them that lie where the normals point, or
// else behind.
DVec3 liftOf(const TriangleMesh& mesh, const DVec3& position, bool outward, const Hit& hit) {
    const auto& corners = mesh.triangles[hit.primitive];
    const double u = hit.u, v = hit.v;
    const std::array<double, 3> weights = {1.0 - u - v, u, v};
    DVec3 lift(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const DVec3 normal(mesh.normals[corners[i]]);
        const double height = glm::dot(DVec3(mesh.positions[corners[i]]) - position, normal);
        if ((height > 0) == outward) lift += weights[i] * height * normal;
    }
    return lift;
}

}

TriangleCorners cornersOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {toArray(mesh.positions[a]), toArray(mesh.positions[b]), toArray(mesh.positions[c])};
}

std::optional<Hit> intersectTriangle(const TriangleMesh& mesh, std::uint32_t triangle, const RayShear& shear,
                                     const Ray& ray) {
    auto hit = intersectCorners(cornersOf(mesh, triangle), mesh.doubleSided, shear, ray.tMin, ray.tMax);
    if (hit) hit->primitive = triangle;
    return hit;
}

SurfacePoint surfaceAt(const TriangleMesh& mesh, const Vec3& direction, const Hit& hit) {
    const DVec3 position = interpolate<DVec3>(mesh, mesh.positions, hit);
    SurfacePoint point = surfacePoint(position, faceNormal(mesh, hit.primitive));
    if (mesh.normals.empty()) return point;
    const Vec3 shading(safeNormalize(interpolate<DVec3>(mesh, mesh.normals, hit)));
    if (shading == Vec3(0)) return point;
    const bool agree = glm::dot(shading, point.geometricNormal) >= 0;
    const bool front = glm::dot(point.geometricNormal, direction) <= 0;
    point.shadingNormal = agree ? shading : -shading;
    point.lift = Vec3(liftOf(mesh, position, front == agree, hit));
    return point;
}

Vec2 textureCoordinates(const TriangleMesh& mesh, const Hit& hit, int set) {
    const auto& uvs = mesh.uvs.at(static_cast<std::size_t>(set));
    return uvs.empty() ? Vec2(0) : Vec2(interpolate<DVec2>(mesh, uvs, hit));
}

Vec4 vertexColor(const TriangleMesh& mesh, const Hit& hit) {
    return mesh.colors.empty() ? Vec4(1) : Vec4(interpolate<DVec4>(mesh, mesh.colors, hit));
}

Bounds boundsOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    Bounds box;
    for (const std::uint32_t vertex : mesh.triangles[triangle]) box.add(mesh.positions[vertex]);
    return box;
}

Bounds boundsOf(const TriangleMesh& mesh) {
    Bounds box;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) box.add(boundsOf(mesh, i));
    return box;
}

}
