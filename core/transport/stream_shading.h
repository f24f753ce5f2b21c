// Shading of several hits at once, through the same steps as shading_point.h, direct_light.h and next_rays.h
// take one: the results are the same bits. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_SHADING_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_SHADING_H
#undef EYERAY_STREAM_SHADING_H
#else
#define EYERAY_STREAM_SHADING_H
#endif

#include "core/geometry/ray_lanes.h"
#include "core/scene/world.h"
#include "core/transport/settings.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// As ShadingPoint.
struct ShadingLanes {
    const SurfaceLanes& at;
    Vec3Lanes wo, normal, geometricNormal;
    FloatMask front;
};

HWY_INLINE ShadingLanes shadingOf(const SurfaceLanes& at, const Vec3Lanes& direction) {
    const auto zero = hn::Zero(FloatTag());
    const Vec3Lanes wo = -direction;
    const auto front = dot(at.geometricNormal, wo) >= zero;
    const Vec3Lanes geometricNormal = select(front, at.geometricNormal, -at.geometricNormal);
    const auto sameSide = dot(at.shadingNormal, at.geometricNormal) >= zero;
    const auto same = hn::Not(hn::Xor(front, sameSide));
    const Vec3Lanes normal = select(same, at.shadingNormal, -at.shadingNormal);
    const auto seen = dot(normal, wo) > zero;
    return {at, wo, select(seen, normal, geometricNormal), geometricNormal, front};
}

/// Surfaces of materials of one model: one that all lanes share, but for what tints its diffuse colours, or
/// one for each lane. Its values are brought into lanes where they are used.
class MaterialLanes {
public:
    explicit MaterialLanes(const Surface& shared, const Vec3Lanes& tint = all(Color(1)))
        : first_(&shared), tint_(tint) {}
    explicit MaterialLanes(const std::array<Surface, kLanes>& surfaces) : MaterialLanes(surfaces[0]) {
        shared_ = false;
    }

    SpecularModel specularModel() const { return first_->specularModel; }
    HWY_INLINE Vec3Lanes ambient() const { return of(&Surface::ambient) * tint_; }
    HWY_INLINE Vec3Lanes diffuse() const { return of(&Surface::diffuse) * tint_; }
    HWY_INLINE Vec3Lanes of(Color Surface::* member) const {
        return shared_ ? all(first_->*member) : gatheredOf(member);
    }
    HWY_INLINE FloatLanes of(float Surface::* member) const {
        return shared_ ? all(first_->*member) : gatheredOf(member);
    }
    /// In all lanes.
    HWY_INLINE bool isBlack(Color Surface::* member) const {
        if (shared_) return eyeray::isBlack(first_->*member);
        return hn::AllFalse(FloatTag(), notBlack(gatheredOf(member)));
    }

private:
    Vec3Lanes gatheredOf(Color Surface::* member) const {
        Spread3 s;
        for (std::size_t lane = 0; lane < kLanes; ++lane) s.set(lane, first_[lane].*member);
        return gathered(s);
    }
    FloatLanes gatheredOf(float Surface::* member) const {
        Spread s;
        for (std::size_t lane = 0; lane < kLanes; ++lane) s.lane[lane] = first_[lane].*member;
        return gathered(s);
    }

    const Surface* first_;
    bool shared_ = true;
    Vec3Lanes tint_;
};

/// As LightSample, in the lanes that the lamp shines to.
struct LightLanes {
    FloatMask shines;
    Vec3Lanes wi;
    FloatLanes distance;
    Vec3Lanes irradiance;
};

HWY_INLINE LightLanes sampleLight(const WorldLight& light, const Vec3Lanes& position) {
    const auto zero = hn::Zero(FloatTag()), one = all(1.0F);
    const Vec3Lanes emission = all(light.emission);
    if (light.kind == WorldLight::Kind::Directional)
        return {zero == zero, all(-light.direction), all(kInfinity), emission};
    const Vec3Lanes to = all(light.position) - position;
    const auto distance = hn::Sqrt(dot(to, to));
    const Vec3Lanes wi = to / distance;
    auto factor = one;
    if (light.kind != WorldLight::Kind::Point) {
        const auto cosine = hn::Neg(dot(all(light.direction), wi));
        if (light.kind == WorldLight::Kind::Facing) {
            factor = hn::Max(zero, cosine);
        } else {
            const auto width = all(std::max(light.cosInner - light.cosOuter, 1e-4F));
            const auto edge = hn::Min(hn::Max((cosine - all(light.cosOuter)) / width, zero), one);
            factor = edge * edge;
        }
    }
    if (light.falloff) factor = factor / (distance * distance);
    const auto near = hn::And(distance > zero, distance <= all(light.range));
    return {hn::And(near, factor > zero), wi, distance, emission * factor};
}

