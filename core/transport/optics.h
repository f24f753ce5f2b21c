#pragma once
// Mirror and glass: directions and shares. Directions are unit; wo points away from the surface, to where the
// ray came from, and the normal is on wo's side.

#include <optional>

#include "core/base/math.h"

namespace eyeray {

/// Mirrored direction 2(n·wo)n − wo, unit, away from the surface.
inline Vec3 reflected(const Vec3& wo, const Vec3& normal) { return 2 * glm::dot(normal, wo) * normal - wo; }

/// Refracted direction by Snell's law, unit, or nothing on total internal reflection. `eta` = η of wo's side
/// / η of the other side.
std::optional<Vec3> refracted(const Vec3& wo, const Vec3& normal, float eta);

/// Share of unpolarised light that a smooth dielectric reflects, 0 to 1; 1 beyond the critical angle.
/// `cosine` = n·wo ≥ 0, `eta` as above. Born, Wolf 1999, "Principles of Optics" 7th ed., section 1.5.2.
float fresnelDielectric(float cosine, float eta);

/// How far between normal (0) and grazing incidence (1) the reflectance of a smooth dielectric of index `ior`
/// in vacuum has risen: (F − F0) / (1 − F0), the shape of every coat's reflectance here.
float fresnelRise(float cosine, float ior);

/// e^(−σd) per channel; d may be infinite.
Color transmittanceOf(const Color& attenuation, float distance);

}
