#include "core/geometry/textbook_geometry.h"

#include <unordered_map>

#include "core/geometry/nearest_hit.h"
#include "core/geometry/textbook_slab.h"
#include "core/geometry/textbook_sphere.h"
#include "core/geometry/textbook_transform.h"
#include "core/geometry/textbook_triangle.h"

namespace eyeray {
namespace {

using Meshes = std::unordered_map<const TriangleMesh*, std::shared_ptr<const IndexedMesh<Bvh2>>>;

/// The box test of textbooks in the place of RaySlab.
class NanSlab {
public:
    NanSlab(const Ray& ray, const Bounds&) : ray_(ray) {}

    float enter(const std::array<std::array<float, 3>, 2>& corners, float limit) const {
        textbook::RayOf<float> ray(ray_);
        ray.tMax = limit;
        const auto vector = [](const std::array<float, 3>& c) { return Vec3(c[0], c[1], c[2]); };
        return textbook::meetsSlabs(vector(corners[0]), vector(corners[1]), ray) ? ray_.tMin : kInfinity;
    }

private:
    const Ray& ray_;
};

/// Floats are relative to another place than the World's origin.
Placement moved(const Placement& placement, const DVec3& by) {
    const Affine& map = placement.objectToWorld();
    DMat4 transform{DMat3(map.linear)};
    transform[3] = DVec4(DVec3(map.translation) + by, 1);
    return Placement(transform);
}

template <class T>
std::optional<Hit> meetsSphere(const Sphere& sphere, const Ray& ray) {
    const auto t = textbook::intersectSphere<T>(static_cast<T>(sphere.radius), textbook::RayOf<T>(ray));
    return t ? std::optional(Hit{.t = static_cast<float>(*t)}) : std::nullopt;
}

template <class T>
std::optional<Hit> meetsTriangle(const TriangleCorners& corners, bool doubleSided, const Ray& ray) {
    const auto vector = [](const std::array<float, 3>& c) { return textbook::Vector<T>(c[0], c[1], c[2]); };
    const textbook::Corners<T> vertices{vector(corners[0]), vector(corners[1]), vector(corners[2])};
    const textbook::RayOf<T> wide(ray);
    const auto normal = glm::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    if (!doubleSided && !(glm::dot(normal, wide.direction) < 0)) return {};
    const auto hit =
        textbook::intersectTriangle<T>(vertices, wide, static_cast<T>(textbook::kMollerTrumboreEpsilon));
    if (!hit) return {};
    return Hit{
        .t = static_cast<float>(hit->t), .u = static_cast<float>(hit->u), .v = static_cast<float>(hit->v)};
}

/// How rays meet one World's objects.
class Rules {
public:
    explicit Rules(const TextbookGeometry& geometry) : geometry_(geometry) {}

    bool has(Fault fault) const { return geometry_.faults.has(fault); }

    Ray start(Ray ray) const {
        if (has(Fault::FloatWorld)) ray.origin += geometry_.moved;
        if (has(Fault::GlobalEpsilon)) ray.tMin = std::max(ray.tMin, geometry_.epsilon);
        return ray;
    }

    Ray toObject(const Placement& placement, const Ray& ray) const {
        Ray local = placement.toObject(ray);
        if (has(Fault::ObjectRayNormalised)) local.direction = glm::normalize(local.direction);
        return local;
    }

    std::optional<Hit> meets(const Shape& shape, const Ray& ray) const {
        const auto* const sphere = std::get_if<Sphere>(&shape);
        if (sphere == nullptr || !has(Fault::SphereSlide)) return intersect(shape, ray);
        return geometry_.inDouble ? meetsSphere<double>(*sphere, ray) : meetsSphere<float>(*sphere, ray);
    }

    std::optional<Hit> meets(const TriangleCorners& corners, bool doubleSided, const RayShear& shear,
                             const Ray& ray, float limit) const {
        if (!has(Fault::MollerTrumbore))
            return intersectCorners(corners, doubleSided, shear, ray.tMin, limit);
        Ray shortened = ray;
        shortened.tMax = limit;
        return geometry_.inDouble ? meetsTriangle<double>(corners, doubleSided, shortened)
                                  : meetsTriangle<float>(corners, doubleSided, shortened);
    }

