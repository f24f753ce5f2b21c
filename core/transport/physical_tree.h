#pragma once
// One ray of the physical methods: what it meets, lit by lamps and sky. The methods differ in what they do
// next.

#include "core/transport/physical_light.h"
#include "core/transport/ray_tree.h"

namespace eyeray {

/// The ray that begins a sample, from a place on the camera's lens.
template <class Index, class Recorder>
PhysicalRay firstRay(const SampleState<Index, Recorder>& state, const Ray& eyeRay) {
    const TraceContext& context = state.context;
    PhysicalRay first{.tree = {.ray = eyeRay, .media = context.eyeMedia}};
    if (context.eyeRays.hasLens())
        first.tree.ray = context.eyeRays.fromLens(eyeRay, state.random(0, SamplePurpose::Lens));
    return first;
}

/// Whether a lobe's rays are traced at all.
inline bool traces(const TraceSettings& settings, RayKind lobe) {
    if (lobe == RayKind::Diffuse) return settings.diffuse;
    return lobe == RayKind::Reflection ? settings.reflections : settings.refractions;
}

/// Radiance that arrives along a ray: as radianceAlong does, by physical materials and lamps.
/// `onward(point, bsdf, weight, record)` is the radiance that next rays bring. Radiance is basic: over η².
template <class Rule, Features F, class Index, class Recorder, class Onward>
Color physicalRadiance(SampleState<Index, Recorder>& state, const PhysicalRay& ray, Onward&& onward) {
    const TraceContext& context = state.context;
    const World& world = *context.world;
    ++state.counts[ray.forLamps ? RayKind::Shadow : ray.tree.kind];
    if (!ray.forLamps) state.counts.deepest = std::max(state.counts.deepest, ray.tree.depth);
    ++state.treeNodes;
    const auto hit = hitOf(state, ray.tree);
    const Color transmitted =
        F.transparent ? transmittanceIn(world, ray.tree.media, hit ? hit->t : kInfinity) : Color(1);
    const int record = [&] {
        if constexpr (Recorder::kOn) {
            state.recorder.record.physical = true;
            return state.recorder.add(recordOf(world, ray.tree, hit, transmitted));
        }
        return -1;
    }();
    Color radiance;
    if (hit) {
        const PhysicalPoint point = physicalPointAt<F>(world, state.geometry, ray, *hit);
        const float emitted =
            isBlack(point.surface.emission) ? 1 : weightOfFoundSurface(context, ray, *hit, *point.p.object);
        if constexpr (Recorder::kOn) {
            HitRecord& noted = state.recorder.at(record).hit;
            noted = hitRecordOf(world, point.p, *hit);
            noted.emission = point.surface.emission * emitted;
            state.recorder.at(record).foundMis = emitted;
            noted.ambient = Color(0);
            noted.diffuseReflectance = point.surface.diffuse;
        }
        if (ray.forLamps || point.p.object->sceneObject < 0) {
            radiance = point.surface.emission * emitted;
        } else {
            const Bsdf bsdf = point.bsdf();
            radiance = physicalLight<Rule, F>(state, point, bsdf, ray, emitted, record);
            radiance += onward(point, bsdf, ray.tree.weight * transmitted, record);
        }
    } else {
        const float found = weightOfFoundSky(context, ray);
        radiance = world.scene->environment.radiance(ray.tree.ray.direction) * found;
        if constexpr (Recorder::kOn) {
            state.recorder.at(record).background = radiance;
            state.recorder.at(record).foundMis = found;
        }
    }
    radiance *= transmitted;
    if (state.faults().has(Fault::EarlyClamp)) radiance = glm::clamp(radiance, 0.0F, context.settings.clamp);
    if constexpr (Recorder::kOn) state.recorder.at(record).radiance = radiance;
    return radiance;
}

/// The ray that goes on along a sample, which brings `share` of its radiance to the hit.
inline PhysicalRay nextRay(const PhysicalRay& ray, const PhysicalPoint& point, const BsdfSample& sample,
                           const Color& share, const Color& weight, int record) {
    const bool passes = sample.kind == RayKind::Refraction;
    return {.tree = {.ray = {spawnOrigin(point.p.at, sample.wi), sample.wi},
                     .kind = sample.kind,
                     .depth = ray.tree.depth + 1,
                     .parent = record,
                     .share = share,
                     .weight = weight,
                     .media = passes ? point.interface.beyond : ray.tree.media,
                     .eta = point.interface.eta,
                     .cosine = glm::dot(point.p.normal, point.p.wo)},
            .key = keyOfNext(ray, sample.kind),
            .scattered = ray.scattered || !sample.delta,
            .instance = point.p.instance};
}

/// Why a next ray is not traced, if so; at the depth limit one that is not mirrored may still look for lamps.
template <class Index, class Recorder>
std::optional<UntracedRay::Reason> reasonNotToTrace(const SampleState<Index, Recorder>& state,
                                                    const PhysicalRay& ray, const BsdfSample& sample) {
    using Reason = UntracedRay::Reason;
    const TraceContext& context = state.context;
    if (!traces(context.settings, sample.kind)) return Reason::SwitchedOff;
    const bool looks = !sample.delta && context.emitters.findable && context.settings.shadows;
    if (ray.tree.depth >= context.settings.maxDepth && !looks) return Reason::DepthLimit;
    if (state.treeNodes > kMaxTreeNodes || context.stop.stop_requested()) return Reason::TreeLimit;
    return std::nullopt;
}

}
