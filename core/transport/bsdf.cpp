#include "core/transport/bsdf.h"

#include <algorithm>

#include "core/transport/coat_albedo.h"
#include "core/transport/optics.h"

namespace eyeray {
namespace {

constexpr float kBodyMargin = 0.998F; // so that no error of coat_albedo.h gives more light than there is
constexpr float kUnbent = 1e-3F;      // an interface whose η differs less bends nothing: no microfacet shows

Vec3 cosineDirection(const Vec2& u) {
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
    return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0F, 1 - u.x))};
}

Vec3 mirroredBelow(const Vec3& w) { return {w.x, w.y, -w.z}; }

}

Bsdf::Bsdf(const PhysicalSurface& surface, const BsdfPlace& place)
    : surface_(surface), place_(place), frame_(Frame::around(place.normal)), wo_(toLocal(place.wo)),
      ggx_{std::max(surface.roughness, kSmooth) * std::max(surface.roughness, kSmooth)},
      smooth_(surface.roughness < kSmooth) {
    if (isBlack(surface.diffuse) || surface.transparency >= 1) return;
    body_ = surface.diffuse * (1 - surface.transparency);
    if (!surface.coat.black()) {
        const Color left = Color(1) - meanAlbedo(coatRoughness(), surface.ior).of(surface.coat);
        const float margin = smooth_ && surface.coat.constant() ? 1 : kBodyMargin;
        for (int c = 0; c < 3; ++c) body_[c] *= left[c] > 0 ? margin / left[c] : 0;
        body_ *= bodyUnder(wo_.z);
    }
    const Color mirror = directionalAlbedo(wo_.z, coatRoughness(), surface.ior).of(surface.opaque);
    const float specular = glm::mix(maxComponent(mirror), maxComponent(surface.tint), surface.transparency);
    const float diffuse = maxComponent(body_);
    diffuseChance_ = diffuse > 0 ? diffuse / (diffuse + specular) : 0;
}

bool Bsdf::has(RayKind lobe) const {
    if (lobe == RayKind::Diffuse) return !isBlack(body_);
    if (lobe == RayKind::Refraction) return surface_.transparency > 0 && !isBlack(surface_.tint);
    return surface_.transparency > 0 || !surface_.opaque.black();
}

BsdfValue Bsdf::eval(RayKind lobe, const Vec3& direction) const {
    const Vec3 wi = toLocal(direction);
    const bool reflects = lobe != RayKind::Refraction;
    const bool reached = sameSide(direction, reflects), lit = reflects && wi.z > 0;
    if (!has(lobe) || !(reached || lit)) return {};
    const float sampled = reached ? 1 : 0;
    if (lobe == RayKind::Diffuse)
        return {body_ * bodyUnder(wi.z) / kPi, sampled * wi.z / kPi, diffuseChance_};
    if (isDelta(lobe)) return {};

    const Vec3 h = microNormalOf(reflects, wi);
    if (!(h.z > 0) || !(glm::dot(wo_, h) > 0)) return {};
    if (!reflects && !place_.thin && !(glm::dot(wi, h) < 0)) return {};
    const Fresnel shares = fresnel(glm::dot(wo_, h));
    const float pdfW = ggx_.visibleDensity(wo_, h) * jacobian(reflects, wi, h);
    const float seen = ggx_.maskingShadowing(wo_, wi) / ggx_.masking(wo_);
    return {.f = (reflects ? shares.reflected : shares.refracted) * (seen * pdfW / std::fabs(wi.z)),
            .pdfW = sampled * pdfW,
            .probability = chance(lobe, shares)};
}

std::optional<BsdfSample> Bsdf::sample(RayKind lobe, const Vec2& u) const {
    if (!has(lobe)) return std::nullopt;
    if (lobe != RayKind::Diffuse) return scattered(lobe, ggx_.visibleNormal(wo_, u));
    const Vec3 wi = cosineDirection(u), direction = toWorld(wi);
    if (!(wi.z > 0) || !sameSide(direction, true)) return std::nullopt;
    const Color weight = body_ * bodyUnder(wi.z);
    return BsdfSample{.wi = direction,
                      .kind = lobe,
                      .f = weight / kPi,
                      .pdfW = wi.z / kPi,
                      .weight = weight,
                      .probability = diffuseChance_};
}

std::optional<BsdfSample> Bsdf::pick(float choice, const Vec2& u) const {
    if (choice < diffuseChance_) return sample(RayKind::Diffuse, u);
    const Vec3 h = smooth_ ? Vec3(0, 0, 1) : ggx_.visibleNormal(wo_, u);
    const Fresnel shares = fresnel(glm::dot(wo_, h));
    const bool reflects = choice - diffuseChance_ < chance(RayKind::Reflection, shares);
    const RayKind lobe = reflects ? RayKind::Reflection : RayKind::Refraction;
    std::optional<BsdfSample> result = has(lobe) ? scattered(lobe, h) : std::nullopt;
    if (result) result->probability = chance(lobe, shares);
    return result;
}

