#include "core/transport/lights.h"

#include <algorithm>

namespace eyeray {
namespace {

float angularFactor(const WorldLight& light, const Vec3& wi) {
    const float cosine = -glm::dot(light.direction, wi);
    if (light.kind == WorldLight::Kind::Facing) return std::max(0.0F, cosine);
    if (light.kind != WorldLight::Kind::Spot) return 1;
    const float width = std::max(light.cosInner - light.cosOuter, 1e-4F);
    const float edge = std::clamp((cosine - light.cosOuter) / width, 0.0F, 1.0F);
    return edge * edge;
}

}

std::optional<LightSample> sampleLight(const WorldLight& light, const Vec3& position) {
    if (light.kind == WorldLight::Kind::Directional)
        return LightSample{-light.direction, kInfinity, light.emission};
    const Vec3 to = light.position - position;
    const float distance = glm::length(to);
    if (!(distance > 0) || distance > light.range) return std::nullopt;
    const Vec3 wi = to / distance;
    const float factor = angularFactor(light, wi) / (light.falloff ? distance * distance : 1);
    if (!(factor > 0)) return std::nullopt;
    return LightSample{wi, distance, light.emission * factor};
}

std::vector<WorldLight> lightsFor(const World& world, const Camera& camera) {
    std::vector<WorldLight> lights = world.lights;
    const CameraAxes axes = axesOf(camera);
    const DMat3 toScene{axes.right, axes.up, axes.backward};
    for (WorldLight& light : lights) {
        if (!light.followsCamera) continue;
        light.position = Vec3(toScene * DVec3(light.position) + camera.eye - world.origin);
        light.direction = Vec3(toScene * DVec3(light.direction));
    }
    return lights;
}

}
