#include "core/transport/ray_tree.h"

namespace eyeray {

RayRecord recordOf(const World& world, const TreeRay& ray, const std::optional<Hit>& hit,
                   const Color& transmitted) {
    const std::uint32_t medium = ray.media.top();
    return {.parent = ray.parent,
            .kind = ray.kind,
            .depth = ray.depth,
            .origin = ray.ray.origin,
            .direction = ray.ray.direction,
            .t = hit ? hit->t : kInfinity,
            .object = hit ? world.objects[hit->instance].sceneObject : -1,
            .medium = medium != MediumStack::kVacuum ? world.objects[medium].sceneObject : -1,
            .share = ray.share,
            .weight = ray.weight,
            .transmitted = transmitted,
            .end = hit ? RayEnd::Hit : RayEnd::Background,
            .totalReflection = ray.totalReflection,
            .eta = ray.eta,
            .cosine = ray.cosine};
}

HitRecord hitRecordOf(const World& world, const ShadingPoint& p, const Hit& hit) {
    const int object = p.object->sceneObject;
    return {.object = object,
            .material = object >= 0 ? static_cast<int>(p.object->material) : -1,
            .primitive = hit.primitive,
            .position = p.at.position,
            .normal = p.normal,
            .geometricNormal = p.geometricNormal,
            .front = p.front,
            .emission = p.surface->emission,
            .ambient = p.surface->ambient * world.scene->ambient,
            .diffuseReflectance = p.surface->diffuse};
}

}
