#include "core/scene/physical_surface.h"

#include <algorithm>

namespace eyeray {
namespace {

Color atMostOne(const Color& c) { return glm::min(c, Color(1)); }

/// a / b where b > 0, at most 1.
Color share(const Color& a, const Color& b) {
    return atMostOne(a / glm::max(b, Color(std::numeric_limits<float>::min())));
}

}

PhysicalSurface physicalOf(const GltfMaterial& m) {
    const float atNormal = (m.ior - 1) / (m.ior + 1);
    const float transparency = (1 - m.metallic) * m.transmission;
    const float opaque = 1 - transparency;
    const float metal = opaque > 0 ? m.metallic / opaque : 0; // of the opaque share
    const Color dielectric = atMostOne(atNormal * atNormal * m.specular * m.specularColor);
    const Color base = atMostOne(m.baseColor);
    return {.diffuse = base * (1 - metal),
            .coat = {dielectric, Color(m.specular)},
            .opaque = {glm::mix(dielectric, base, metal), Color(glm::mix(m.specular, 1.0F, metal))},
            .roughness = m.roughness,
            .ior = m.ior,
            .transparency = transparency,
            .tint = base,
            .emission = m.emissive * m.emissiveStrength};
}

PhysicalSurface physicalOf(const TaughtMaterial& m) {
    PhysicalSurface surface = physicalOf(asPhysical(m));
    if (isBlack(m.transmission)) {
        surface.coat = surface.opaque = {surface.opaque.f0, surface.opaque.f0};
        surface.diffuse = share(m.diffuse, Color(1) - surface.opaque.f0);
        return surface;
    }
    const Color through = m.reflectivity + m.transmission; // as exact Fresnel divides it for whitted
    surface.transparency = std::min(maxComponent(through), 1.0F);
    surface.tint = share(through, Color(surface.transparency));
    surface.coat = surface.opaque = {};
    surface.diffuse = share(m.diffuse, Color(1 - surface.transparency));
    return surface;
}

}
