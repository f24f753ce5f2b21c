#pragma once
// A material at one point, in the terms of the taught methods.

#include "core/base/math.h"
#include "core/scene/material.h"

namespace eyeray {

/// What shading reads at a hit.
struct Surface {
    Color ambient{0}, diffuse{0}, specular{0}; // ka, kd, ks
    float shininess = 1;
    SpecularModel specularModel = SpecularModel::Phong;
    Color reflectivity{0};        // kr at normal incidence
    Color grazingReflectivity{0}; // kr at grazing incidence; equal to kr for a taught material
    Color transmission{0};        // kt
    float dielectric = 0; // share of the light that Fresnel's equations divide; reflected without tint
    float ior = 1.5F;
    Color attenuation{0}; // σ per metre
    Color emission{0};

    bool reflects() const { return !isBlack(reflectivity) || !isBlack(grazingReflectivity); }
    bool transmits() const { return !isBlack(transmission); }
};

/// Taught weights stay as they are at every angle; those of glTF rise towards (1 − roughness)² at grazing
/// incidence, times `specular` where it is no metal, as KHR_materials_specular says.
Surface surfaceOf(const TaughtMaterial&);
Surface surfaceOf(const GltfMaterial&);

}
