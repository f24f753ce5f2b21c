#pragma once
// Objects whose faces lie in the same place: which one a ray meets first is a matter of rounding.

#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/geometry/accel.h"

namespace eyeray {

/// How the faces look that two objects share: to opposite sides, as those of two blocks side by side, or some
/// of them to the same side.
enum class SharedFaces : std::uint8_t { None, Opposed, Alike };

/// Looks along random lines through what both boxes hold: a shared face is found if it has more than about a
/// hundredth of the area there.
template <class Index>
SharedFaces sharedFaces(const Instance<Index>&, const Instance<Index>&);

/// How far rounding may move a face of either object, per axis, and some more.
template <class Index>
Vec3 roundingReach(const Instance<Index>&, const Instance<Index>&);

/// Pairs of the bounded objects among `ids` whose boxes meet, the first `most` of them.
template <class Index>
std::vector<std::pair<std::uint32_t, std::uint32_t>>
meetingPairs(const std::vector<Instance<Index>>&, std::span<const std::uint32_t> ids, std::size_t most);

}
