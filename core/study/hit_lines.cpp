#include "core/study/hit_lines.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include "core/transport/next_rays.h"

namespace eyeray {
namespace {

/// A ray as the tracer takes it.
struct TracedRay {
    Ray ray;
    int exponent; // the line's direction is 2^exponent times the ray's
};

// The longest component of the direction between 1 and 2: so floats hold it and t whatever its length, and as
// powers of two are exact, no digit of a hit changes.
TracedRay traced(const RayLine& line, const DVec3& origin) {
    const DVec3 size = glm::abs(line.direction);
    const int exponent = std::ilogb(std::max(size.x, std::max(size.y, size.z)));
    const auto shorter = [&](double x) { return static_cast<float>(std::scalbn(x, -exponent)); };
    const auto longer = [&](double t) { return static_cast<float>(std::scalbn(t, exponent)); };
    return {{.origin = Vec3(line.origin - origin),
             .direction = {shorter(line.direction.x), shorter(line.direction.y), shorter(line.direction.z)},
             .tMin = longer(line.tMin),
             .tMax = longer(line.tMax)},
            exponent};
}

template <class Index>
double boundingRadius(const IndexedGeometry<Index>& geometry, const DMat4& objectToScene, const Hit& hit) {
    const auto& placed = geometry.instances[hit.instance].geometry;
    if (const Shape* shape = std::get_if<Shape>(&placed)) {
        const Sphere* sphere = std::get_if<Sphere>(shape);
        const double radius =
            sphere != nullptr ? static_cast<double>(sphere->radius) : glm::length(DVec3(boundsOf(*shape).hi));
        const DMat3 m(objectToScene);
        return radius * std::max(glm::length(m[0]), std::max(glm::length(m[1]), glm::length(m[2])));
    }
    const TriangleCorners corners = cornersOf(*std::get<1>(placed)->mesh, hit.primitive);
    std::array<DVec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = transformVector(objectToScene, DVec3(corners[i][0], corners[i][1], corners[i][2]));
    const DVec3 center = (p[0] + p[1] + p[2]) / 3.0;
    return std::max(glm::distance(p[0], center),
                    std::max(glm::distance(p[1], center), glm::distance(p[2], center)));
}

/// What of the renderer's next rays from a hit, were its surface glass, meets the same face again at once.
template <class Index>
std::string_view spawned(const World& world, const IndexedGeometry<Index>& geometry, Ray ray) {
    const double length = glm::length(DVec3(ray.direction)); // the renderer's rays are of unit length
    ray = {ray.origin, Vec3(DVec3(ray.direction) / length), static_cast<float>(ray.tMin * length),
           static_cast<float>(ray.tMax * length)};
    const auto hit = closestHit(geometry, ray);
    if (!hit || world.objects[hit->instance].sceneObject < 0) return "- -\n"; // lamps send no ray on
    Surface glass;
    glass.dielectric = 1;
    glass.transmission = glass.refractable = Color(1);
    std::optional<Surface> own;
    ShadingPoint p = shadingPointAt<Features{}>(world, geometry, ray, *hit, own);
    p.surface = &glass;
    const NextRays next = nextRays(world, {}, p, {});
    const auto object = static_cast<std::size_t>(world.objects[hit->instance].sceneObject);
    const auto near =
        static_cast<float>(1e-4 * boundingRadius(geometry, world.scene->objects[object].transform, *hit));
    const auto meetsItself = [&](const Vec3& direction) {
        const auto again = closestHit(geometry, {spawnOrigin(p.at, direction), direction});
        return again && again->instance == hit->instance && again->primitive == hit->primitive &&
               again->t < near;
    };
    const bool mirrored = meetsItself(next.reflection);
    if (next.totalReflection) return mirrored ? "1 -\n" : "0 -\n";
    const bool refracted = meetsItself(next.refraction);
    return mirrored ? (refracted ? "1 1\n" : "1 0\n") : (refracted ? "0 1\n" : "0 0\n");
}

}

HitLines::HitLines(std::shared_ptr<const World> world, HitQuestion question)
    : world_(std::move(world)), question_(question) {
    const Scene& scene = *world_->scene;
    std::vector<Numbers> objects;
    std::uint64_t next = 0;
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<MeshId>(&object.geometry);
        objects.push_back({next, mesh != nullptr});
        next += mesh != nullptr
                    ? scene.meshes[static_cast<std::size_t>(mesh->index)].triangles->triangles.size()
                    : 1;
    }
    for (const WorldObject& instance : world_->objects)
        numbers_.push_back(instance.sceneObject >= 0 ? objects[static_cast<std::size_t>(instance.sceneObject)]
                                                     : Numbers{next++, false});
}

template <class Index>
void HitLines::answer(const IndexedGeometry<Index>& geometry, const RayLine& line,
                      std::string& answers) const {
    const auto [ray, exponent] = traced(line, world_->origin);
    switch (question_) {
    case HitQuestion::Any:
        answers += anyHit(geometry, ray) ? "1\n" : "0\n";
        return;
    case HitQuestion::Spawned:
        answers += spawned(*world_, geometry, ray);
        return;
    case HitQuestion::Closest:
        break;
    }
    const auto hit = closestHit(geometry, ray);
    if (!hit) {
        answers += "miss\n";
        return;
    }
    const Numbers& numbers = numbers_[hit->instance];
    const Vec3 normal = surfaceAt(geometry, ray, *hit).geometricNormal;
    fmt::format_to(std::back_inserter(answers), FMT_COMPILE("{:.9g} {} {:.9g} {:.9g} {:.9g}\n"),
                   std::scalbn(static_cast<double>(hit->t), -exponent),
                   numbers.first + (numbers.mesh ? hit->primitive : 0), normal.x, normal.y, normal.z);
}

void HitLines::answer(std::string_view lines, std::int64_t firstNumber, std::string& answers) const {
    std::visit(
        [&](const auto& geometry) {
            for (std::int64_t number = firstNumber; !lines.empty(); ++number) {
                const std::size_t end = std::min(lines.find('\n'), lines.size());
                if (const auto ray = parseRayLine(lines.substr(0, end), number))
                    answer(geometry, *ray, answers);
                lines.remove_prefix(std::min(end + 1, lines.size()));
            }
        },
        *world_->accel);
}

}
