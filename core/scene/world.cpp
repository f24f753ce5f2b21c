#include "core/scene/world.h"

#include <chrono>
#include <type_traits>
#include <unordered_map>

#include "core/geometry/same_instances.h"
#include "core/scene/choose_index.h"
#include "core/scene/touching_glass.h"

namespace eyeray {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

template <class T>
const T& at(const std::vector<T>& values, int id) {
    return values[static_cast<std::size_t>(id)];
}

WorldMaterial prepared(const Material& material) {
    const MaterialNeeds needs = needsOf(material.model);
    return {.surface = std::visit([](const auto& model) { return surfaceOf(model); }, material.model),
            .physical = std::visit([](const auto& model) { return physicalOf(model); }, material.model),
            .varies = needs.textured,
            .transmits = needs.transmits,
            .model = material.model};
}

DMat4 relativeTo(const DVec3& origin, DMat4 transform) {
    transform[3] -= DVec4(origin, 0);
    return transform;
}

bool invertible(const DMat4& m) {
    const double determinant = glm::determinant(DMat3(m));
    return std::isfinite(determinant) && determinant != 0;
}

/// What may be taken over from another World.
struct Reuse {
    const World* previous = nullptr;
    bool refits = false; // also its tree, over objects that have moved
};

/// Builds the instances of one World, in scene order.
template <class Index>
class Builder {
public:
    Builder(const Scene& scene, World& world, const Reuse& reuse, std::stop_token stop)
        : scene_(scene), world_(world), refits_(reuse.refits), stop_(std::move(stop)) {
        const std::size_t most = scene.objects.size() + scene.lights.size();
        instances_.reserve(most);
        world_.objects.reserve(most);
        if (reuse.previous == nullptr) return;
        if (!std::holds_alternative<IndexedGeometry<Index>>(*reuse.previous->accel)) return;
        previous_ = reuse.previous->accel;
        for (const auto& instance : geometryIn(*previous_).instances)
            if (const auto* mesh = std::get_if<std::shared_ptr<const IndexedMesh<Index>>>(&instance.geometry))
                meshes_.emplace((*mesh)->mesh.get(), *mesh);
    }

    void add(const Object& object, int id) {
        if (!object.visible || !invertible(object.transform)) return;
        const WorldMaterial& material = at(world_.materials, object.material);
        const bool vertexColors = std::visit(
            Overloaded{[&](MeshId mesh) { return !at(scene_.meshes, mesh.index).triangles->colors.empty(); },
                       [](ShapeId) { return false; }},
            object.geometry);
        if (material.transmits && solid(object))
            glass_.push_back(
                {static_cast<std::uint32_t>(instances_.size()), relativeTo(world_.origin, object.transform)});
        place(object.transform, geometryOf(object),
              material.transmits ? RayMask::Transparent : RayMask::Opaque,
              {.material = static_cast<std::uint32_t>(object.material),
               .sceneObject = id,
               .solid = solid(object),
               .vertexColors = vertexColors});
    }

    /// The glowing surface of an area lamp.
    void addLamp(const Light& light, int id) {
        const DMat4 yAxisToMinusZ{DVec4(1, 0, 0, 0), DVec4(0, 0, -1, 0), DVec4(0, 1, 0, 0),
                                  DVec4(0, 0, 0, 1)};
        if (!light.enabled || light.followsCamera || !invertible(light.transform)) return;
        const auto lamp = [&](const Shape& shape, const DMat4& transform) {
            WorldMaterial glowing;
            glowing.surface.emission = light.color * static_cast<float>(light.intensity);
            glowing.physical.emission = glowing.surface.emission;
            world_.materials.push_back(glowing);
            place(transform, shape, RayMask::Lamp,
                  {.material = static_cast<std::uint32_t>(world_.materials.size() - 1), .sceneLight = id});
        };
        std::visit(
            Overloaded{
                [&](const RectangleLamp& r) {
                    lamp(Plane{static_cast<float>(r.width), static_cast<float>(r.height), false},
                         light.transform * yAxisToMinusZ);
                },
                [&](const DiscLamp& d) {
                    const auto size = static_cast<float>(2 * d.radius);
                    lamp(Plane{size, size, false, true}, light.transform * yAxisToMinusZ);
                },
                [&](const SphereLamp& s) { lamp(Sphere{static_cast<float>(s.radius)}, light.transform); },
                [](const auto&) {}},
            light.shape);
    }

