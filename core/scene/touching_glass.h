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
/// start behind the other's, and never enter that. Solids that lie apart or overlap already keep their bits.
/// Shared faces are found where one of kLines random lines through what both boxes hold meets them; of more
/// than kPairs pairs of solids whose boxes meet, the rest stay as they are.
template <class Index>
void joinTouchingGlass(std::vector<Instance<Index>>&, const std::vector<GlassSolid>&, const std::stop_token&);

}
