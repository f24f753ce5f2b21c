#pragma once
// Triangles on the graphics card.

#include "app/gl/handle.h"
#include "app/rayview/tessellation.h"

namespace eyeray {

/// A SurfaceMesh, copied once. Attributes: 0 position, 1 normal, 2 uv, 3 color.
class GpuMesh {
public:
    GpuMesh(const Gl&, const SurfaceMesh&);
    void draw() const;

private:
    const Gl& gl_;
    Handle vertexArray_, vertices_, indices_;
    GLsizei count_;
};

}
