#pragma once
// Everything that rays can hit, with an index that finds the candidates: brute force (the oracle), a binary
// BVH or a wide one with SIMD.

#include <memory>
#include <optional>
#include <stop_token>
#include <variant>
#include <vector>

#include "core/geometry/brute_force.h"
#include "core/geometry/bvh2.h"
#include "core/geometry/bvh8.h"
#include "core/geometry/leaf_triangles.h"
#include "core/geometry/mesh.h"
#include "core/geometry/placement.h"
#include "core/geometry/ray.h"
#include "core/geometry/shapes.h"
#include "core/geometry/traversal_log.h"

namespace eyeray {

/// Which instances a ray looks at; the surface of a lamp casts no shadow.
enum class RayMask : std::uint8_t { Opaque = 1, Transparent = 2, Lamp = 4, Objects = 3, All = 7 };

inline bool sees(RayMask ray, RayMask instance) {
    return (static_cast<unsigned>(ray) & static_cast<unsigned>(instance)) != 0;
}

/// A mesh with an index over its triangles; shared between Worlds while the mesh does not change.
template <class Index>
struct IndexedMesh {
    std::shared_ptr<const TriangleMesh> mesh;
    Index index;
    LeafTriangles<Index> triangles;
    Bounds bounds;
};

/// One placed object.
template <class Index>
struct Instance {
    Placement placement;
    std::variant<Shape, std::shared_ptr<const IndexedMesh<Index>>> geometry;
    RayMask mask = RayMask::Opaque;
};

template <class Index>
struct IndexedGeometry {
    std::vector<Instance<Index>> instances;
    Index top;                         // over the bounded instances, if there are several
    std::vector<std::uint32_t> always; // tested by every ray: infinite planes, and a single bounded instance
    std::optional<double> costBuilt;   // if the top level is refitted: of the tree when it was built
    bool shapesOnly = true;            // no mesh
    std::size_t primitives = 0;        // triangles and shapes, instances counted each
    std::size_t nodes = 0, bytes = 0;  // of the indices, meshes counted once
};

using Accel = std::variant<IndexedGeometry<BruteForce>, IndexedGeometry<Bvh2>, IndexedGeometry<Bvh8>>;

/// Index over the triangles of a mesh; triangles with a non-finite vertex or no area are left out, the others
/// keep their numbers. Throws InternalError for a vertex that does not exist. An empty index if `stop` was
/// requested.
template <class Index>
std::shared_ptr<const IndexedMesh<Index>> indexMesh(std::shared_ptr<const TriangleMesh>,
                                                    const std::stop_token&);

/// The world box of a placed object.
template <class Index>
Bounds boundsOf(const Instance<Index>&);

/// Top level over placed objects; those whose box is empty or not a number are never hit.
template <class Index>
IndexedGeometry<Index> indexInstances(std::vector<Instance<Index>>, const std::stop_token&);

/// The same, sooner, for objects that have moved since `before`, and of the same hits: with its tree, where
/// that holds the same instances and has not become half as costly again since it was built.
template <class Index>
IndexedGeometry<Index> refitInstances(std::vector<Instance<Index>>, const IndexedGeometry<Index>& before,
                                      const std::stop_token&);

/// Closest hit in (tMin, tMax) among the instances of the mask, or nothing. Equal t: the lower (instance,
/// primitive) wins, whatever the index. Thread-safe.
template <class Index>
std::optional<Hit> closestHit(const IndexedGeometry<Index>&, const Ray&, RayMask = RayMask::All);

/// True if anything of the mask is hit in (tMin, tMax). Thread-safe.
template <class Index>
bool anyHit(const IndexedGeometry<Index>&, const Ray&, RayMask = RayMask::All);

/// The same hits by the same way, with everything that the ray goes through put down.
template <class Index>
std::optional<Hit> closestHit(const IndexedGeometry<Index>&, const Ray&, RayMask, TraversalLog&);
template <class Index>
bool anyHit(const IndexedGeometry<Index>&, const Ray&, RayMask, TraversalLog&);

template <>
std::optional<Hit> closestHit(const IndexedGeometry<Bvh8>&, const Ray&, RayMask);
template <>
bool anyHit(const IndexedGeometry<Bvh8>&, const Ray&, RayMask);
template <>
std::optional<Hit> closestHit(const IndexedGeometry<Bvh8>&, const Ray&, RayMask, TraversalLog&);
template <>
bool anyHit(const IndexedGeometry<Bvh8>&, const Ray&, RayMask, TraversalLog&);

/// The surface at a hit that closestHit returned for this ray, in world space. The geometric normal is the
/// surface's own side also under mirroring transforms.
template <class Index>
SurfacePoint surfaceAt(const IndexedGeometry<Index>&, const Ray&, const Hit&);

/// Texture coordinates at a hit; `point` is its surfaceAt.
template <class Index>
Vec2 textureCoordinates(const IndexedGeometry<Index>&, const SurfacePoint& point, const Hit&, int set);

/// Vertex colour at a hit, (1, 1, 1, 1) where there is none.
template <class Index>
Vec4 vertexColor(const IndexedGeometry<Index>&, const Hit&);

}
