#include "core/geometry/leaf_triangles.h"

namespace eyeray {

LeafTriangles<Bvh8>::LeafTriangles(const TriangleMesh& mesh, const Bvh8& index)
    : blocks_(index.entries().size() / Bvh8::kWidth) {
    for (std::size_t slot = 0; slot < blocks_.size() * Bvh8::kWidth; ++slot) {
        if (index.entries()[slot] == Bvh8::kNone) continue;
        const TriangleCorners triangle = cornersOf(mesh, index.entries()[slot]);
        TriangleBlock& block = blocks_[slot / Bvh8::kWidth];
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                block.corners[corner][axis][slot % Bvh8::kWidth] = triangle[corner][axis];
    }
}

}
