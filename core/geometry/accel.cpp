#include "core/geometry/accel.h"

#include "core/geometry/nearest_hit.h"

namespace eyeray {
namespace {

// Calls offer(hit) for hits at t in (tMin, limit) until it returns true; whether it did.
template <class Index, class Offer, class Log>
bool visitHits(const Instance<Index>& instance, std::uint32_t id, const Ray& ray, const float& limit,
               const Offer& offer, Log log) {
    Ray local = instance.placement.toObject(ray);
    local.tMax = limit;
    if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
        log.shape(id);
        auto hit = intersect(*shape, local);
        if (!hit) return false;
        hit->instance = id;
        return offer(*hit);
    }
    const IndexedMesh<Index>& mesh = **std::get_if<1>(&instance.geometry);
    const RayShear shear(local);
    const bool doubleSided = mesh.mesh->doubleSided;
    const auto inMesh = log.into(id);
    const auto test = [&](std::uint32_t slot) {
        inMesh.triangle(mesh.index.entries()[slot]);
        auto hit = intersectCorners(mesh.triangles.at(slot), doubleSided, shear, local.tMin, limit);
        if (!hit) return false;
        hit->primitive = mesh.index.entries()[slot];
        hit->instance = id;
        return offer(*hit);
    };
    return mesh.index.visit(local, limit, test, inMesh);
}

template <class Index, class Offer, class Log>
bool visitHits(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask, const float& limit,
               const Offer& offer, Log log) {
    const auto inInstance = [&](std::uint32_t id) {
        const Instance<Index>& instance = geometry.instances[id];
        return sees(mask, instance.mask) && visitHits(instance, id, ray, limit, offer, log);
    };
    for (const std::uint32_t id : geometry.always)
        if (inInstance(id)) return true;
    return geometry.top.visit(
        ray, limit, [&](std::uint32_t slot) { return inInstance(geometry.top.entries()[slot]); }, log);
}

template <class Index, class Log>
std::optional<Hit> closest(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask, Log log) {
    NearestHit nearest(ray);
    const auto offer = [&](const Hit& hit) {
        nearest.offer(hit);
        return false;
    };
    visitHits(geometry, ray, mask, nearest.limit(), offer, log);
    return nearest.get();
}

template <class Index, class Log>
bool any(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask, Log log) {
    return visitHits(geometry, ray, mask, ray.tMax, [](const Hit&) { return true; }, log);
}

// The mesh that was hit, or nullptr for a shape.
template <class Index>
const TriangleMesh* meshOf(const IndexedGeometry<Index>& geometry, const Hit& hit) {
    const auto* mesh = std::get_if<1>(&geometry.instances[hit.instance].geometry);
    return mesh != nullptr ? (*mesh)->mesh.get() : nullptr;
}

}

template <class Index>
std::optional<Hit> closestHit(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask) {
    return closest(geometry, ray, mask, Unwatched{});
}

template <class Index>
bool anyHit(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask) {
    return any(geometry, ray, mask, Unwatched{});
}

template <class Index>
std::optional<Hit> closestHit(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask,
                              TraversalLog& log) {
    return closest(geometry, ray, mask, Watched(log));
}

template <class Index>
bool anyHit(const IndexedGeometry<Index>& geometry, const Ray& ray, RayMask mask, TraversalLog& log) {
    return any(geometry, ray, mask, Watched(log));
}

template <class Index>
SurfacePoint surfaceAt(const IndexedGeometry<Index>& geometry, const Ray& ray, const Hit& hit) {
    const Instance<Index>& instance = geometry.instances[hit.instance];
    const TriangleMesh* mesh = meshOf(geometry, hit);
    const Ray local = instance.placement.toObject(ray);
    return instance.placement.toWorld(mesh != nullptr
                                          ? surfaceAt(*mesh, local.direction, hit)
                                          : surfaceAt(*std::get_if<Shape>(&instance.geometry), local, hit));
}

template <class Index>
Vec2 textureCoordinates(const IndexedGeometry<Index>& geometry, const SurfacePoint& point, const Hit& hit,
                        int set) {
    if (const TriangleMesh* mesh = meshOf(geometry, hit)) return textureCoordinates(*mesh, hit, set);
    const Instance<Index>& instance = geometry.instances[hit.instance];
    SurfacePoint local;
    local.position = instance.placement.toObject(point.position);
    return textureCoordinates(std::get<Shape>(instance.geometry), local, hit.primitive);
}

template <class Index>
Vec4 vertexColor(const IndexedGeometry<Index>& geometry, const Hit& hit) {
    const TriangleMesh* mesh = meshOf(geometry, hit);
    return mesh != nullptr ? vertexColor(*mesh, hit) : Vec4(1);
}

template std::optional<Hit> closestHit(const IndexedGeometry<BruteForce>&, const Ray&, RayMask);
template bool anyHit(const IndexedGeometry<BruteForce>&, const Ray&, RayMask);
template std::optional<Hit> closestHit(const IndexedGeometry<BruteForce>&, const Ray&, RayMask,
                                       TraversalLog&);
template bool anyHit(const IndexedGeometry<BruteForce>&, const Ray&, RayMask, TraversalLog&);
template SurfacePoint surfaceAt(const IndexedGeometry<BruteForce>&, const Ray&, const Hit&);
template Vec2 textureCoordinates(const IndexedGeometry<BruteForce>&, const SurfacePoint&, const Hit&, int);
template Vec4 vertexColor(const IndexedGeometry<BruteForce>&, const Hit&);

template std::optional<Hit> closestHit(const IndexedGeometry<Bvh2>&, const Ray&, RayMask);
template bool anyHit(const IndexedGeometry<Bvh2>&, const Ray&, RayMask);
template std::optional<Hit> closestHit(const IndexedGeometry<Bvh2>&, const Ray&, RayMask, TraversalLog&);
template bool anyHit(const IndexedGeometry<Bvh2>&, const Ray&, RayMask, TraversalLog&);
template SurfacePoint surfaceAt(const IndexedGeometry<Bvh2>&, const Ray&, const Hit&);
template Vec2 textureCoordinates(const IndexedGeometry<Bvh2>&, const SurfacePoint&, const Hit&, int);
template Vec4 vertexColor(const IndexedGeometry<Bvh2>&, const Hit&);

template SurfacePoint surfaceAt(const IndexedGeometry<Bvh8>&, const Ray&, const Hit&);
template Vec2 textureCoordinates(const IndexedGeometry<Bvh8>&, const SurfacePoint&, const Hit&, int);
template Vec4 vertexColor(const IndexedGeometry<Bvh8>&, const Hit&);

}
