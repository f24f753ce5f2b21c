#pragma once
// The corners of the triangles at the slots of an index: a leaf reads one stretch of memory.

#include <vector>

#include "core/geometry/bvh8.h"
#include "core/geometry/mesh.h"

namespace eyeray {

/// One triangle after the other.
template <class Index>
class LeafTriangles {
public:
    LeafTriangles(const TriangleMesh& mesh, const Index& index) {
        corners_.reserve(index.entries().size());
        for (const std::uint32_t triangle : index.entries()) corners_.push_back(cornersOf(mesh, triangle));
    }

    const TriangleCorners& at(std::uint32_t slot) const { return corners_[slot]; }
    std::size_t bytes() const { return corners_.size() * sizeof(TriangleCorners); }

private:
    std::vector<TriangleCorners> corners_;
};

/// Up to eight triangles side by side: by corner, by axis, by triangle.
struct alignas(32) TriangleBlock {
    std::array<std::array<std::array<float, Bvh8::kWidth>, 3>, 3> corners;

    TriangleCorners triangle(std::size_t lane) const {
        TriangleCorners result;
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis) result[corner][axis] = corners[corner][axis][lane];
        return result;
    }
};

/// A block for each leaf, hence eight slots for each.
template <>
class LeafTriangles<Bvh8> {
public:
    LeafTriangles(const TriangleMesh&, const Bvh8&);

    const TriangleBlock& block(std::uint32_t firstSlot) const { return blocks_[firstSlot / Bvh8::kWidth]; }
    std::size_t bytes() const { return blocks_.size() * sizeof(TriangleBlock); }

private:
    std::vector<TriangleBlock> blocks_;
};

}
