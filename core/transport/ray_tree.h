#pragma once
// One ray of the tree: what it meets, lit by the lamps. The methods differ in what they do next.

#include "core/transport/direct_light.h"
#include "core/transport/optics.h"

namespace eyeray {

/// What is known of a ray once its hit is found.
RayRecord recordOf(const World&, const TreeRay&, const std::optional<Hit>&, const Color& transmitted);
HitRecord hitRecordOf(const World&, const ShadingPoint&, const Hit&);

/// Radiance that arrives along `treeRay`: background, or T·(direct light + onward), where T is the
/// transmittance of the medium on the way and `onward(point, weight, record)` is called at the hit with the
/// weight that is left there.
template <Features F, class Index, class Recorder, class Onward>
Color radianceAlong(SampleState<Index, Recorder>& state, const TreeRay& treeRay, Onward&& onward) {
    const World& world = *state.context.world;
    ++state.counts[treeRay.kind];
    ++state.treeNodes;
    const auto hit = hitOf(state, treeRay);
    Color transmitted(1);
    if (F.transparent && treeRay.media.top() != MediumStack::kVacuum) {
        const WorldObject& medium = world.objects[treeRay.media.top()];
        transmitted =
            transmittanceOf(world.materials[medium.material].surface.attenuation, hit ? hit->t : kInfinity);
    }
    const int record = [&] {
        if constexpr (Recorder::kOn) return state.recorder.add(recordOf(world, treeRay, hit, transmitted));
        return -1;
    }();
    Color radiance;
    if (hit) {
        std::optional<Surface> own;
        const ShadingPoint p = shadingPointAt<F>(world, state.geometry, treeRay.ray, *hit, own);
        if constexpr (Recorder::kOn) state.recorder.at(record).hit = hitRecordOf(world, p, *hit);
        radiance = directLight<F>(state, p, treeRay, record);
        radiance += onward(p, treeRay.weight * transmitted, record);
    } else {
        radiance = world.scene->environment.radiance(treeRay.ray.direction);
        if constexpr (Recorder::kOn) state.recorder.at(record).background = radiance;
    }
    radiance *= transmitted;
    if (state.faults().has(Fault::EarlyClamp))
        radiance = glm::clamp(radiance, 0.0F, state.context.settings.clamp);
    if constexpr (Recorder::kOn) state.recorder.at(record).radiance = radiance;
    return radiance;
}

}
