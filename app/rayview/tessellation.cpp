#include "app/rayview/tessellation.h"

#include <algorithm>

#include "core/base/errors.h"

namespace eyeray {
namespace {

using Index = std::uint32_t;

/// Adds a grid of columns × rows cells; `vertex(s, t)` with s and t in [0, 1], s to the right and t down as
/// seen from outside.
template <class Vertex>
void addGrid(SurfaceMesh& mesh, int columns, int rows, const Vertex& vertex) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            mesh.vertices.push_back(vertex(static_cast<float>(column) / static_cast<float>(columns),
                                           static_cast<float>(row) / static_cast<float>(rows)));
    const auto stride = static_cast<Index>(columns + 1);
    const auto add = [&](Index a, Index b, Index c) {
        const auto at = [&](Index i) { return mesh.vertices[i].position; };
        if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a)) mesh.triangles.push_back({a, b, c});
    };
    for (Index row = 0; row < static_cast<Index>(rows); ++row)
        for (Index column = 0; column < static_cast<Index>(columns); ++column) {
            const Index corner = first + row * stride + column, below = corner + stride;
            add(corner, below, below + 1);
            add(corner, below + 1, corner + 1);
        }
}

/// Unit direction around the y axis at a share of a turn, as in textureCoordinates; the seam closes.
Vec2 around(float share) {
    if (share == 1) share = 0;
    const double angle = 2 * kPiD * (share - 0.5);
    return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

SurfaceMesh tessellate(const Sphere& sphere, int segments, float) {
    SurfaceMesh mesh;
    addGrid(mesh, segments, std::max(2, segments / 2), [&](float s, float t) {
        const Vec2 side = around(s);
        const bool pole = t == 0 || t == 1;
        const auto ring = pole ? 0.0F : static_cast<float>(std::sin(kPiD * t));
        const Vec3 normal(side.x * ring, std::cos(kPiD * t), side.y * ring);
        return SurfaceVertex{.position = sphere.radius * normal, .normal = normal, .uv = {s, t}};
    });
    return mesh;
}

SurfaceMesh tessellate(const Plane& plane, int segments, float reach) {
    const Vec2 half(std::isfinite(plane.sizeX) ? 0.5F * plane.sizeX : reach,
                    std::isfinite(plane.sizeZ) ? 0.5F * plane.sizeZ : reach);
    SurfaceMesh mesh;
    addGrid(mesh, plane.round ? segments : 1, 1, [&](float s, float t) {
        const Vec2 place = plane.round ? t * around(s) : 2.0F * Vec2(s, t) - 1.0F;
        const Vec2 at = place * half;
        return SurfaceVertex{.position = {at.x, 0, at.y}, .normal = {0, 1, 0}, .uv = at};
    });
    return mesh;
}

SurfaceMesh tessellate(const Box& box, int, float) {
    SurfaceMesh mesh;
    for (Index face = 0; face < 6; ++face) {
        const int axis = static_cast<int>(face / 2);
        const float side = face % 2 == 1 ? 1.0F : -1.0F;
        const int right = (axis + 1) % 3, down = (axis + 2) % 3;
        addGrid(mesh, 1, 1, [&](float s, float t) {
            SurfaceVertex vertex;
            vertex.normal[axis] = side;
            vertex.position[axis] = 0.5F * side * box.size[axis];
            vertex.position[right] = (s - 0.5F) * box.size[right];
            vertex.position[down] = (0.5F - t) * side * box.size[down];
            vertex.uv = textureCoordinates(box, {.position = vertex.position}, face);
            return vertex;
        });
    }
    return mesh;
}

void addCap(SurfaceMesh& mesh, const Cylinder& cylinder, int segments, bool top) {
    const float radius = top ? cylinder.radiusTop : cylinder.radiusBottom, side = top ? 1.0F : -1.0F;
    if (!(radius > 0)) return;
    const auto steps = static_cast<float>(segments);
    addGrid(mesh, segments, 1, [&](float s, float t) {
        // rounded, so that the rim has the very points of the side
        const Vec2 rim = t * radius * around(top ? s : std::round((1 - s) * steps) / steps);
        SurfaceVertex vertex{.position = {rim.x, 0.5F * side * cylinder.height, rim.y},
                             .normal = {0, side, 0}};
        vertex.uv = textureCoordinates(cylinder, {.position = vertex.position}, top ? 1U : 2U);
        return vertex;
    });
}

SurfaceMesh tessellate(const Cylinder& cylinder, int segments, float) {
    SurfaceMesh mesh;
    const Vec2 slope = glm::normalize(Vec2(cylinder.height, cylinder.radiusBottom - cylinder.radiusTop));
    addGrid(mesh, segments, 1, [&](float s, float t) {
        const Vec2 side = around(s);
        const float radius = t == 0 ? cylinder.radiusTop : cylinder.radiusBottom;
        return SurfaceVertex{.position = {radius * side.x, (0.5F - t) * cylinder.height, radius * side.y},
                             .normal = {slope.x * side.x, slope.y, slope.x * side.y},
                             .uv = {s, t}};
    });
    addCap(mesh, cylinder, segments, true);
    addCap(mesh, cylinder, segments, false);
    return mesh;
}

}

SurfaceMesh tessellated(const Shape& shape, int segments, float reach) {
    ENSURE(segments >= 3);
    return std::visit([&](const auto& s) { return tessellate(s, segments, reach); }, shape);
}

SurfaceMesh tessellated(const TriangleMesh& mesh) {
    SurfaceMesh surface;
    surface.triangles = mesh.triangles;
    surface.vertices.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        SurfaceVertex& vertex = surface.vertices[i];
        vertex.position = mesh.positions[i];
        if (!mesh.normals.empty()) vertex.normal = mesh.normals[i];
        if (!mesh.uvs[0].empty()) vertex.uv = mesh.uvs[0][i];
        if (!mesh.colors.empty()) vertex.color = Color(mesh.colors[i]);
    }
    return surface;
}

}
