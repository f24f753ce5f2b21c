#pragma once
// How a surface scatters light: the physical methods' answer, in three lobes, one for each kind of ray.

#include <optional>

#include "core/base/ray_kind.h"
#include "core/scene/physical_surface.h"
#include "core/transport/microfacet.h"

namespace eyeray {

/// One lobe for one pair of directions; zero where the lobe is a delta.
struct BsdfValue {
    Color f{0};            // per steradian
    float pdfW = 0;        // with which sample() of this lobe gives wi
    float probability = 0; // with which pick() takes this lobe, if it gives wi
};

struct BsdfSample {
    Vec3 wi{0};
    RayKind kind = RayKind::Diffuse; // the lobe
    bool delta = false;              // perfectly smooth: f and pdfW are then infinite and stand as 0
    Color f{0};
    float pdfW = 0;
    Color weight{0};       // f |cos| / pdfW
    float probability = 1; // as in BsdfValue
};

/// Where a hit is, for a Bsdf.
struct BsdfPlace {
    Vec3 wo;                            // unit, away from the surface
    Vec3 normal{0}, geometricNormal{0}; // unit; dot(normal, wo) > 0, dot(geometricNormal, wo) ≥ 0
    float eta = 1;                      // of wo's side / of the other side
    bool thin = false;                  // a pane: what passes goes straight on
};

/// Diffuse: a Lambert body under a coat, which takes its share both ways (C. Kelemen, L. Szirmay-Kalos 2001,
/// "A Microfacet Based Coupled Specular-Matte BRDF Model with Importance Sampling"). Reflection: GGX
/// microfacets of coat and interface, scattered once. Refraction: GGX (Walter et al. 2007), in basic radiance
/// L/η², so that glass in a furnace is invisible from both sides. Roughness below kSmooth is a delta. No lobe
/// gives more light than it takes; f(wo, wi) = f(wi, wo), for refraction with the other's eta and divided by
/// its square.
class Bsdf {
public:
    Bsdf(const PhysicalSurface&, const BsdfPlace&);

    /// What one lobe says of a unit direction. Where the normals of a mesh call a facet lit that faces away,
    /// light is reflected, but sample() does not lead there: pdfW is 0.
    BsdfValue eval(RayKind lobe, const Vec3& wi) const;

    /// A direction of one lobe, from u in [0, 1)²; nothing where it sends no light on. `weight` may be black.
    std::optional<BsdfSample> sample(RayKind lobe, const Vec2& u) const;

    /// One lobe by `choice` in [0, 1), as likely as it is bright, and a direction of it.
    std::optional<BsdfSample> pick(float choice, const Vec2& u) const;

    bool has(RayKind lobe) const;

    /// Whether pick() has no choice.
    bool single() const { return diffuseChance_ == 1 || (diffuseChance_ == 0 && !has(RayKind::Refraction)); }

    static constexpr float kSmooth = 0.03F;

private:
    struct Fresnel {
        Color reflected, refracted;
    };
    Fresnel fresnel(float cosine) const;
    Color bodyUnder(float cosine) const;
    float coatRoughness() const;
    float chance(RayKind lobe, const Fresnel&) const;
    bool isDelta(RayKind lobe) const;
    std::optional<BsdfSample> scattered(RayKind lobe, const Vec3& micronormal) const;
    std::optional<BsdfSample> delta(RayKind lobe) const;
    Vec3 microNormalOf(bool reflects, const Vec3& wi) const;
    float jacobian(bool reflects, const Vec3& wi, const Vec3& micronormal) const;
    bool sameSide(const Vec3& wi, bool reflects) const;
    Vec3 toLocal(const Vec3& w) const;
    Vec3 toWorld(const Vec3& w) const;

    PhysicalSurface surface_;
    BsdfPlace place_;
    Frame frame_;
    Vec3 wo_; // in the frame
    Ggx ggx_;
    bool smooth_;
    Color body_{0};           // albedo of the body times what its coat lets through from wo, normalised
    float diffuseChance_ = 0; // of pick()
};

}
