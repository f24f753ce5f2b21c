// How the indices of meshes and placed objects are built.

#include <algorithm>
#include <unordered_set>

#include "core/base/errors.h"
#include "core/geometry/accel.h"

namespace eyeray {
namespace {

template <class Index>
constexpr int kTrianglesPerLeaf = 4;
template <>
constexpr int kTrianglesPerLeaf<Bvh8> = Bvh8::kWidth; // one SIMD test takes them all
constexpr int kInstancesPerLeaf = 1;                  // mapping a ray to an instance costs more than a node

// Empty, so that no index takes it, unless it is finite and has an area.
Bounds indexedBounds(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    ENSURE(std::max({a, b, c}) < mesh.positions.size());
    const DVec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const DVec3 normal = glm::cross(q - p, r - p);
    return isFinite(normal) && normal != DVec3(0) ? boundsOf(mesh, triangle) : Bounds{};
}

template <class Index>
struct ObjectBounds {
    Bounds operator()(const Shape& shape) const { return boundsOf(shape); }
    Bounds operator()(const std::shared_ptr<const IndexedMesh<Index>>& mesh) const { return mesh->bounds; }
};

template <class Index>
bool unbounded(const Instance<Index>& instance) {
    const Shape* shape = std::get_if<Shape>(&instance.geometry);
    return shape != nullptr && !boundsOf(*shape).finite() && !boundsOf(*shape).empty();
}

}

template <class Index>
std::shared_ptr<const IndexedMesh<Index>> indexMesh(std::shared_ptr<const TriangleMesh> mesh,
                                                    const std::stop_token& stop) {
    std::vector<Bounds> boxes;
    Bounds bounds;
    boxes.reserve(mesh->triangles.size());
    for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i) {
        boxes.push_back(indexedBounds(*mesh, i));
        bounds.add(boxes.back());
    }
    Index index(boxes, kTrianglesPerLeaf<Index>, stop);
    LeafTriangles<Index> triangles(*mesh, index);
    return std::make_shared<const IndexedMesh<Index>>(
        IndexedMesh<Index>{std::move(mesh), std::move(index), std::move(triangles), bounds});
}

template <class Index>
Bounds boundsOf(const Instance<Index>& instance) {
    return instance.placement.worldBounds(std::visit(ObjectBounds<Index>{}, instance.geometry));
}

template <class Index>
IndexedGeometry<Index> indexInstances(std::vector<Instance<Index>> instances, const std::stop_token& stop) {
    IndexedGeometry<Index> result;
    std::vector<Bounds> boxes;
    std::vector<std::uint32_t> bounded;
    std::unordered_set<const IndexedMesh<Index>*> counted;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (unbounded(instances[i])) result.always.push_back(i);
        boxes.push_back(boundsOf(instances[i]));
        if (boxes.back().finite() && !boxes.back().empty()) bounded.push_back(i);
        const auto* mesh = std::get_if<1>(&instances[i].geometry);
        result.shapesOnly &= mesh == nullptr;
        result.primitives += mesh != nullptr ? (*mesh)->index.size() : 1;
        if (mesh == nullptr || !counted.insert(mesh->get()).second) continue;
        result.nodes += (*mesh)->index.nodeCount();
        result.bytes += (*mesh)->index.bytes() + (*mesh)->triangles.bytes();
    }
    result.instances = std::move(instances);
    if (bounded.size() == 1)
        result.always.push_back(bounded.front());
    else
        result.top = Index(boxes, kInstancesPerLeaf, stop);
    result.nodes += result.top.nodeCount();
    result.bytes += result.top.bytes();
    return result;
}

template std::shared_ptr<const IndexedMesh<BruteForce>> indexMesh(std::shared_ptr<const TriangleMesh>,
                                                                  const std::stop_token&);
template std::shared_ptr<const IndexedMesh<Bvh2>> indexMesh(std::shared_ptr<const TriangleMesh>,
                                                            const std::stop_token&);
template std::shared_ptr<const IndexedMesh<Bvh8>> indexMesh(std::shared_ptr<const TriangleMesh>,
                                                            const std::stop_token&);
template Bounds boundsOf(const Instance<BruteForce>&);
template Bounds boundsOf(const Instance<Bvh2>&);
template Bounds boundsOf(const Instance<Bvh8>&);
template IndexedGeometry<BruteForce> indexInstances(std::vector<Instance<BruteForce>>,
                                                    const std::stop_token&);
template IndexedGeometry<Bvh2> indexInstances(std::vector<Instance<Bvh2>>, const std::stop_token&);
template IndexedGeometry<Bvh8> indexInstances(std::vector<Instance<Bvh8>>, const std::stop_token&);

}
