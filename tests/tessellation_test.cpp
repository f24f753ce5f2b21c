// labels: unit
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "app/rayview/tessellation.h"

namespace eyeray {
namespace {

struct NamedShape {
    std::string name;
    Shape shape;
};

std::vector<NamedShape> solids() {
    return {{"sphere", Sphere{0.7F}},
            {"box", Box{{1, 2, 0.5F}}},
            {"cylinder", Cylinder{2, 0.5F, 0.5F}},
            {"frustum", Cylinder{1, 0.2F, 0.6F}},
            {"cone", Cylinder{1.5F, 0, 0.5F}},
            {"cone on its tip", Cylinder{1.5F, 0.5F, 0}}};
}

Vec3 corner(const SurfaceMesh& mesh, std::uint32_t vertex) { return mesh.vertices[vertex].position; }

Vec3 faceNormal(const SurfaceMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    return glm::cross(corner(mesh, t[1]) - corner(mesh, t[0]), corner(mesh, t[2]) - corner(mesh, t[0]));
}

/// The surface where a ray from far outside meets it first near `point`, coming against `normal`.
SurfacePoint metBefore(const Shape& shape, const Vec3& point, const Vec3& normal) {
    const Ray ray{point + 4.0F * normal, -normal};
    const auto hit = intersect(shape, ray);
    return hit ? surfaceAt(shape, ray, *hit) : SurfacePoint{};
}

TEST(Tessellation, OfASolidIsClosed) {
    for (const NamedShape& solid : solids()) {
        const SurfaceMesh mesh = tessellated(solid.shape, 24, 10);
        using Point = std::array<float, 3>;
        std::map<std::pair<Point, Point>, int> edges;
        const auto key = [&](std::uint32_t vertex) {
            const Vec3 p = corner(mesh, vertex) + Vec3(0); // −0 becomes 0
            return Point{p.x, p.y, p.z};
        };
        for (const auto& triangle : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const Point a = key(triangle[i]), b = key(triangle[(i + 1) % 3]);
                ++edges[{a, b}];
                --edges[{b, a}];
            }
        for (const auto& [edge, count] : edges) ASSERT_EQ(count, 0) << solid.name;
        EXPECT_GE(mesh.triangles.size(), 12U) << solid.name;
    }
}

TEST(Tessellation, FacesOutward) {
    for (const NamedShape& solid : solids()) {
        const SurfaceMesh mesh = tessellated(solid.shape, 24, 10);
        for (const auto& triangle : mesh.triangles) {
            const Vec3 normal = faceNormal(mesh, triangle);
            const Vec3 middle =
                (corner(mesh, triangle[0]) + corner(mesh, triangle[1]) + corner(mesh, triangle[2])) / 3.0F;
            ASSERT_GT(glm::dot(normal, middle), 0) << solid.name << ": all are convex around the origin";
            for (const std::uint32_t vertex : triangle)
                ASSERT_GT(glm::dot(normal, mesh.vertices[vertex].normal), 0) << solid.name;
        }
    }
}

TEST(Tessellation, HasItsVerticesOnTheSurfaceThatTheTracerHits) {
    for (const NamedShape& solid : solids()) {
        const SurfaceMesh mesh = tessellated(solid.shape, 20, 10);
        for (const SurfaceVertex& vertex : mesh.vertices) {
            EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-5) << solid.name;
            // a hair towards the middle, so that rays at edges and tips do not pass by
            const Vec3 inside = vertex.position - 1e-4F * glm::normalize(vertex.position);
            const SurfacePoint met = metBefore(solid.shape, inside, vertex.normal);
            EXPECT_NEAR(glm::length(met.position - vertex.position), 0, 1e-3) << solid.name;
        }
    }
}

TEST(Tessellation, HasTheTextureCoordinatesOfTheTracer) {
    for (const NamedShape& solid : solids()) {
        const SurfaceMesh mesh = tessellated(solid.shape, 20, 10);
        for (const auto& triangle : mesh.triangles) {
            Vec3 middle(0);
            Vec2 uv(0);
            for (const std::uint32_t vertex : triangle) {
                middle += mesh.vertices[vertex].position / 3.0F;
                uv += mesh.vertices[vertex].uv / 3.0F;
            }
            const Ray ray{middle + 4.0F * glm::normalize(faceNormal(mesh, triangle)),
                          -glm::normalize(faceNormal(mesh, triangle))};
            const auto hit = intersect(solid.shape, ray);
            ASSERT_TRUE(hit) << solid.name;
            const Vec2 traced =
                textureCoordinates(solid.shape, surfaceAt(solid.shape, ray, *hit), hit->primitive);
            // linear between corners, so a segment's width off near a pole or a tip
            ASSERT_NEAR(uv.x, traced.x, 0.06) << solid.name;
            ASSERT_NEAR(uv.y, traced.y, 0.06) << solid.name;
        }
    }
}

TEST(Tessellation, OfAnInfinitePlaneEndsAtItsReach) {
    const SurfaceMesh mesh = tessellated(Plane{kInfinity, 3}, 8, 25);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    float widest = 0, deepest = 0;
    for (const SurfaceVertex& vertex : mesh.vertices) {
        EXPECT_EQ(vertex.position.y, 0);
        EXPECT_EQ(vertex.uv, Vec2(vertex.position.x, vertex.position.z));
        widest = std::max(widest, vertex.position.x);
        deepest = std::max(deepest, vertex.position.z);
    }
    EXPECT_EQ(widest, 25);
    EXPECT_EQ(deepest, 1.5F);
    for (const auto& triangle : mesh.triangles) EXPECT_GT(faceNormal(mesh, triangle).y, 0);
}

TEST(Tessellation, OfAMeshIsTheMesh) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.uvs[0] = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    const SurfaceMesh surface = tessellated(mesh);
    EXPECT_EQ(surface.triangles, mesh.triangles);
    EXPECT_EQ(surface.vertices[1].position, mesh.positions[1]);
    EXPECT_EQ(surface.vertices[2].uv, mesh.uvs[0][2]);
    EXPECT_EQ(surface.vertices[2].color, Color(1));
}

}
}
