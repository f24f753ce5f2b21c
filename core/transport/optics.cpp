#include "core/transport/optics.h"

#include <algorithm>

namespace eyeray {
namespace {

// sin² of the refracted angle; 1 or more on total internal reflection. In double, for near the critical angle
// and between media that hardly differ nearly all digits cancel.
double sineSquared(double cosine, double eta) {
    return eta * eta * std::max(0.0, (1 - cosine) * (1 + cosine));
}

}

std::optional<Vec3> refracted(const Vec3& wo, const Vec3& normal, float eta) {
    const double cosine = glm::dot(normal, wo);
    const double sine2 = sineSquared(cosine, eta);
    if (sine2 >= 1) return std::nullopt;
    return glm::normalize(-eta * wo + static_cast<float>(eta * cosine - std::sqrt(1 - sine2)) * normal);
}

float fresnelDielectric(float cosine, float eta) {
    const double c = std::clamp(cosine, 0.0F, 1.0F), e = eta;
    const double sine2 = sineSquared(c, e);
    if (sine2 >= 1) return 1;
    const double inner = std::sqrt(1 - sine2);
    // (a/b)² and (d/e)² are the shares of perpendicular and parallel light; over one denominator
    const double a = e * c - inner, b = e * c + inner, d = c - e * inner, f = c + e * inner;
    const double af = a * f, bd = b * d, bf = b * f;
    return static_cast<float>(0.5 * (af * af + bd * bd) / (bf * bf));
}

float fresnelRise(float cosine, float ior) {
    const float root = (ior - 1) / (ior + 1), f0 = root * root;
    return f0 < 1 ? std::max(0.0F, (fresnelDielectric(cosine, 1 / ior) - f0) / (1 - f0)) : 0;
}

Color transmittanceOf(const Color& attenuation, float distance) {
    const auto channel = [&](float sigma) { return sigma > 0 ? std::exp(-sigma * distance) : 1.0F; };
    return {channel(attenuation.r), channel(attenuation.g), channel(attenuation.b)};
}

}
