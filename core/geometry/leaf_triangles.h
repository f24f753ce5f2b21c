#pragma once
// The corners of the triangles at the slots of an index: a leaf reads one stretch of memory.

#include <vector>

#include "core/geometry/bvh8.h"
#include "core/geometry/mesh.h"
#include "core/geometry/triangle.h"

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

    /// The corners of one, along the axes of a RayShear.
    TriangleCorners turned(std::size_t lane, const std::array<std::size_t, 3>& axes) const {
        const auto corner = [&](const auto& at) -> std::array<float, 3> {
            return {at[axes[0]][lane], at[axes[1]][lane], at[axes[2]][lane]};
        };
        return {corner(corners[0]), corner(corners[1]), corner(corners[2])};
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
