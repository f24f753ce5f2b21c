#include "core/transport/next_rays.h"

#include "core/transport/optics.h"
#include "core/transport/textbook_optics.h"

namespace eyeray {
namespace {

float iorOf(const World& world, std::uint32_t instance) {
    if (instance == MediumStack::kVacuum) return 1;
    return world.materials[world.objects[instance].material].surface.ior;
}

template <class Faults>
Vec3 mirrorDirection(const ShadingPoint& p, Faults faults) {
    if (faults.has(Fault::ReflectionSign)) return textbook::reflected(p.wo, p.normal);
    const Vec3 direction = reflected(p.wo, p.normal);
    return glm::dot(direction, p.geometricNormal) > 0 ? direction : reflected(p.wo, p.geometricNormal);
}

/// Mirror share at this angle: from normal to grazing incidence as the Fresnel reflectance of the material's
/// η runs from F0 to 1.
Color mirrorShare(const Surface& surface, float cosine) {
    if (surface.normalReflectivity == surface.grazingReflectivity) return surface.normalReflectivity;
    return surface.normalReflectivity +
           (surface.grazingReflectivity - surface.normalReflectivity) * fresnelRise(cosine, surface.ior);
}

/// Total internal reflection takes all that Fresnel's equations divide, whatever the weights.
template <class Faults>
void addGlass(const World& world, const TraceSettings& settings, const ShadingPoint& p,
              const MediumStack& media, NextRays& next, Faults faults) {
    const Surface& surface = *p.surface;
    Interface interface = interfaceAt(
        world, {.instance = p.instance, .solid = p.object->solid, .front = p.front, .ior = surface.ior},
        media);
    if (faults.has(Fault::EtaNotFlipped)) interface.eta = 1 / surface.ior;
    const float cosine = glm::dot(p.normal, p.wo);
    std::optional<Vec3> direction = refracted(p.wo, p.normal, interface.eta);
    if (direction && glm::dot(*direction, p.geometricNormal) >= 0)
        direction = refracted(p.wo, p.geometricNormal, interface.eta);
    next.eta = interface.eta;
    const bool noNumber = !direction && faults.has(Fault::NanRefraction);
    if (noNumber) direction = textbook::refracted(p.wo, p.normal, interface.eta);
    next.totalReflection = !direction && p.object->solid;
    if (next.totalReflection) {
        next.reflectedShare = mirrorShare(surface, cosine) + surface.dielectric;
        return;
    }
    if (settings.fresnel == FresnelMode::Exact) {
        const float reflectance = noNumber || faults.has(Fault::SchlickInnerCosine)
                                      ? textbook::schlick(cosine, interface.eta)
                                      : fresnelDielectric(cosine, interface.eta);
        next.reflectedShare += surface.dielectric * reflectance;
        next.refractedShare = surface.refractable * (1 - reflectance);
    } else {
        next.refractedShare = surface.transmission;
    }
    next.refraction = p.object->solid ? *direction : -p.wo;
    next.refractedMedia = interface.beyond;
}

}

Interface interfaceAt(const World& world, const Side& side, const MediumStack& media) {
    if (!side.solid) return {iorOf(world, media.top()) / side.ior, media};
    if (side.front) {
        const MediumStack beyond = media.entered(side.instance, world.objects[side.instance].rank);
        const float inside = beyond.top() == side.instance ? side.ior : iorOf(world, beyond.top());
        return {iorOf(world, media.top()) / inside, beyond};
    }
    const MediumStack beyond = media.left(side.instance);
    // an eye that stands in an open mesh leaves what it never entered
    const float inside = media.contains(side.instance) ? iorOf(world, media.top()) : side.ior;
    return {inside / iorOf(world, beyond.top()), beyond};
}

Interface interfaceAt(const World& world, const ShadingPoint& p, const MediumStack& media) {
    return interfaceAt(
        world, {.instance = p.instance, .solid = p.object->solid, .front = p.front, .ior = p.surface->ior},
        media);
}

template <class Faults>
NextRays nextRays(const World& world, const TraceSettings& settings, const ShadingPoint& p,
                  const MediumStack& media, Faults faults) {
    NextRays next;
    next.reflectedShare = settings.fresnel == FresnelMode::Exact
                              ? mirrorShare(*p.surface, glm::dot(p.normal, p.wo))
                              : p.surface->reflectivity;
    if (p.surface->transmits()) addGlass(world, settings, p, media, next, faults);
    if (!isBlack(next.reflectedShare)) next.reflection = mirrorDirection(p, faults);
    return next;
}

template NextRays nextRays(const World&, const TraceSettings&, const ShadingPoint&, const MediumStack&,
                           NoFaults);
template NextRays nextRays(const World&, const TraceSettings&, const ShadingPoint&, const MediumStack&,
                           SomeFaults);

}
