#pragma once
// Which index `--accel auto` takes.

#include "core/scene/world.h"

namespace eyeray {

// By streams, brute force tests a shape against as many rays at once as a register holds floats: a ball, a
// plane and a box for about the same, a cylinder or cone, which is taken ray by ray, for six times as much;
// Bvh8 takes those that lie together as packets. One ray after the other, brute force saves no more than what
// Bvh8 takes before the first test. Times of whole pictures by brute force, in those by Bvh8, one thread,
// AVX2, of whitted and of path: homage 0.45, 0.95 to 1.1, bubble 0.63, 1.1 and checkerboard 0.79, 0.95 (few
// balls and planes), window 1.05, 1.1, local_global 1.13, 1.25 and cornell 1.24, 1.15 (with boxes),
// perspective 1.9, 1.2 (ten balls), shadows 2.1, 1.15 (a cylinder and a cone).
inline constexpr std::size_t kMostByStreams = 7, kMostOneByOne = 5, kCylinderCost = 6; // in balls

/// What Auto becomes: brute force if testing all that an index would hold costs no more than these, else
/// Bvh8. Any other kind is taken as it stands.
AccelKind chooseIndex(const Scene&, const BuildSettings&);

}
