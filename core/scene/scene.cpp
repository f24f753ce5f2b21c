#include "core/scene/scene.h"

#include <algorithm>
#include <optional>

#include <glm/common.hpp>

namespace eyeray {

namespace {

/// Centre and half extents in object space, and whether the corners between them are rounded off.
struct LocalBox {
    DVec3 center, half;
    bool round = false;
};

std::optional<LocalBox> boxOf(const Bounds& bounds) {
    if (bounds.empty() || !bounds.finite()) return std::nullopt;
    const DVec3 lo(bounds.lo), hi(bounds.hi);
    return LocalBox{0.5 * (lo + hi), 0.5 * (hi - lo)};
}

std::optional<LocalBox> boxOf(const Shape& shape) {
    if (const auto* const sphere = std::get_if<Sphere>(&shape))
        return LocalBox{DVec3(0), DVec3(sphere->radius), true};
    return boxOf(boundsOf(shape));
}

/// Adds the box of the mapped box, or of the mapped ellipsoid inside it.
void add(SceneBounds& bounds, const DMat4& m, const LocalBox& box) {
    const DVec3 center = transformPoint(m, box.center);
    DVec3 half;
    for (int row = 0; row < 3; ++row) {
        const DVec3 reach = DVec3(m[0][row], m[1][row], m[2][row]) * box.half;
        half[row] =
            box.round ? glm::length(reach) : std::fabs(reach.x) + std::fabs(reach.y) + std::fabs(reach.z);
    }
    if (bounds.empty()) {
        bounds = {center - half, center + half};
        return;
    }
    bounds.lo = glm::min(bounds.lo, center - half);
    bounds.hi = glm::max(bounds.hi, center + half);
}

}

Color Environment::radiance(const Vec3& direction) const {
    return glm::mix(horizon, direction.y < 0 ? nadir : zenith, std::sqrt(std::fabs(direction.y)));
}

SceneBounds boundsOf(const Scene& scene) {
    std::vector<std::optional<LocalBox>> ofMesh, ofShape;
    for (const Mesh& mesh : scene.meshes) ofMesh.push_back(boxOf(boundsOf(*mesh.triangles)));
    for (const Shape& shape : scene.shapes) ofShape.push_back(boxOf(shape));

    SceneBounds result;
    for (const Object& object : scene.objects) {
        const auto* const mesh = std::get_if<MeshId>(&object.geometry);
        const auto& box = mesh ? ofMesh[mesh->index] : ofShape[std::get<ShapeId>(object.geometry).index];
        if (box) add(result, object.transform, *box);
    }
    return result;
}

Camera framingCamera(const Scene& scene, std::string name) {
    constexpr double kPitch = radians(15), kMargin = 1.05;
    const SceneBounds bounds = boundsOf(scene);
    Camera camera;
    camera.name = std::move(name);
    camera.target = bounds.empty() ? DVec3(0) : bounds.center();
    const double radius = std::max(bounds.radius(), 1e-6);
    const double distance = kMargin * radius / std::sin(camera.verticalFov / 2);
    camera.eye = camera.target + distance * DVec3(0, std::sin(kPitch), std::cos(kPitch));
    return camera;
}

}