    template <class Test>
    bool visit(const Bvh2& index, const Ray& ray, const float& limit, const Test& test) const {
        return has(Fault::SlabNan) ? index.visit<NanSlab>(ray, limit, test) : index.visit(ray, limit, test);
    }

private:
    const TextbookGeometry& geometry_;
};

// Calls offer(hit) for hits at t in (tMin, limit) until it returns true; whether it did.
template <class Offer>
bool visitHits(const Rules& rules, const Instance<Bvh2>& instance, std::uint32_t id, const Ray& ray,
               const float& limit, const Offer& offer) {
    Ray local = rules.toObject(instance.placement, ray);
    local.tMax = limit;
    if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
        auto hit = rules.meets(*shape, local);
        if (!hit) return false;
        hit->instance = id;
        return offer(*hit);
    }
    const IndexedMesh<Bvh2>& mesh = **std::get_if<1>(&instance.geometry);
    const RayShear shear(local);
    return rules.visit(mesh.index, local, limit, [&](std::uint32_t slot) {
        auto hit = rules.meets(mesh.triangles.at(slot), mesh.mesh->doubleSided, shear, local, limit);
        if (!hit) return false;
        hit->primitive = mesh.index.entries()[slot];
        hit->instance = id;
        return offer(*hit);
    });
}

template <class Offer>
bool visitHits(const TextbookGeometry& geometry, const Ray& ray, RayMask mask, const float& limit,
               const Offer& offer) {
    const Rules rules(geometry);
    const IndexedGeometry<Bvh2>& placed = geometry.placed;
    const auto inInstance = [&](std::uint32_t id) {
        const Instance<Bvh2>& instance = placed.instances[id];
        return sees(mask, instance.mask) && visitHits(rules, instance, id, ray, limit, offer);
    };
    for (const std::uint32_t id : placed.always)
        if (inInstance(id)) return true;
    return rules.visit(placed.top, ray, limit,
                       [&](std::uint32_t slot) { return inInstance(placed.top.entries()[slot]); });
}

template <class T>
Vec3 pointOnRay(const Ray& ray, float t) {
    return Vec3(textbook::RayOf<T>(ray).at(static_cast<T>(t)));
}

Vec3 normalByMatrix(const Placement& placement, const Vec3& normal) {
    return textbook::toWorldNormal<float>(placement.objectToWorld().linear, normal);
}

/// The surface in object space, with the formula's own point on it.
SurfacePoint pointOf(const Rules& rules, const Instance<Bvh2>& instance, const Ray& local, const Hit& hit) {
    if (const auto* mesh = std::get_if<1>(&instance.geometry))
        return surfaceAt(*(*mesh)->mesh, local.direction, hit);
    const Shape& shape = *std::get_if<Shape>(&instance.geometry);
    if (std::holds_alternative<Sphere>(shape) && rules.has(Fault::SphereSlide)) {
        const Vec3 point = local.at(hit.t);
        return surfacePoint(DVec3(point), DVec3(glm::normalize(point)));
    }
    return surfaceAt(shape, local, hit);
}

}

std::shared_ptr<const TextbookGeometry> textbookGeometry(const Accel& accel, const DVec3& origin,
                                                         FaultSet faults, float epsilon, bool inDouble) {
    const DVec3 by = faults.has(Fault::FloatWorld) ? origin : DVec3(0);
    std::vector<Instance<Bvh2>> instances;
    Meshes meshes;
    std::visit(
        [&](const auto& geometry) {
            for (const auto& instance : geometry.instances) {
                Instance<Bvh2> copy;
                copy.placement = moved(instance.placement, by);
                copy.mask = instance.mask;
                if (const Shape* shape = std::get_if<Shape>(&instance.geometry)) {
                    copy.geometry = *shape;
                } else {
                    const auto& mesh = (*std::get_if<1>(&instance.geometry))->mesh;
                    auto& indexed = meshes[mesh.get()];
                    if (indexed == nullptr) indexed = indexMesh<Bvh2>(mesh, {});
                    copy.geometry = indexed;
                }
                instances.push_back(std::move(copy));
            }
        },
        accel);
    return std::make_shared<const TextbookGeometry>(
        TextbookGeometry{.faults = faults,
                         .epsilon = epsilon,
                         .inDouble = inDouble,
                         .moved = Vec3(by),
                         .placed = indexInstances<Bvh2>(std::move(instances), {})});
}

template <>
std::optional<Hit> closestHit(const TextbookGeometry& geometry, const Ray& asked, RayMask mask) {
    const Ray ray = Rules(geometry).start(asked);
    NearestHit nearest(ray);
    visitHits(geometry, ray, mask, nearest.limit(), [&](const Hit& hit) {
        nearest.offer(hit);
        return false;
    });
    return nearest.get();
}

template <>
bool anyHit(const TextbookGeometry& geometry, const Ray& asked, RayMask mask) {
    const Ray ray = Rules(geometry).start(asked);
    return visitHits(geometry, ray, mask, ray.tMax, [](const Hit&) { return true; });
}

template <>
SurfacePoint surfaceAt(const TextbookGeometry& geometry, const Ray& asked, const Hit& hit) {
    const Rules rules(geometry);
    const Ray ray = rules.start(asked);
    const Instance<Bvh2>& instance = geometry.placed.instances[hit.instance];
    const SurfacePoint local = pointOf(rules, instance, rules.toObject(instance.placement, ray), hit);
    SurfacePoint point = instance.placement.toWorld(local);
    if (rules.has(Fault::NormalsByMatrix)) {
        point.geometricNormal = normalByMatrix(instance.placement, local.geometricNormal);
        point.shadingNormal = normalByMatrix(instance.placement, local.shadingNormal);
    }
    const bool onRay = rules.has(Fault::GlobalEpsilon) || rules.has(Fault::SolidChecker);
    if (onRay)
        point.position = geometry.inDouble ? pointOnRay<double>(ray, hit.t) : pointOnRay<float>(ray, hit.t);
    if (rules.has(Fault::GlobalEpsilon)) point.error = Vec3(0); // a next ray starts right here
    if (rules.has(Fault::GlobalEpsilon) || rules.has(Fault::HardTerminator)) point.lift = Vec3(0);
    point.position -= rules.has(Fault::FloatWorld) ? geometry.moved : Vec3(0);
    return point;
}

template <>
Vec2 textureCoordinates(const TextbookGeometry& geometry, const SurfacePoint& point, const Hit& hit,
                        int set) {
    SurfacePoint placed = point;
    placed.position += geometry.moved;
    Vec2 uv = textureCoordinates(geometry.placed, placed, hit, set);
    if (!geometry.faults.has(Fault::SolidChecker)) return uv;
    const Instance<Bvh2>& instance = geometry.placed.instances[hit.instance];
    const Shape* const shape = std::get_if<Shape>(&instance.geometry);
    if (shape != nullptr && std::holds_alternative<Plane>(*shape))
        uv.x += std::floor(instance.placement.toObject(placed.position).y);
    return uv;
}

template <>
Vec4 vertexColor(const TextbookGeometry& geometry, const Hit& hit) {
    return vertexColor(geometry.placed, hit);
}

}
