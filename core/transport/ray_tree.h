#pragma once
// One ray of the tree: what it meets, lit by the lamps. The methods differ in what they do next.

#include "core/transport/direct_light.h"
#include "core/transport/optics.h"

namespace eyeray {

/// A ray to be traced, and its place in the tree.
struct TreeRay {
    Ray ray;
    RayKind kind = RayKind::Eye;
    int depth = 0;
    int parent = -1;
    Color weight{1};
    MediumStack media;
    bool totalReflection = false;
};

/// Radiance that arrives along `treeRay`: background, or T·(direct light + onward), where T is the
/// transmittance of the medium on the way and `onward(point, weight, record)` is called at the hit with the
/// weight that is left there.
template <Features F, class Index, class Recorder, class Onward>
Color radianceAlong(SampleState<Index, Recorder>& state, const TreeRay& treeRay, Onward&& onward) {
    const World& world = *state.context.world;
    ++state.counts[treeRay.kind];
    ++state.treeNodes;
    const auto hit = closestHit(state.geometry, treeRay.ray);
    const int record = state.recorder.begin({.parent = treeRay.parent,
                                             .kind = treeRay.kind,
                                             .depth = treeRay.depth,
                                             .origin = treeRay.ray.origin,
                                             .direction = treeRay.ray.direction,
                                             .t = hit ? hit->t : kInfinity,
                                             .object = hit ? world.objects[hit->instance].sceneObject : -1,
                                             .weight = treeRay.weight,
                                             .end = hit ? RayEnd::Hit : RayEnd::Background,
                                             .totalReflection = treeRay.totalReflection});
    Color transmitted(1);
    if (F.transparent && treeRay.media.top() != MediumStack::kVacuum) {
        const WorldObject& medium = world.objects[treeRay.media.top()];
        transmitted =
            transmittanceOf(world.materials[medium.material].surface.attenuation, hit ? hit->t : kInfinity);
    }
    Color radiance;
    if (hit) {
        const ShadingPoint p = shadingPointAt<F>(world, state.geometry, treeRay.ray, *hit);
        radiance = directLight<F>(state, p, treeRay.media, record, treeRay.depth);
        radiance += onward(p, treeRay.weight * transmitted, record);
    } else {
        radiance = world.scene->environment.radiance(treeRay.ray.direction);
    }
    radiance *= transmitted;
    state.recorder.update(record, [&](RayRecord& r) { r.radiance = radiance; });
    return radiance;
}

}
