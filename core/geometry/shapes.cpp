#include "core/geometry/shapes.h"

namespace eyeray {
namespace {

Bounds around(const Vec3& half) { return {-half, half}; }

struct BoundsOfShape {
    Bounds operator()(const Sphere& s) const { return around(Vec3(s.radius)); }
    Bounds operator()(const Plane& p) const { return around(0.5F * Vec3(p.sizeX, 0, p.sizeZ)); }
    Bounds operator()(const Box& b) const { return around(0.5F * b.size); }
    Bounds operator()(const Cylinder& c) const {
        const float radius = std::max(c.radiusTop, c.radiusBottom);
        return around(Vec3(radius, 0.5F * c.height, radius));
    }
};

}

Bounds boundsOf(const Shape& shape) { return std::visit(BoundsOfShape{}, shape); }

bool isSolid(const Shape& shape) { return !std::holds_alternative<Plane>(shape); }

std::optional<Hit> intersect(const Shape& shape, const Ray& ray) {
    return std::visit([&](const auto& s) { return intersect(s, ray); }, shape);
}

SurfacePoint surfaceAt(const Shape& shape, const Ray& ray, const Hit& hit) {
    return std::visit([&](const auto& s) { return surfaceAt(s, ray, hit); }, shape);
}

Vec2 textureCoordinates(const Shape& shape, const SurfacePoint& point, std::uint32_t face) {
    return std::visit([&](const auto& s) { return textureCoordinates(s, point, face); }, shape);
}

}
