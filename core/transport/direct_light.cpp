#include "core/transport/direct_light.h"

#include <algorithm>

namespace eyeray {
namespace {

float specularLobe(const ShadingPoint& p, const Vec3& wi) {
    const bool phong = p.surface->specularModel == SpecularModel::Phong;
    const float cosine =
        phong ? glm::dot(reflected(wi, p.normal), p.wo) : glm::dot(p.normal, glm::normalize(wi + p.wo));
    return cosine > 0 ? std::pow(cosine, p.surface->shininess) : 0.0F;
}

}

LocalTerms localModel(const ShadingPoint& p, const Vec3& wi) {
    const float cosine = glm::dot(p.normal, wi);
    if (!(cosine > 0)) return {};
    LocalTerms terms{.diffuse = p.surface->diffuse * cosine};
    if (!isBlack(p.surface->specular)) terms.specular = p.surface->specular * specularLobe(p, wi);
    return terms;
}

}
