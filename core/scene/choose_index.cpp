#include "core/scene/choose_index.h"

namespace eyeray {
namespace {

std::size_t testCost(const Scene& scene, const Object& object) {
    if (const auto* mesh = std::get_if<MeshId>(&object.geometry))
        return scene.meshes[static_cast<std::size_t>(mesh->index)].triangles->triangles.size();
    const Shape& shape = scene.shapes[static_cast<std::size_t>(std::get<ShapeId>(object.geometry).index)];
    if (!boundsOf(shape).finite()) return 0; // no index spares a ray an infinite plane
    return std::holds_alternative<Cylinder>(shape) ? kCylinderCost : 1;
}

bool hasSurface(const Light& light) {
    return std::holds_alternative<RectangleLamp>(light.shape) ||
           std::holds_alternative<DiscLamp>(light.shape) || std::holds_alternative<SphereLamp>(light.shape);
}

}

AccelKind chooseIndex(const Scene& scene, const BuildSettings& settings) {
    if (settings.accel != AccelKind::Auto) return settings.accel;
    std::size_t cost = 0;
    for (const Object& object : scene.objects)
        if (object.visible) cost += testCost(scene, object);
    for (const Light& light : scene.lights)
        if (light.enabled && hasSurface(light)) ++cost;
    return cost <= (settings.byStreams ? kMostByStreams : kMostOneByOne) ? AccelKind::Brute : AccelKind::Bvh8;
}

}
