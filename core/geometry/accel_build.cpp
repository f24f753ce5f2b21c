// How the indices of meshes and placed objects are built.

#include <algorithm>
#include <type_traits>
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

namespace {

constexpr double kWorstRefit = 1.5; // times the cost of the tree as it was built

/// What a top level is to be made of.
struct Boxes {
    std::vector<Bounds> all;
    std::vector<std::uint32_t> bounded; // those that go into it
};

bool indexed(const Bounds& box) { return box.finite() && !box.empty(); }

/// All but the top level.
template <class Index>
IndexedGeometry<Index> withoutTop(std::vector<Instance<Index>> instances, Boxes& boxes) {
    IndexedGeometry<Index> result;
    std::unordered_set<const IndexedMesh<Index>*> counted;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (unbounded(instances[i])) result.always.push_back(i);
        boxes.all.push_back(boundsOf(instances[i]));
        if (indexed(boxes.all.back())) boxes.bounded.push_back(i);
        const auto* mesh = std::get_if<1>(&instances[i].geometry);
        result.shapesOnly &= mesh == nullptr;
        result.primitives += mesh != nullptr ? (*mesh)->index.size() : 1;
        if (mesh == nullptr || !counted.insert(mesh->get()).second) continue;
        result.nodes += (*mesh)->index.nodeCount();
        result.bytes += (*mesh)->index.bytes() + (*mesh)->triangles.bytes();
    }
    result.instances = std::move(instances);
    return result;
}

template <class Index>
void setTop(Index top, IndexedGeometry<Index>& geometry) {
    geometry.top = std::move(top);
    geometry.nodes += geometry.top.nodeCount();
    geometry.bytes += geometry.top.bytes();
}

template <class Index>
void buildTop(const Boxes& boxes, IndexedGeometry<Index>& geometry, const std::stop_token& stop) {
    if (boxes.bounded.size() == 1)
        geometry.always.push_back(boxes.bounded.front());
    else
        setTop(Index(boxes.all, kInstancesPerLeaf, stop), geometry);
}

/// True if the index is over these boxes and no others.
template <class Index>
bool holds(const Index& index, const Boxes& boxes) {
    const auto isThere = [&](std::uint32_t entry) {
        return entry < boxes.all.size() && indexed(boxes.all[entry]);
    };
    return index.size() == boxes.bounded.size() && std::ranges::all_of(index.entries(), isThere);
}

/// Puts the tree of `before` on top, if it can serve; whether it does.
template <class Index>
bool refitTop(const Boxes& boxes, const IndexedGeometry<Index>& before, IndexedGeometry<Index>& geometry) {
    if (before.top.nodeCount() == 0 || !holds(before.top, boxes)) return false;
    Index top = before.top;
    const double built = before.costBuilt ? *before.costBuilt : top.cost();
    top.refit(boxes.all);
    if (!(top.cost() <= kWorstRefit * built)) return false;
    geometry.costBuilt = built;
    setTop(std::move(top), geometry);
    return true;
}

}

template <class Index>
IndexedGeometry<Index> indexInstances(std::vector<Instance<Index>> instances, const std::stop_token& stop) {
    Boxes boxes;
    IndexedGeometry<Index> result = withoutTop(std::move(instances), boxes);
    buildTop(boxes, result, stop);
    return result;
}

template <class Index>
IndexedGeometry<Index> refitInstances(std::vector<Instance<Index>> instances,
                                      const IndexedGeometry<Index>& before, const std::stop_token& stop) {
    Boxes boxes;
    IndexedGeometry<Index> result = withoutTop(std::move(instances), boxes);
    if constexpr (!std::is_same_v<Index, BruteForce>)
        if (refitTop(boxes, before, result)) return result;
    buildTop(boxes, result, stop);
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
template IndexedGeometry<BruteForce>
refitInstances(std::vector<Instance<BruteForce>>, const IndexedGeometry<BruteForce>&, const std::stop_token&);
template IndexedGeometry<Bvh2> refitInstances(std::vector<Instance<Bvh2>>, const IndexedGeometry<Bvh2>&,
                                              const std::stop_token&);
template IndexedGeometry<Bvh8> refitInstances(std::vector<Instance<Bvh8>>, const IndexedGeometry<Bvh8>&,
                                              const std::stop_token&);

}