    std::shared_ptr<const Accel> finish() {
        rankGlass();
        joinTouchingGlass(instances_, glass_, stop_);
        auto accel = canShare() ? previous_ : std::make_shared<const Accel>(indexed());
        const auto& geometry = geometryIn(*accel);
        world_.refitted = geometry.costBuilt.has_value();
        world_.primitives = geometry.primitives;
        world_.bytes = geometry.bytes;
        world_.nodes = geometry.nodes;
        return accel;
    }

private:
    using Geometry = decltype(Instance<Index>::geometry);
    using MeshMap = std::unordered_map<const TriangleMesh*, std::shared_ptr<const IndexedMesh<Index>>>;

    static const IndexedGeometry<Index>& geometryIn(const Accel& accel) {
        return std::get<IndexedGeometry<Index>>(accel);
    }

    bool canShare() const {
        return previous_ != nullptr && (refits_ || !geometryIn(*previous_).costBuilt) &&
               sameInstances<Index>(geometryIn(*previous_).instances, instances_);
    }

    IndexedGeometry<Index> indexed() {
        return refits_ && previous_ != nullptr
                   ? refitInstances(std::move(instances_), geometryIn(*previous_), stop_)
                   : indexInstances(std::move(instances_), stop_);
    }

    bool solid(const Object& object) const {
        return std::visit(Overloaded{[](MeshId) { return true; },
                                     [&](ShapeId shape) { return isSolid(at(scene_.shapes, shape.index)); }},
                          object.geometry);
    }

    /// Smaller solids rank higher: what lies wholly in another is what is there, and a ball half in water is
    /// of glass all through. After C. Schmidt, B. Budge 2002, "Simple Nested Dielectrics in Ray Traced
    /// Images", JGT 7(2), whose priorities the modeller has to give.
    void rankGlass() {
        std::vector<std::pair<float, std::uint32_t>> bySize; // and the instance
        bySize.reserve(glass_.size());
        for (const GlassSolid& solid : glass_)
            bySize.emplace_back(-boundsOf(instances_[solid.instance]).halfArea(), solid.instance);
        std::ranges::sort(bySize);
        for (std::uint32_t rank = 0; rank < bySize.size(); ++rank)
            world_.objects[bySize[rank].second].rank = rank;
    }

    Geometry geometryOf(const Object& object) {
        return std::visit(
            Overloaded{[&](MeshId mesh) -> Geometry { return indexed(at(scene_.meshes, mesh.index)); },
                       [&](ShapeId shape) -> Geometry { return at(scene_.shapes, shape.index); }},
            object.geometry);
    }

    std::shared_ptr<const IndexedMesh<Index>> indexed(const Mesh& mesh) {
        auto& entry = meshes_[mesh.triangles.get()];
        if (entry == nullptr) entry = indexMesh<Index>(mesh.triangles, stop_);
        return entry;
    }

    void place(const DMat4& transform, Geometry geometry, RayMask mask, const WorldObject& object) {
        instances_.push_back({.placement = Placement(relativeTo(world_.origin, transform)),
                              .geometry = std::move(geometry),
                              .mask = mask});
        world_.objects.push_back(object);
    }

