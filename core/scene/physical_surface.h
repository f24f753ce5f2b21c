#pragma once
// A material at one point, in the terms of the methods that keep to physics: a smooth or rough interface that
// lets a share of the light through, over a coat on a diffuse body for the rest.

#include "core/base/math.h"
#include "core/scene/material.h"

namespace eyeray {

/// Of a smooth surface at normal and at grazing incidence.
struct Reflectance {
    Color f0{0}, f90{0};
    bool black() const { return isBlack(f0) && isBlack(f90); }
    bool constant() const { return f0 == f90; }
};

struct PhysicalSurface {
    Color diffuse{0};       // albedo of the body under the coat
    Reflectance coat;       // over the body
    Reflectance opaque;     // of all that is opaque: the coat and, by its share, the metal
    float roughness = 0;    // of coat and interface
    float ior = 1.5F;       // η of the object
    float transparency = 0; // share that is an interface: it reflects by Fresnel's equations
    Color tint{1};          // of what passes the interface
    Color emission{0};      // radiance
};

/// As glTF 2.0, appendix B, and its extensions say, but that the body gets what the coat leaves (see
/// Bsdf): the simple mix of the appendix gives more light than it takes at grazing angles.
PhysicalSurface physicalOf(const GltfMaterial&);

/// Roughness and highlight as by asPhysical; kr, ks and kt stay the same at every angle as in the lectures,
/// so that all methods agree on mirrors, glass and diffuse surfaces. Weights that give more light than they
/// take are cut.
PhysicalSurface physicalOf(const TaughtMaterial&);

}