/// Along the mirrored or refracted direction at a microfacet.
std::optional<BsdfSample> Bsdf::scattered(RayKind lobe, const Vec3& h) const {
    const bool reflects = lobe == RayKind::Reflection;
    if (isDelta(lobe)) return delta(lobe);
    std::optional<Vec3> wi = reflected(wo_, h);
    if (!reflects) wi = place_.thin ? mirroredBelow(*wi) : refracted(wo_, h, place_.eta);
    if (!wi) return std::nullopt;
    const Vec3 direction = toWorld(*wi);
    if (!sameSide(direction, reflects)) return std::nullopt;
    const Fresnel shares = fresnel(glm::dot(wo_, h));
    const float seen = ggx_.maskingShadowing(wo_, *wi) / ggx_.masking(wo_);
    BsdfSample result{.wi = direction, .kind = lobe};
    result.weight = (reflects ? shares.reflected : shares.refracted) * seen;
    result.pdfW = ggx_.visibleDensity(wo_, h) * jacobian(reflects, *wi, h);
    result.f = result.weight * (result.pdfW / std::fabs(wi->z));
    result.probability = chance(lobe, shares);
    return result.pdfW > 0 ? std::optional(result) : std::nullopt;
}

/// As of a mirror or a polished interface: by the geometric normal where the shading normal leads to the
/// wrong side.
std::optional<BsdfSample> Bsdf::delta(RayKind lobe) const {
    const bool reflects = lobe == RayKind::Reflection;
    const auto along = [&](const Vec3& normal) -> std::optional<Vec3> {
        if (reflects) return reflected(place_.wo, normal);
        return place_.thin ? -place_.wo : refracted(place_.wo, normal, place_.eta);
    };
    const Fresnel shares = fresnel(wo_.z);
    std::optional<Vec3> wi = along(place_.normal);
    if (wi && (glm::dot(*wi, place_.geometricNormal) > 0) != reflects) wi = along(place_.geometricNormal);
    if (!wi) return std::nullopt;
    return BsdfSample{.wi = *wi,
                      .kind = lobe,
                      .delta = true,
                      .weight = reflects ? shares.reflected : shares.refracted,
                      .probability = chance(lobe, shares)};
}

/// What is reflected and what passes at a microfacet that wo meets under this cosine.
Bsdf::Fresnel Bsdf::fresnel(float cosine) const {
    Fresnel shares{Color(0), Color(0)};
    if (surface_.transparency < 1) {
        const auto& [f0, f90] = surface_.opaque;
        shares.reflected =
            surface_.opaque.constant() ? f0 : f0 + (f90 - f0) * fresnelRise(cosine, surface_.ior);
        shares.reflected *= 1 - surface_.transparency;
    }
    if (surface_.transparency > 0) {
        const float interface = fresnelDielectric(cosine, place_.eta);
        shares.reflected += surface_.transparency * interface;
        shares.refracted = surface_.tint * (surface_.transparency * (1 - interface));
    }
    return shares;
}

float Bsdf::coatRoughness() const { return smooth_ ? 0 : surface_.roughness; }

/// What the coat leaves for the body of the light from or to a direction.
Color Bsdf::bodyUnder(float cosine) const {
    if (surface_.coat.black()) return Color(1);
    return Color(1) - directionalAlbedo(cosine, coatRoughness(), surface_.ior).of(surface_.coat);
}

/// Of pick() to take a lobe at a microfacet: the brighter, the likelier.
float Bsdf::chance(RayKind lobe, const Fresnel& shares) const {
    const float reflected = maxComponent(shares.reflected), refracted = maxComponent(shares.refracted);
    const float part = reflected + refracted > 0 ? reflected / (reflected + refracted) : 1;
    return (1 - diffuseChance_) * (lobe == RayKind::Reflection ? part : 1 - part);
}

bool Bsdf::isDelta(RayKind lobe) const {
    const bool bends = place_.thin || std::fabs(place_.eta - 1) >= kUnbent;
    return smooth_ || (lobe == RayKind::Refraction && !bends);
}

/// The microfacet that takes wo to wi; below the surface where there is none.
Vec3 Bsdf::microNormalOf(bool reflects, const Vec3& wi) const {
    if (reflects || place_.thin) return glm::normalize(wo_ + (reflects ? wi : mirroredBelow(wi)));
    const Vec3 h = glm::normalize(place_.eta * wo_ + wi);
    return h.z < 0 ? -h : h;
}

/// Solid angle of microfacets' normals for that of wi.
float Bsdf::jacobian(bool reflects, const Vec3& wi, const Vec3& h) const {
    if (reflects || place_.thin) return 1 / (4 * glm::dot(wo_, h));
    const float sum = place_.eta * glm::dot(wo_, h) + glm::dot(wi, h);
    return std::fabs(glm::dot(wi, h)) / (sum * sum);
}

/// Whether wi is where the lobe leads, by both normals.
bool Bsdf::sameSide(const Vec3& wi, bool reflects) const {
    const float shading = glm::dot(wi, place_.normal), geometric = glm::dot(wi, place_.geometricNormal);
    return reflects ? shading > 0 && geometric > 0 : shading < 0 && geometric < 0;
}

Vec3 Bsdf::toLocal(const Vec3& w) const {
    return {glm::dot(w, frame_.tangent), glm::dot(w, frame_.bitangent), glm::dot(w, frame_.normal)};
}

Vec3 Bsdf::toWorld(const Vec3& w) const {
    return w.x * frame_.tangent + w.y * frame_.bitangent + w.z * frame_.normal;
}

}
