#include "core/transport/glowing_objects.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

namespace eyeray {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

/// Unit normal of a face on the side that `front` looks to.
DVec3 normalOf(const DVec3& edgeA, const DVec3& edgeB, const DVec3& front) {
    const DVec3 normal = safeNormalize(glm::cross(edgeA, edgeB));
    return glm::dot(normal, front) < 0 ? -normal : normal;
}

}

template <class Side>
GlowingFlat<Side>::GlowingFlat(const DMat4& place, const DVec3& center, const DVec3& x, const DVec3& y,
                               const DVec3& front, bool bothSides)
    : GlowingFlat(transformPoint(place, center), DMat3(place) * x, DMat3(place) * y, DMat3(place) * front,
                  bothSides) {}

template <class Side>
GlowingFlat<Side>::GlowingFlat(const DVec3& center, const DVec3& x, const DVec3& y, const DVec3& front,
                               bool bothSides)
    : center_(center), normal_(normalOf(x, y, front)),
      front_(center, x, glm::dot(glm::cross(x, y), front) < 0 ? -y : y),
      back_(center, x, glm::dot(glm::cross(x, y), front) < 0 ? y : -y), bothSides_(bothSides) {}

template <class Side>
const Side& GlowingFlat<Side>::sideTowards(const Vec3& from) const {
    return bothSides_ && glm::dot(normal_, DVec3(from) - center_) < 0 ? back_ : front_;
}

template <class Side>
std::optional<ShapeSample> GlowingFlat<Side>::sample(const Vec3& from, const Vec2& u) const {
    return sideTowards(from).sample(from, u);
}

template <class Side>
float GlowingFlat<Side>::pdfW(const Vec3& from, const Vec3& wi) const {
    return sideTowards(from).pdfW(from, wi);
}

GlowingTriangle::GlowingTriangle(const DVec3& corner, const DVec3& edgeA, const DVec3& edgeB,
                                 const DVec3& front, bool bothSides)
    : corner_(corner), edgeA_(edgeA), edgeB_(edgeB), normal_(normalOf(edgeA, edgeB, front)),
      area_(0.5 * glm::length(glm::cross(edgeA, edgeB))), bothSides_(bothSides) {}

float GlowingTriangle::densityAt(double distance, double cosine) const {
    const double facing = bothSides_ ? std::fabs(cosine) : cosine;
    return facing > 0 ? static_cast<float>(distance * distance / (facing * area_)) : 0;
}

std::optional<ShapeSample> GlowingTriangle::sample(const Vec3& from, const Vec2& u) const {
    const double x = u.x, y = u.y;
    const double a = y > x ? x / 2 : x - y / 2, b = y > x ? y - x / 2 : y / 2;
    const DVec3 to = corner_ + a * edgeA_ + b * edgeB_ - DVec3(from);
    const double distance = glm::length(to);
    const double cosine = -glm::dot(normal_, to) / distance;
    const float density = densityAt(distance, cosine);
    if (!(density > 0)) return std::nullopt;
    return ShapeSample{.wi = Vec3(to / distance),
                       .distance = static_cast<float>(distance),
                       .pdfW = density,
                       .emitterCosine = static_cast<float>(std::fabs(cosine))};
}

float GlowingTriangle::pdfW(const Vec3& from, const Vec3& wi) const {
    const double cosine = -glm::dot(normal_, DVec3(wi));
    return densityAt(glm::dot(normal_, DVec3(from) - corner_) / cosine, cosine);
}

GlowingObjects::GlowingObjects(const World& world) : ofInstance_(world.objects.size(), -1) {
    for (std::uint32_t i = 0; i < world.objects.size(); ++i) {
        const WorldObject& object = world.objects[i];
        const WorldMaterial& material = world.materials[object.material];
        const bool even = !material.varies && !object.vertexColors;
        if (object.sceneObject >= 0 && even && !isBlack(material.physical.emission)) add(world, i);
    }
    double sum = 0;
    for (const Part& part : parts_) sum += part.probability; // still its power
    double below = 0;
    for (Part& part : parts_) {
        part.probability = static_cast<float>(part.probability / sum);
        below += part.probability;
        below_.push_back(static_cast<float>(below));
    }
}

