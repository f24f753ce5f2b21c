#pragma once
// Light that reaches a point from lamps with an extent, from points, and from the sky, for the physical
// methods.

#include "core/transport/physical_point.h"

namespace eyeray {

/// Power heuristic with exponent 2 for one sample each: the weight of the way that has density `own`. Veach
/// 1997, section 9.2.
inline float powerHeuristic(float own, float other) {
    const float ratio = other / own; // not squared apart: densities may be large
    return 1 / (1 + ratio * ratio);
}

/// How much light counts that a ray has come upon: what shadow rays have brought already is left out. Here of
/// light of an emitter.
inline float weightOfFoundLamp(const TraceContext& context, const PhysicalRay& ray, const Emitter& emitter) {
    if (!(ray.pdfW > 0)) return 1; // no shadow ray is weighed against a mirror
    if (!context.settings.shadows || !emitter.findable) return 0;
    return powerHeuristic(ray.pdfW, emitterPdfW(emitter, ray.tree.ray.origin, ray.tree.ray.direction));
}

/// Of a surface that glows: a lamp's, or an object's.
inline float weightOfFoundSurface(const TraceContext& context, const PhysicalRay& ray, const Hit& hit,
                                  const WorldObject& object) {
    if (object.sceneLight < 0) {
        const auto& glowing = context.emitters.glowing;
        if (!glowing || !(ray.pdfW > 0)) return 1;
        return powerHeuristic(ray.pdfW,
                              glowing->pdfW(hit, ray.tree.ray.origin, ray.instance, ray.tree.ray.direction));
    }
    const int emitter = context.emitters.ofLight[static_cast<std::size_t>(object.sceneLight)];
    if (emitter < 0) return 1;
    return weightOfFoundLamp(context, ray, context.emitters.all[static_cast<std::size_t>(emitter)]);
}

/// Of the sky.
inline float weightOfFoundSky(const TraceContext& context, const PhysicalRay& ray) {
    if (context.emitters.sky < 0) return 1;
    return weightOfFoundLamp(context, ray,
                             context.emitters.all[static_cast<std::size_t>(context.emitters.sky)]);
}

namespace detail {

/// f cos of the lobes towards a lamp, times π as in LampTerm and weighed against the rays that may find it.
struct WeighedLobe {
    Color value{0};
    float mis = 1;
};

template <class Rule>
std::array<WeighedLobe, 2> weighedLobes(const TraceSettings& settings, const Bsdf& bsdf,
                                        const PhysicalPoint& point, const EmitterSample& lamp) {
    const auto term = [&](RayKind lobe) {
        const BsdfValue value = bsdf.eval(lobe, lamp.wi);
        const float found = lamp.pdfW > 0 && settings.shadows ? Rule::density(settings, lobe, value) : 0;
        const float weight = found > 0 ? powerHeuristic(lamp.pdfW, found) : 1;
        return WeighedLobe{value.f * (kPi * weight * std::fabs(glm::dot(point.p.normal, lamp.wi))), weight};
    };
    const bool passes = glm::dot(point.p.normal, lamp.wi) < 0;
    return {term(RayKind::Diffuse), term(passes ? RayKind::Refraction : RayKind::Reflection)};
}

inline bool isPoint(const Emitter& emitter) { return std::holds_alternative<std::monostate>(emitter.shape); }

/// How much of the way to a lamp a shadow ray goes: its own surface blocks nothing.
inline float shareOfWay(const Emitter& emitter) { return isPoint(emitter) ? kBeforeLamp : 1 - 1e-4F; }

/// Share of a lamp's light that arrives by a clear way; lamps with an extent hide what is behind them.
template <class Index, class Recorder>
Color clearVisibility(SampleState<Index, Recorder>& state, const Ray& ray, const Emitter& emitter,
                      const MediumStack& media, float distance) {
    if (anyHit(state.geometry, ray, isPoint(emitter) ? RayMask::Objects : RayMask::All)) return Color(0);
    return transmittanceIn(*state.context.world, media, distance);
}

}

/// Emission, weighed by `emitted`, and the light of each lamp and the sky at a point, with one shadow ray to
/// each. `Rule` is of the method: which rays may find lamps with which density, and what glass does to shadow
/// rays.
template <class Rule, Features F, class Index, class Recorder>
Color physicalLight(SampleState<Index, Recorder>& state, const PhysicalPoint& point, const Bsdf& bsdf,
                    const PhysicalRay& from, float emitted, int record) {
    const TraceContext& context = state.context;
    Color radiance = point.surface.emission * emitted;
    std::uint32_t index = 0;
    for (const Emitter& emitter : context.emitters.all) {
        const int light = emitter.light.sceneLight;
        const std::uint32_t key = hashCombine(from.key, ++index);
        const auto note = [&]([[maybe_unused]] LampTerm term) {
            if constexpr (Recorder::kOn) {
                term.ray = record;
                term.light = light;
                state.recorder.record.lamps.push_back(term);
            }
        };
        const auto lamp = sampleEmitter(emitter, point.p.at.position, point.p.instance,
                                        state.random(key, SamplePurpose::Lamp));
        if (!lamp) {
            note({.state = LampTerm::State::OutOfReach});
            continue;
        }
        const auto [diffuse, specular] = detail::weighedLobes<Rule>(context.settings, bsdf, point, *lamp);
        LampTerm term{.wi = lamp->wi,
                      .diffuse = diffuse.value,
                      .specular = specular.value,
                      .diffuseMis = diffuse.mis,
                      .specularMis = specular.mis,
                      .irradiance = lamp->irradiance / kPi,
                      .pdfW = lamp->pdfW};
        term.radiance = (term.diffuse + term.specular) * term.irradiance;
        if (isBlack(term.radiance)) {
            term.state = LampTerm::State::FacesAway;
            note(term);
            continue;
        }
        if (!context.settings.shadows) {
            radiance += term.radiance;
            note(term);
            continue;
        }
        ++state.counts[RayKind::Shadow];
        const Ray ray{shadowOrigin(point.p, lamp->wi), lamp->wi, 0,
                      lamp->distance * detail::shareOfWay(emitter)};
        Rule::template block<F>(state, point, from, emitter, ray, lamp->distance, term);
        term.radiance = (term.diffuse + term.specular) * term.irradiance * term.visibility;
        radiance += term.radiance;
        if constexpr (Recorder::kOn) {
            term.shadowRay = state.recorder.add(
                {.parent = record,
                 .kind = RayKind::Shadow,
                 .depth = from.tree.depth,
                 .origin = ray.origin,
                 .direction = ray.direction,
                 .t = ray.tMax,
                 .light = light,
                 .weight = state.recorder.at(record).weight * state.recorder.at(record).transmitted,
                 .transmitted = term.visibility,
                 .radiance = term.radiance,
                 .end = isBlack(term.visibility) ? RayEnd::Blocked : RayEnd::Unblocked});
            note(term);
        }
    }
    return radiance;
}

}
