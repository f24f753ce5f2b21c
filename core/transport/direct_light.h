#pragma once
// Light that reaches a point straight from the lamps: the taught local models, and the shadow rays.

#include "core/transport/faults.h"
#include "core/transport/lights.h"
#include "core/transport/optics.h"
#include "core/transport/ray_counts.h"
#include "core/transport/recorder.h"
#include "core/transport/shading_point.h"
#include "core/transport/tile_hits.h"
#include "core/transport/trace_context.h"

namespace eyeray {

/// kd (n·l) and ks (r·v)^n or ks (n·h)^n.
struct LocalTerms {
    Color diffuse{0}, specular{0};
    Color sum() const { return diffuse + specular; }
};

/// The taught local models: radiance towards wo for normal irradiance π from the unit direction wi; black
/// where wi is behind the surface. Phong 1975, "Illumination for Computer Generated Pictures"; Blinn 1977,
/// "Models of Light Reflection for Computer Synthesized Pictures".
template <class Faults>
LocalTerms localModel(const ShadingPoint&, const Vec3& wi, Faults);

/// A ray to be traced, and its place in the tree.
struct TreeRay {
    Ray ray;
    RayKind kind = RayKind::Eye;
    int depth = 0;
    int parent = -1; // its index on record
    Color share{1};  // of its radiance that its parent's hit sends on
    Color weight{1}; // of its radiance that reaches the pixel
    MediumStack media;
    bool totalReflection = false;
    float eta = 1, cosine = 0; // as in RayRecord
};

/// Which of a tile's hits is that of a sample's eye ray, if they are kept.
struct EyeHit {
    TileHits hits;
    std::size_t sample = 0;
};

/// What one sample of one pixel carries along.
template <class Index, class Recorder>
struct SampleState {
    const TraceContext& context;
    const IndexedGeometry<Index>& geometry;
    RayCounts& counts;
    Recorder& recorder;
    SampleAddress address;
    EyeHit eyeHit;
    int treeNodes = 0;

    FaultsOf<Index> faults() const { return FaultsOf<Index>(context.settings.faults); }

    /// The sample's number for a purpose at a node of its tree, in [0, 1)².
    Vec2 random(std::uint32_t node, SamplePurpose purpose) const {
        if (faults().has(Fault::BadSeeding)) return badlySeeded(address, context.width, node, purpose);
        return sample2(context.settings.sampler, address, node, purpose);
    }
};

/// The closest hit of a ray of the tree.
template <class Index, class Recorder>
std::optional<Hit> hitOf(const SampleState<Index, Recorder>& state, const TreeRay& ray) {
    const auto& [hits, sample] = state.eyeHit;
    const bool keeps = hits.kept() && ray.kind == RayKind::Eye;
    if (keeps && hits.known) return hits.at(sample);
    const auto hit = closestHit(state.geometry, ray.ray);
    if (keeps) hits.set(sample, hit);
    return hit;
}

inline constexpr float kBeforeLamp = 1 - 1e-6F; // of the way to a lamp a shadow ray goes

namespace detail {

/// What transparent objects leave of the light along a shadow ray, straight through: kt at each surface,
/// e^(−σd) between.
template <Features F, class Index, class Recorder>
Color filteredStraight(SampleState<Index, Recorder>& state, Ray ray, MediumStack media) {
    constexpr int kMostSurfaces = 256; // more are taken as opaque
    const World& world = *state.context.world;
    Color transmitted(1);
    for (int i = 0; i < kMostSurfaces; ++i) {
        const auto hit = closestHit(state.geometry, ray, RayMask::Transparent);
        const float length = hit ? hit->t : ray.tMax;
        if (media.top() != MediumStack::kVacuum) {
            const WorldObject& medium = world.objects[media.top()];
            transmitted *= transmittanceOf(world.materials[medium.material].surface.attenuation, length);
        }
        if (!hit || isBlack(transmitted)) return transmitted;
        std::optional<Surface> own;
        const ShadingPoint p = shadingPointAt<F>(world, state.geometry, ray, *hit, own);
        transmitted *= p.surface->transmission;
        if (p.object->solid)
            media = p.front ? media.entered(p.instance, p.object->rank) : media.left(p.instance);
        ray.origin = spawnOrigin(p.at, ray.direction);
        ray.tMax -= length;
    }
    return Color(0);
}

/// Share of a lamp's light that arrives, by the named policy for glass.
template <Features F, class Index, class Recorder>
Color visibility(SampleState<Index, Recorder>& state, const Ray& ray, const MediumStack& media) {
    const bool clear = !anyHit(state.geometry, ray, RayMask::Objects);
    if constexpr (F.transparent) {
        const GlassShadows policy = state.context.settings.glassShadows;
        if (!clear && policy != GlassShadows::AllBlock) {
            if (anyHit(state.geometry, ray, RayMask::Opaque)) return Color(0);
            if (policy == GlassShadows::OpaqueOnly) return Color(1);
        }
        const bool inVacuum = media.top() == MediumStack::kVacuum;
        if (policy == GlassShadows::Straight && !(clear && inVacuum))
            return filteredStraight<F>(state, ray, media);
    }
    return Color(clear ? 1.0F : 0.0F);
}

}

/// Emission, ambient and the lamps' light at a point, with one shadow ray to each lamp that can contribute,
/// if the settings ask for them. `from` is the ray that hit the point, `record` its index on record.
template <Features F, class Index, class Recorder>
Color directLight(SampleState<Index, Recorder>& state, const ShadingPoint& p, const TreeRay& from,
                  int record) {
    const TraceContext& context = state.context;
    const auto faults = state.faults();
    Color radiance = p.surface->emission + p.surface->ambient * context.world->scene->ambient;
    if (faults.has(Fault::AmbientPerLight))
        for (std::size_t i = 1; i < context.lights.size(); ++i)
            radiance += p.surface->ambient * context.world->scene->ambient;
    for (const WorldLight& light : context.lights) {
        const auto note = [&]([[maybe_unused]] LampTerm term) {
            if constexpr (Recorder::kOn) {
                term.ray = record;
                term.light = light.sceneLight;
                state.recorder.record.lamps.push_back(term);
            }
        };
        const auto sample = sampleLight(light, p.at.position);
        if (!sample) {
            note({.state = LampTerm::State::OutOfReach});
            continue;
        }
        const LocalTerms local = localModel(p, sample->wi, faults);
        const Color irradiance = sample->irradiance / kPi;
        const Color unblocked = local.sum() * irradiance;
        LampTerm term{.wi = sample->wi,
                      .diffuse = local.diffuse,
                      .specular = local.specular,
                      .irradiance = irradiance,
                      .radiance = unblocked};
        if (isBlack(local.sum()) || isBlack(unblocked)) {
            term.state = LampTerm::State::FacesAway;
            note(term);
            continue;
        }
        if (!context.settings.shadows) {
            radiance += unblocked;
            note(term);
            continue;
        }
        ++state.counts[RayKind::Shadow];
        const Ray ray{shadowOrigin(p, sample->wi), sample->wi, 0,
                      faults.has(Fault::ShadowNoTmax) ? kInfinity : sample->distance * kBeforeLamp};
        term.visibility = detail::visibility<F>(state, ray, from.media);
        term.radiance = unblocked * term.visibility;
        radiance += term.radiance;
        if constexpr (Recorder::kOn) {
            term.shadowRay = state.recorder.add(
                {.parent = record,
                 .kind = RayKind::Shadow,
                 .depth = from.depth,
                 .origin = ray.origin,
                 .direction = ray.direction,
                 .t = ray.tMax,
                 .light = light.sceneLight,
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
