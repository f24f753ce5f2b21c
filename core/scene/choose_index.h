#pragma once
// Which index `--accel auto` takes.

#include "core/scene/world.h"

namespace eyeray {

// By streams, brute force tests a shape against as many rays at once as a register holds floats: a ball, a
// plane and a box for about the same, a cylinder or cone, which is taken ray by ray, for six times as much.
// One ray after the other, it saves no more than what Bvh8 takes before the first test. Times of whole
// pictures by brute force, in those by Bvh8, one thread, of whitted with AVX-512 and with AVX2, and of path:
// homage 0.30, 0.45, 0.96 and bubble 0.46, 0.54, 0.99 to 1.1 (few balls and planes), cornell 0.61,
// 0.95, 1.15, window 0.77, 0.95, 1.1, local_global 0.61, 0.95, 1.25 (with boxes), perspective 0.61, 0.95, 1.1
// (ten balls), shadows 0.93, 1.55, 1.15 (a cylinder and a cone), phong (fifteen balls) 1.2 with AVX2.
inline constexpr std::size_t kMostByStreams = 11, kMostOneByOne = 5, kCylinderCost = 6; // in balls

/// What Auto becomes: brute force if testing all that an index would hold costs no more than these, else
/// Bvh8. Any other kind is taken as it stands.
AccelKind chooseIndex(const Scene&, const BuildSettings&);

}
