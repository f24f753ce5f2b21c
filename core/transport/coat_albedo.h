#pragma once
// How much light a rough coat reflects altogether: what is left is for the body under it.

#include "core/scene/physical_surface.h"

namespace eyeray {

/// Light that a GGX coat reflects once, of what arrives from one direction or from all directions alike, as
/// shares of white: with reflectance 1 everywhere, and with one that rises from 0 to 1 as fresnelRise does.
struct CoatAlbedo {
    float constant = 1, rising = 0;

    Color of(const Reflectance& r) const {
        return r.constant() ? r.f0 * constant : r.f0 * (constant - rising) + r.f90 * rising;
    }
};

/// From a direction with this cosine to the normal; 0 ≤ roughness ≤ 1. Read from a table that is computed
/// when first asked for, linear between its nodes: right to 0.005, and exact for roughness 0.
CoatAlbedo directionalAlbedo(float cosine, float roughness, float ior);

/// Mean of the same over all directions, weighed by their cosine.
CoatAlbedo meanAlbedo(float roughness, float ior);

}
