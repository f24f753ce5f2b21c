#include <algorithm>

#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

/// How far the point lies about which orbiting turns: level with the middle of the scene, where that lies
/// ahead of the eye.
double targetDistance(const DVec3& eye, const DVec3& forward, const SceneBounds& bounds) {
    if (bounds.empty()) return 1;
    const double ahead = glm::dot(bounds.center() - eye, forward);
    const double nearest = std::max(0.05 * bounds.radius(), 1e-6);
    return ahead > nearest ? ahead : std::max(0.5 * bounds.radius(), nearest);
}

/// World up for a camera that is held level, so that it stays level when it is turned; else its own.
DVec3 upOf(const DVec3& right, const DVec3& up) {
    constexpr double kLevel = 1e-6;
    return std::fabs(right.y) < kLevel && up.y > kLevel ? DVec3(0, 1, 0) : up;
}

}

std::optional<Camera> importCamera(GltfImport& context, const PlacedNode& placed,
                                   std::optional<double> distance, const SceneBounds& bounds) {
    const tinygltf::Node& node = context.document.model.nodes[placed.node];
    const tinygltf::Camera& source = context.document.model.cameras[node.camera];
    const std::string where = context.document.at("cameras", static_cast<std::size_t>(node.camera));
    if (source.type != "perspective") {
        context.notes.ignoredOne("orthographic projection", "camera");
        return std::nullopt;
    }
    constexpr double kNarrowest = radians(0.01), kWidest = radians(179);
    Camera camera;
    camera.name = nameOr(node.name, nameOr(source.name, "camera"));
    camera.verticalFov =
        clamped(source.perspective.yfov, kNarrowest, kWidest, where + ".yfov", context.notes);
    if (source.perspective.aspectRatio != 0)
        camera.aspect =
            clamped(source.perspective.aspectRatio, 1e-3, 1e3, where + ".aspectRatio", context.notes);

    const DVec3 right = safeNormalize(DVec3(placed.transform[0])),
                up = safeNormalize(DVec3(placed.transform[1])),
                forward = -safeNormalize(DVec3(placed.transform[2]));
    camera.eye = DVec3(placed.transform[3]);
    camera.target =
        camera.eye + (distance ? *distance : targetDistance(camera.eye, forward, bounds)) * forward;
    camera.up = upOf(right, up);
    return camera;
}

}