/// As Environment::radiance.
HWY_INLINE Vec3Lanes radianceOf(const Environment& environment, const Vec3Lanes& direction) {
    const auto below = direction.y < hn::Zero(FloatTag());
    const Vec3Lanes end = select(below, all(environment.nadir), all(environment.zenith));
    const auto share = hn::Sqrt(hn::Abs(direction.y));
    return all(environment.horizon) * (all(1.0F) - share) + end * share;
}

HWY_INLINE Vec3Lanes reflected(const Vec3Lanes& wo, const Vec3Lanes& normal) {
    return normal * (all(2.0F) * dot(normal, wo)) - wo;
}

/// The local model's kd (n·l) + ks (lobe), black in lanes that `asked` leaves out.
inline Vec3Lanes localModel(const ShadingLanes& p, const MaterialLanes& m, const Vec3Lanes& wi,
                            FloatMask asked) {
    const FloatTag f;
    const auto zero = hn::Zero(f);
    const auto cosine = dot(p.normal, wi);
    const auto lit = hn::And(cosine > zero, asked);
    const Vec3Lanes diffuse = m.diffuse() * cosine;
    if (m.isBlack(&Surface::specular)) return orZero(lit, diffuse);
    Vec3Lanes specular = all(Color(0));
    const Vec3Lanes ks = m.of(&Surface::specular);
    const auto shiny = hn::And(lit, notBlack(ks));
    if (!hn::AllFalse(f, shiny)) {
        const auto base = m.specularModel() == SpecularModel::Phong ? dot(reflected(wi, p.normal), p.wo)
                                                                    : dot(p.normal, normalize(wi + p.wo));
        Spread lobe = spread(hn::Zero(f));
        const Spread bases = spread(base), exponents = spread(m.of(&Surface::shininess));
        for (std::uint32_t bits = bitsOf(hn::And(shiny, base > zero)); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            lobe.lane[lane] = std::pow(bases.lane[lane], exponents.lane[lane]);
        }
        specular = orZero(shiny, ks * gathered(lobe));
    }
    return orZero(lit, diffuse + specular);
}

/// How light bends at a surface, as optics.h has it: cosines of the angles on both sides of it.
struct BendLanes {
    DoubleLanes cosine, eta;
    DoubleMask total; // internal reflection: there is no inner cosine
    DoubleLanes inner;

    BendLanes(FloatLanes cosineHere, FloatLanes etaHere) : cosine(widen(cosineHere)), eta(widen(etaHere)) {
        const auto one = all(1.0);
        const auto sine2 = eta * eta * max(all(0.0), (one - cosine) * (one + cosine));
        total = sine2 >= one;
        inner = sqrt(one - sine2);
    }
};

/// Not a number on total internal reflection.
HWY_INLINE Vec3Lanes refracted(const BendLanes& bend, const Vec3Lanes& wo, const Vec3Lanes& normal,
                               FloatLanes eta) {
    const auto along = select(bend.total, all(std::numeric_limits<double>::quiet_NaN()),
                              bend.eta * bend.cosine - bend.inner);
    return normalize(wo * hn::Neg(eta) + normal * narrow(along));
}

HWY_INLINE FloatLanes fresnelDielectric(const BendLanes& bend) {
    const auto c = min(max(bend.cosine, all(0.0)), all(1.0)), ec = bend.eta * c, ei = bend.eta * bend.inner;
    const auto a = ec - bend.inner, b = ec + bend.inner, d = c - ei, f = c + ei;
    const auto af = a * f, bd = b * d, bf = b * f;
    const auto share = all(0.5) * (af * af + bd * bd) / (bf * bf);
    return narrow(select(bend.total, all(1.0), share));
}