    const Scene& scene_;
    World& world_;
    bool refits_;
    std::stop_token stop_;
    std::shared_ptr<const Accel> previous_; // of the same kind
    MeshMap meshes_;
    std::vector<Instance<Index>> instances_;
    std::vector<GlassSolid> glass_;
};

struct LampEmission {
    WorldLight::Kind kind;
    double factor; // from color·intensity to emission
    double cosInner = 1, cosOuter = 0;
};

// The surface of an area lamp, and so its power, grows with its node: `map` is that node's.
LampEmission emissionOf(const PointLamp&, const DMat3&) { return {WorldLight::Kind::Point, 1}; }
LampEmission emissionOf(const DirectionalLamp&, const DMat3&) { return {WorldLight::Kind::Directional, 1}; }
LampEmission emissionOf(const SpotLamp& s, const DMat3&) {
    return {WorldLight::Kind::Spot, 1, std::cos(s.innerCone), std::cos(s.outerCone)};
}
LampEmission emissionOf(const RectangleLamp& r, const DMat3& map) {
    return {WorldLight::Kind::Facing, r.width * r.height * glm::length(glm::cross(map[0], map[1]))};
}
LampEmission emissionOf(const DiscLamp& d, const DMat3& map) {
    return {WorldLight::Kind::Facing, kPiD * d.radius * d.radius * glm::length(glm::cross(map[0], map[1]))};
}
LampEmission emissionOf(const SphereLamp& s, const DMat3& map) {
    const double scale = std::cbrt(std::fabs(glm::determinant(map)));
    return {WorldLight::Kind::Point, kPiD * s.radius * s.radius * scale * scale};
}

WorldLight prepared(const Light& light, int id, const DVec3& origin) {
    const LampEmission lamp =
        std::visit([&](const auto& shape) { return emissionOf(shape, DMat3(light.transform)); }, light.shape);
    const DVec3 position = DVec3(light.transform[3]) - (light.followsCamera ? DVec3(0) : origin);
    const double factor = light.falloff ? lamp.factor : kPiD; // a taught lamp: normal irradiance π·c
    return {.kind = lamp.kind,
            .position = position,
            .direction = safeNormalize(transformVector(light.transform, DVec3(0, 0, -1))),
            .emission = light.color * static_cast<float>(light.intensity * factor),
            .falloff = light.falloff,
            .cosInner = static_cast<float>(lamp.cosInner),
            .cosOuter = static_cast<float>(lamp.cosOuter),
            .range = static_cast<float>(light.range),
            .sceneLight = id,
            .followsCamera = light.followsCamera};
}

template <class Index>
std::shared_ptr<const Accel> index(const Scene& scene, World& world, const Reuse& reuse,
                                   const std::stop_token& stop) {
    Builder<Index> builder(scene, world, reuse, stop);
    for (std::size_t i = 0; i < scene.objects.size() && !stop.stop_requested(); ++i)
        builder.add(scene.objects[i], static_cast<int>(i));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        builder.addLamp(scene.lights[i], static_cast<int>(i));
    return builder.finish();
}

std::shared_ptr<const World> build(const std::shared_ptr<const Scene>& shared, const BuildSettings& settings,
                                   const Reuse& reuse, const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    const Scene& scene = *shared;
    auto world = std::make_shared<World>();
    world->scene = shared;
    const SceneBounds bounds = boundsOf(scene);
    world->origin = bounds.empty() ? scene.cameras.front().eye : bounds.center();
    world->radius = static_cast<float>(bounds.radius());
    world->needs = analyseNeeds(scene);
    world->materials.reserve(scene.materials.size() + scene.lights.size());
    for (const Material& material : scene.materials) world->materials.push_back(prepared(material));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled && scene.lights[i].intensity > 0)
            world->lights.push_back(prepared(scene.lights[i], static_cast<int>(i), world->origin));

    world->accelKind = chooseIndex(scene, settings);
    if (world->accelKind == AccelKind::Brute)
        world->accel = index<BruteForce>(scene, *world, reuse, stop);
    else if (world->accelKind == AccelKind::Bvh2)
        world->accel = index<Bvh2>(scene, *world, reuse, stop);
    else
        world->accel = index<Bvh8>(scene, *world, reuse, stop);
    if (stop.stop_requested()) return nullptr;
    world->buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return world;
}

}

std::shared_ptr<const World> buildWorld(const std::shared_ptr<const Scene>& scene,
                                        const BuildSettings& settings, const World* previous,
                                        const std::stop_token& stop) {
    return build(scene, settings, {previous}, stop);
}

std::shared_ptr<const World> refitWorld(const std::shared_ptr<const Scene>& scene,
                                        const BuildSettings& settings, const World& previous,
                                        const std::stop_token& stop) {
    return build(scene, settings, {&previous, true}, stop);
}

}
