#include "core/scene/surface.h"

namespace eyeray {

Surface surfaceOf(const TaughtMaterial& m) {
    return {.ambient = m.ambient,
            .diffuse = m.diffuse,
            .specular = m.specular,
            .shininess = m.shininess,
            .specularModel = m.specularModel,
            .reflectivity = m.reflectivity,
            .grazingReflectivity = m.reflectivity,
            .transmission = m.transmission,
            .dielectric = maxComponent(m.transmission),
            .ior = m.ior,
            .attenuation = m.attenuation,
            .emission = m.emission};
}

Surface surfaceOf(const GltfMaterial& m) {
    Surface surface = surfaceOf(asTaught(m));
    const float smoothness = (1 - m.roughness) * (1 - m.roughness);
    surface.dielectric = (1 - m.metallic) * m.transmission;
    const float grazing = m.metallic + (1 - m.metallic) * m.specular;
    surface.grazingReflectivity = Color(smoothness * grazing * (1 - surface.dielectric));
    return surface;
}

}
