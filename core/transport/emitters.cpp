#include "core/transport/emitters.h"

#include <algorithm>

namespace eyeray {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

std::optional<ShapeSample> sampleShape(const Emitter& emitter, const Vec3& position, const Vec2& u) {
    using Result = std::optional<ShapeSample>;
    return std::visit(Overloaded{[](std::monostate) -> Result { return std::nullopt; },
                                 [&](const SkyGradient& sky) -> Result { return sky.sample(u); },
                                 [](const std::shared_ptr<const GlowingObjects>&) -> Result {
                                     return std::nullopt; // has a radiance of its own
                                 },
                                 [&](const auto& shape) -> Result { return shape.sample(position, u); }},
                      emitter.shape);
}

/// Where a lamp stands relative to the World's origin, also one that follows the camera.
DMat4 placementOf(const Light& light, const World& world, const Camera& camera) {
    DMat4 placement = light.transform;
    if (light.followsCamera) {
        const CameraAxes axes = axesOf(camera);
        placement =
            DMat4(DVec4(axes.right, 0), DVec4(axes.up, 0), DVec4(axes.backward, 0), DVec4(camera.eye, 1)) *
            placement;
    }
    placement[3] -= DVec4(world.origin, 0);
    return placement;
}

Emitter emitterOf(const WorldLight& asPoint, const Light& light, const DMat4& placement) {
    Emitter emitter{
        .shape = {}, .light = asPoint, .radiance = light.color * static_cast<float>(light.intensity)};
    const double volume = glm::determinant(DMat3(placement));
    if (!std::isfinite(volume) || volume == 0) return emitter;
    const auto axis = [&](int i) { return DVec3(placement[i]); };
    const double mirrored = volume < 0 ? 1 : -1; // flat ones shine to their −z, as their surface does
    if (const auto* const rectangle = std::get_if<RectangleLamp>(&light.shape)) {
        emitter.shape = SphericalRectangle(DVec3(placement[3]), rectangle->width * axis(0),
                                           mirrored * rectangle->height * axis(1));
    } else if (const auto* const disc = std::get_if<DiscLamp>(&light.shape)) {
        emitter.shape = SphericalDisc(DVec3(placement[3]), disc->radius * axis(0),
                                      mirrored * disc->radius * axis(1), !light.falloff);
    } else if (const auto* const sphere = std::get_if<SphereLamp>(&light.shape)) {
        DMat4 map(DMat3(placement) * sphere->radius);
        map[3] = placement[3];
        emitter.shape = SphericalEllipsoid(map);
    } else {
        return emitter;
    }
    emitter.findable = light.falloff && !light.followsCamera && !std::isfinite(light.range);
    return emitter;
}

}

std::optional<EmitterSample> sampleEmitter(const Emitter& emitter, const Vec3& position,
                                           std::uint32_t instance, const Vec2& u) {
    if (std::holds_alternative<std::monostate>(emitter.shape)) {
        const auto point = sampleLight(emitter.light, position);
        if (!point) return std::nullopt;
        return EmitterSample{point->wi, point->distance, point->irradiance, 0};
    }
    if (const auto* const glowing = std::get_if<std::shared_ptr<const GlowingObjects>>(&emitter.shape)) {
        const auto s = (*glowing)->sample(position, instance, u);
        if (!s || !(s->pdfW > 0) || !(s->distance > 0)) return std::nullopt;
        return EmitterSample{s->wi, s->distance, s->radiance / s->pdfW, s->pdfW};
    }
    const auto s = sampleShape(emitter, position, u);
    if (!s || !(s->pdfW > 0) || !(s->distance > 0)) return std::nullopt;
    if (s->distance > emitter.light.range) return std::nullopt;
    EmitterSample result{.wi = s->wi, .distance = s->distance, .pdfW = emitter.findable ? s->pdfW : 0};
    if (const auto* const sky = std::get_if<SkyGradient>(&emitter.shape))
        result.irradiance = sky->radiance(s->wi) / s->pdfW;
    else if (emitter.light.falloff)
        result.irradiance = emitter.radiance / s->pdfW;
    else
        result.irradiance = emitter.light.emission * s->emitterCosine;
    return result;
}

float emitterPdfW(const Emitter& emitter, const Vec3& position, const Vec3& wi) {
    if (!emitter.findable) return 0;
    return std::visit(Overloaded{[](std::monostate) { return 0.0F; },
                                 [&](const SkyGradient& sky) { return sky.pdfW(wi); },
                                 [](const std::shared_ptr<const GlowingObjects>&) { return 0.0F; },
                                 [&](const auto& shape) { return shape.pdfW(position, wi); }},
                      emitter.shape);
}

Emitters::Emitters(const World& world, const Camera& camera, bool withGlowing)
    : ofLight(world.scene->lights.size(), -1) {
    for (const WorldLight& asPoint : lightsFor(world, camera)) {
        const Light& light = world.scene->lights[static_cast<std::size_t>(asPoint.sceneLight)];
        ofLight[static_cast<std::size_t>(asPoint.sceneLight)] = static_cast<int>(all.size());
        all.push_back(emitterOf(asPoint, light, placementOf(light, world, camera)));
    }
    if (!world.scene->environment.black()) {
        sky = static_cast<int>(all.size());
        all.push_back({.shape = SkyGradient(world.scene->environment),
                       .light = {.sceneLight = kSkyLight},
                       .findable = true});
    }
    if (auto objects = std::make_shared<const GlowingObjects>(world); withGlowing && !objects->empty()) {
        glowing = std::move(objects);
        all.push_back({.shape = glowing, .light = {.sceneLight = kGlowingObjects}, .findable = true});
    }
    findable = std::any_of(all.begin(), all.end(), [](const Emitter& e) { return e.findable; }) ||
               std::any_of(world.materials.begin(), world.materials.end(),
                           [](const WorldMaterial& m) { return !isBlack(m.physical.emission); });
}

}
