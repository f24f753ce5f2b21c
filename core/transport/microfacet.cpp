#include "core/transport/microfacet.h"

#include <algorithm>

namespace eyeray {
namespace {

// Smith's Λ: 1 / (1 + Λ) is the share that is seen.
float lambda(float alpha, const Vec3& w) {
    const float cosine2 = w.z * w.z, sine2 = w.x * w.x + w.y * w.y;
    if (!(cosine2 > 0)) return kInfinity;
    return (std::sqrt(1 + alpha * alpha * sine2 / cosine2) - 1) / 2;
}

}

float Ggx::distribution(const Vec3& h) const {
    const float a2 = alpha * alpha, d = a2 * h.z * h.z + h.x * h.x + h.y * h.y;
    return a2 / (kPi * d * d);
}

float Ggx::masking(const Vec3& w) const { return 1 / (1 + lambda(alpha, w)); }

float Ggx::maskingShadowing(const Vec3& wo, const Vec3& wi) const {
    return 1 / (1 + lambda(alpha, wo) + lambda(alpha, wi));
}

Vec3 Ggx::visibleNormal(const Vec3& wo, const Vec2& u) const {
    const Vec3 stretched = glm::normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
    const float slant = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
    const Vec3 across = slant > 0 ? Vec3(-stretched.y, stretched.x, 0) / slant : Vec3(1, 0, 0);
    const Vec3 upward = glm::cross(stretched, across);
    // Uniform on the disc that the half sphere of normals shows to wo: its lower half is squeezed.
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y, shown = (1 + stretched.z) / 2;
    const float x = radius * std::cos(angle);
    const float y = (1 - shown) * std::sqrt(std::max(0.0F, 1 - x * x)) + shown * radius * std::sin(angle);
    const Vec3 normal = x * across + y * upward + std::sqrt(std::max(0.0F, 1 - x * x - y * y)) * stretched;
    return glm::normalize(Vec3(alpha * normal.x, alpha * normal.y, std::max(1e-6F, normal.z)));
}

float Ggx::visibleDensity(const Vec3& wo, const Vec3& h) const {
    return masking(wo) * distribution(h) * std::max(0.0F, glm::dot(wo, h)) / wo.z;
}

}
