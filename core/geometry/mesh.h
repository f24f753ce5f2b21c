#pragma once
// Triangle meshes.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"
#include "core/geometry/triangle.h"

namespace eyeray {

inline constexpr int kUvSets = 4;

/// Indexed triangles; counter-clockwise is the front. Optional arrays are empty or one per vertex. Shared as
/// shared_ptr<const TriangleMesh>: never changed once it is in a Scene.
struct TriangleMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;                  // unit
    std::array<std::vector<Vec2>, kUvSets> uvs; // TEXCOORD_0 to TEXCOORD_3
    std::vector<Vec4> colors;                   // linear RGBA
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool doubleSided = true; // else the back is not hit
};

/// Corners of one triangle of a mesh.
TriangleCorners cornersOf(const TriangleMesh&, std::uint32_t triangle);

/// Closest hit of one triangle in (tMin, tMax), or nothing; see intersectCorners.
std::optional<Hit> intersectTriangle(const TriangleMesh&, std::uint32_t triangle, const RayShear&,
                                     const Ray&);

/// The surface at a hit of a ray of this direction, in object space: position by barycentric weights, with
/// its error bound. It is lifted to the planes through the corners across their normals, weighed alike:
/// Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II, chapter 4.
SurfacePoint surfaceAt(const TriangleMesh&, const Vec3& direction, const Hit&);

/// Interpolated texture coordinates of one set; (0, 0) if the mesh has none.
Vec2 textureCoordinates(const TriangleMesh&, const Hit&, int set);

/// Interpolated vertex colour; (1, 1, 1, 1) if the mesh has none.
Vec4 vertexColor(const TriangleMesh&, const Hit&);

Bounds boundsOf(const TriangleMesh&, std::uint32_t triangle);
Bounds boundsOf(const TriangleMesh&);

}
