#include "core/scene/surface.h"

namespace eyeray {

Surface surfaceOf(const TaughtMaterial& m) {
    const bool glass = !isBlack(m.transmission);
    const Color divided = glass ? m.reflectivity + m.transmission : Color(0);
    const Color mirror = glass ? Color(0) : m.reflectivity;
    return {.ambient = m.ambient,
            .diffuse = m.diffuse,
            .specular = m.specular,
            .shininess = m.shininess,
            .specularModel = m.specularModel,
            .reflectivity = m.reflectivity,
            .transmission = m.transmission,
            .normalReflectivity = mirror,
            .grazingReflectivity = mirror,
            .dielectric = maxComponent(divided),
            .refractable = divided,
            .ior = m.ior,
            .attenuation = m.attenuation,
            .emission = m.emission};
}

Surface surfaceOf(const GltfMaterial& m) {
    const TaughtMaterial taught = asTaught(m);
    Surface surface = surfaceOf(taught);
    const float smoothness = (1 - m.roughness) * (1 - m.roughness);
    const float atNormal = (m.ior - 1) / (m.ior + 1);
    surface.dielectric = (1 - m.metallic) * m.transmission;
    surface.reflectivity = taught.reflectivity + Color(surface.dielectric * atNormal * atNormal);
    surface.normalReflectivity = taught.reflectivity;
    const float grazing = m.metallic + (1 - m.metallic) * m.specular;
    surface.grazingReflectivity = Color(smoothness * grazing * (1 - surface.dielectric));
    surface.refractable = taught.transmission;
    return surface;
}

}
