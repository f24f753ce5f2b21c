#include "core/transport/optics.h"

#include <algorithm>

namespace eyeray {
namespace {

// sin² of the refracted angle; above 1 on total internal reflection. 1 − cos² is written to keep its digits
// near normal incidence.
float sineSquared(float cosine, float eta) { return eta * eta * std::max(0.0F, (1 - cosine) * (1 + cosine)); }

}

std::optional<Vec3> refracted(const Vec3& wo, const Vec3& normal, float eta) {
    const float cosine = glm::dot(normal, wo);
    const float sine2 = sineSquared(cosine, eta);
    if (sine2 >= 1) return std::nullopt;
    return glm::normalize(-eta * wo + (eta * cosine - std::sqrt(1 - sine2)) * normal);
}

float fresnelDielectric(float cosine, float eta) {
    const float c = std::clamp(cosine, 0.0F, 1.0F);
    const float sine2 = sineSquared(c, eta);
    if (sine2 >= 1) return 1;
    const float inner = std::sqrt(1 - sine2);
    const float perpendicular = (eta * c - inner) / (eta * c + inner);
    const float parallel = (c - eta * inner) / (c + eta * inner);
    return 0.5F * (perpendicular * perpendicular + parallel * parallel);
}

Color transmittanceOf(const Color& attenuation, float distance) {
    const auto channel = [&](float sigma) { return sigma > 0 ? std::exp(-sigma * distance) : 1.0F; };
    return {channel(attenuation.r), channel(attenuation.g), channel(attenuation.b)};
}

}