void GlowingObjects::add(const World& world, std::uint32_t instance) {
    const WorldObject& worldObject = world.objects[instance];
    const Color radiance = world.materials[worldObject.material].physical.emission;
    const Object& object = world.scene->objects[static_cast<std::size_t>(worldObject.sceneObject)];
    DMat4 place = object.transform;
    place[3] -= DVec4(world.origin, 0);
    const std::size_t first = parts_.size();
    const auto addPart = [&](const auto& part) {
        const auto power = static_cast<float>(part.area()) * luminance(radiance);
        parts_.push_back({part, radiance, power, instance});
    };
    const auto ofShape = Overloaded{
        [&](const Sphere& sphere) {
            addPart(SphericalEllipsoid(place * glm::scale(DMat4(1), DVec3(sphere.radius))));
        },
        [&](const Plane& plane) {
            if (!std::isfinite(plane.sizeX) || !std::isfinite(plane.sizeZ)) return;
            const DVec3 x(plane.sizeX, 0, 0), z(0, 0, plane.sizeZ), up(0, 1, 0);
            if (plane.round)
                addPart(GlowingDisc(place, DVec3(0), 0.5 * z, 0.5 * x, up, plane.doubleSided));
            else
                addPart(GlowingRectangle(place, DVec3(0), z, x, up, plane.doubleSided));
        },
        [&](const Box& box) {
            for (int face = 0; face < 6; ++face) {
                DVec3 out(0), x(0), y(0);
                const int axis = face / 2;
                out[axis] = face % 2 == 1 ? 1 : -1;
                x[(axis + 1) % 3] = box.size[(axis + 1) % 3];
                y[(axis + 2) % 3] = box.size[(axis + 2) % 3];
                addPart(GlowingRectangle(place, 0.5 * out * DVec3(box.size), x, y, out, true));
            }
        },
        [&](const Cylinder& cylinder) {
            addPart(CylinderSide(cylinder, place));
            for (const double up : {1.0, -1.0}) {
                const double radius = up > 0 ? cylinder.radiusTop : cylinder.radiusBottom;
                const DVec3 center(0, 0.5 * up * cylinder.height, 0);
                addPart(GlowingDisc(place, center, {0, 0, radius}, {radius, 0, 0}, {0, up, 0}, true));
            }
        }};
    const auto ofMesh = [&](const TriangleMesh& mesh) {
        for (const auto& corners : mesh.triangles) {
            const DVec3 corner(mesh.positions[corners[0]]);
            const DVec3 a = DVec3(mesh.positions[corners[1]]) - corner;
            const DVec3 b = DVec3(mesh.positions[corners[2]]) - corner;
            addPart(GlowingTriangle(transformPoint(place, corner), DMat3(place) * a, DMat3(place) * b,
                                    DMat3(place) * glm::cross(a, b), mesh.doubleSided));
        }
    };
    std::visit(
        Overloaded{
            [&](ShapeId id) { std::visit(ofShape, world.scene->shapes[static_cast<std::size_t>(id.index)]); },
            [&](MeshId id) { ofMesh(*world.scene->meshes[static_cast<std::size_t>(id.index)].triangles); }},
        object.geometry);
    if (parts_.size() > first) ofInstance_[instance] = static_cast<int>(first);
}

std::optional<GlowSample> GlowingObjects::sample(const Vec3& from, std::uint32_t instance,
                                                 const Vec2& u) const {
    const auto chosen = std::upper_bound(below_.begin(), below_.end() - 1, u.x) - below_.begin();
    const auto i = static_cast<std::size_t>(chosen);
    const Part& part = parts_[i];
    if (part.isRoundOf(instance)) return std::nullopt;
    constexpr float kBelowOne = 0x1.fffffep-1F;
    const float start = i == 0 ? 0 : below_[i - 1];
    const Vec2 within(std::clamp((u.x - start) / part.probability, 0.0F, kBelowOne), u.y);
    const auto s = std::visit([&](const auto& shape) { return shape.sample(from, within); }, part.shape);
    if (!s) return std::nullopt;
    GlowSample result{*s, part.radiance};
    result.pdfW *= part.probability;
    return result;
}

float GlowingObjects::pdfW(const Hit& hit, const Vec3& from, std::uint32_t instance, const Vec3& wi) const {
    const int first = ofInstance_[hit.instance];
    if (first < 0) return 0;
    const Part& part = parts_[static_cast<std::size_t>(first) + hit.primitive];
    if (part.isRoundOf(instance)) return 0;
    const auto density = Overloaded{
        [&](const CylinderSide& side) { return side.pdfW(from, wi, hit.t); },
        [&](const auto& shape) { return shape.pdfW(from, wi); },
    };
    return part.probability * std::visit(density, part.shape);
}

}