HWY_INLINE Vec3Lanes mirrorShare(const MaterialLanes& m, FloatLanes cosine) {
    const FloatTag f;
    const auto zero = hn::Zero(f), one = all(1.0F);
    const Vec3Lanes a = m.of(&Surface::normalReflectivity), b = m.of(&Surface::grazingReflectivity);
    const auto rises = hn::Or(hn::Or(a.x != b.x, a.y != b.y), a.z != b.z);
    if (hn::AllFalse(f, rises)) return a;
    const auto ior = m.of(&Surface::ior);
    const auto root = (ior - one) / (ior + one);
    const auto f0 = root * root;
    auto rise = (fresnelDielectric({cosine, one / ior}) - f0) / (one - f0);
    rise = hn::Max(hn::IfThenElseZero(f0 < one, rise), zero);
    return select(rises, a + (b - a) * rise, a);
}

HWY_INLINE Vec3Lanes mirrorDirection(const ShadingLanes& p) {
    const Vec3Lanes direction = reflected(p.wo, p.normal);
    const auto inFront = dot(direction, p.geometricNormal) > hn::Zero(FloatTag());
    return select(inFront, direction, reflected(p.wo, p.geometricNormal));
}

/// As NextRays; media and the η between them are found one by one.
struct NextLanes {
    Vec3Lanes reflection, refraction, reflectedShare, refractedShare;
};

HWY_INLINE NextLanes mirrored(const ShadingLanes& p, const MaterialLanes& m, FresnelMode fresnel) {
    NextLanes next;
    next.reflectedShare =
        fresnel == FresnelMode::Exact ? mirrorShare(m, dot(p.normal, p.wo)) : m.of(&Surface::reflectivity);
    next.reflection = mirrorDirection(p);
    next.refraction = next.refractedShare = all(Color(0));
    return next;
}

/// Adds what glass does. Total internal reflection takes all that Fresnel's equations divide, whatever the
/// weights. `eta` as in NextRays, `solid` where the surface has an inside.
HWY_INLINE void addGlass(const ShadingLanes& p, const MaterialLanes& m, FresnelMode fresnel, FloatLanes eta,
                         FloatMask solid, NextLanes& next) {
    const FloatTag f;
    const auto zero = hn::Zero(f), one = all(1.0F);
    const Vec3Lanes transmission = m.of(&Surface::transmission);
    const auto glass = notBlack(transmission);
    const auto cosine = dot(p.normal, p.wo);
    const BendLanes bend(cosine, eta);
    Vec3Lanes direction = refracted(bend, p.wo, p.normal, eta);
    const auto wrongSide = dot(direction, p.geometricNormal) >= zero;
    if (!hn::AllFalse(f, wrongSide))
        direction =
            select(wrongSide, refracted({dot(p.geometricNormal, p.wo), eta}, p.wo, p.geometricNormal, eta),
                   direction);
    const auto passes = direction.x == direction.x;
    const auto total = hn::And(hn::AndNot(passes, solid), glass);
    const auto some = hn::AndNot(total, glass);
    Vec3Lanes reflects = next.reflectedShare, refracts = transmission;
    if (fresnel == FresnelMode::Exact) {
        const auto reflectance = fresnelDielectric(bend);
        const auto added = m.of(&Surface::dielectric) * reflectance;
        reflects = {reflects.x + added, reflects.y + added, reflects.z + added};
        refracts = m.of(&Surface::refractable) * (one - reflectance);
    }
    next.reflectedShare = select(some, reflects, next.reflectedShare);
    if (!hn::AllFalse(f, total)) {
        const Vec3Lanes mirror = mirrorShare(m, cosine);
        const auto dielectric = m.of(&Surface::dielectric);
        const Vec3Lanes all3{mirror.x + dielectric, mirror.y + dielectric, mirror.z + dielectric};
        next.reflectedShare = select(total, all3, next.reflectedShare);
    }
    next.refractedShare = orZero(some, refracts);
    next.refraction = select(solid, direction, -p.wo);
}

}
HWY_AFTER_NAMESPACE();

#endif
