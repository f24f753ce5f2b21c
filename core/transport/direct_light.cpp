#include "core/transport/direct_light.h"

#include <algorithm>

#include "core/transport/textbook_optics.h"

namespace eyeray {
namespace {

template <class Faults>
float specularLobe(const ShadingPoint& p, const Vec3& wi, Faults faults) {
    const bool phong = p.surface->specularModel == SpecularModel::Phong;
    const auto mirrored = [&] {
        return faults.has(Fault::ReflectionSign) ? textbook::reflected(wi, p.normal)
                                                 : reflected(wi, p.normal);
    };
    const float cosine = phong ? glm::dot(mirrored(), p.wo) : glm::dot(p.normal, glm::normalize(wi + p.wo));
    return cosine > 0 ? std::pow(cosine, p.surface->shininess) : 0.0F;
}

}

template <class Faults>
LocalTerms localModel(const ShadingPoint& p, const Vec3& wi, Faults faults) {
    const float above = glm::dot(p.normal, wi);
    const float cosine = faults.has(Fault::AbsCosine) ? std::fabs(above) : above;
    if (!(cosine > 0)) return {};
    LocalTerms terms{.diffuse = p.surface->diffuse * cosine};
    if (!isBlack(p.surface->specular)) terms.specular = p.surface->specular * specularLobe(p, wi, faults);
    return terms;
}

template LocalTerms localModel(const ShadingPoint&, const Vec3&, NoFaults);
template LocalTerms localModel(const ShadingPoint&, const Vec3&, SomeFaults);

}
