#pragma once
// Which index `--accel auto` takes.

#include "core/scene/world.h"

namespace eyeray {

// Brute force tests a ray against everything, eight rays at a time: 2.3 ns for a ball, 2.7 for a plane, 4 for
// a box, 13 for a cylinder or cone. What Bvh8 takes before the first test is worth about seven balls to
// paths, whose rays scatter, and more to Whitted's, which lie together. Times of whole pictures by brute
// force, in those by Bvh8, whitted and path, one thread: homage 0.42, 0.95 and bubble 0.54, 1.00 (few balls
// and planes), window 0.85, 1.14 and cornell 0.79, 1.14 (with boxes), shadows 1.20, 1.12 (with a cylinder and
// a cone).
inline constexpr std::size_t kBruteForceLimit = 7, kCylinderCost = 5; // in balls

/// Brute force if testing everything costs no more than kBruteForceLimit, else Bvh8.
AccelKind chooseIndex(const Scene&);

}
