#pragma once
// The ways of photons as arrows in space.

#include <span>

#include "app/rayview/arrows.h"
#include "core/study/photon_walk.h"

namespace eyeray {

/// The arrows of photons, thinner and fainter with the power that is left. The first of each has the kind
/// Shadow, for light straight from a lamp; those that leave the scene are drawn `reach` metres long.
std::vector<Arrow> arrowsOf(std::span<const PhotonPath>, float reach);

/// What the arrows' kinds are called.
inline constexpr std::array<std::string_view, kRayKinds> kPhotonKindNames = {
    "eye", "from the lamp", "mirrored", "refracted", "scattered"};

}
