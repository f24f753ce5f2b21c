#pragma once
// Surfaces as triangles, for drawing with OpenGL.

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/shapes.h"

namespace eyeray {

struct SurfaceVertex {
    Vec3 position{0}, normal{0}; // the normal is unit, outward; (0, 0, 0) where triangles are flat
    Vec2 uv{0};                  // as textureCoordinates says, but past 1 where a texture goes round
    Color color{1};              // linear
};

struct SurfaceMesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles; // counter-clockwise seen from outside
};

/// Triangles whose corners lie on the shape: `segments` of them around it, at least 3. An infinite plane
/// ends at ±reach.
SurfaceMesh tessellated(const Shape&, int segments, float reach);

/// A mesh's own triangles, in their order.
SurfaceMesh tessellated(const TriangleMesh&);

}
