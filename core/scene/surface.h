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
    Color reflectivity{0};        // kr of the constant weights
    Color transmission{0};        // kt of the constant weights
    Color normalReflectivity{0};  // mirror share beside that of Fresnel's equations, at normal incidence
    Color grazingReflectivity{0}; // the same at grazing incidence
    float dielectric = 0;         // share that reflects by Fresnel's equations, without tint
    Color refractable{0};         // share that refracts where they reflect nothing
    float ior = 1.5F;
    Color attenuation{0}; // σ per metre
    Color emission{0};

    bool reflects() const { return !isBlack(reflectivity) || !isBlack(grazingReflectivity); }
    bool transmits() const { return !isBlack(transmission); }
};

/// A taught mirror is the same at every angle; that of glTF rises towards (1 − roughness)² at grazing
/// incidence, times `specular` where it is no metal, as KHR_materials_specular says.
Surface surfaceOf(const TaughtMaterial&);
Surface surfaceOf(const GltfMaterial&);

}
