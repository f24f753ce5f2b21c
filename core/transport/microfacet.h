#pragma once
// The GGX distribution of microfacets. Directions are unit, in the frame of the surface: its normal is +z.
// Trowbridge, Reitz 1975, "Average Irregularity Representation of a Rough Surface for Ray Reflection"; Walter
// et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".

#include "core/base/math.h"

namespace eyeray {

struct Ggx {
    float alpha; // > 0: slope of the microfacets, roughness²

    /// Area of microfacets of normal h for each unit of area and solid angle. `h.z` ≥ 0.
    float distribution(const Vec3& h) const;

    /// Share of the microfacets that w sees, 0 to 1: Smith's masking. On either side.
    float masking(const Vec3& w) const;

    /// Share that both see, on any sides, height-correlated: Heitz 2014, "Understanding the Masking-Shadowing
    /// Function in Microfacet-Based BRDFs", section 6.3.
    float maskingShadowing(const Vec3& wo, const Vec3& wi) const;

    /// A normal among those that wo sees, from u in [0, 1)². `wo.z` > 0. Heitz 2018, "Sampling the GGX
    /// Distribution of Visible Normals", JCGT 7(4).
    Vec3 visibleNormal(const Vec3& wo, const Vec2& u) const;

    /// Its density in solid angle around h. `wo.z` > 0.
    float visibleDensity(const Vec3& wo, const Vec3& h) const;
};

}
