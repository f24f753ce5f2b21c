#pragma once
// Water in a glass: solids whose faces lie in the same place.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/geometry/accel.h"

namespace eyeray {

/// A transparent solid of a World.
struct GlassSolid {
    std::uint32_t instance;
    DMat4 toWorld;
};

/// Of two solids with faces in the same place, the smaller is made to reach into the larger by some units in
/// the last place: so a ray goes from the one into the other, where else it would leave the one by a face,
/// start behind the other's, and never enter that. Solids that lie apart keep their bits. Of many pairs of
/// solids whose boxes meet, the first 64 are looked at.
template <class Index>
void joinTouchingGlass(std::vector<Instance<Index>>&, const std::vector<GlassSolid>&, const std::stop_token&);

}
