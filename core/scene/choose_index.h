#pragma once
// Which index `--accel auto` takes.

#include "core/scene/world.h"

namespace eyeray {

// Brute force tests a shape against as many rays at once as a register holds floats: a ball, a plane and a
// box for about the same, a cylinder or cone for five times as much. What Bvh8 takes before the first test is
// worth about seven balls to paths, whose rays scatter, and more to Whitted's, which lie together. Times of
// whole pictures by brute force, in those by Bvh8, whitted and path, one thread, with AVX-512: homage 0.30,
// 0.96 and bubble 0.46, 0.99 (few balls and planes), window 0.77, 1.14 and cornell 0.61, 1.14 (with boxes),
// shadows 0.93, 1.16 (with a cylinder and a cone).
inline constexpr std::size_t kBruteForceLimit = 7, kCylinderCost = 5; // in balls

/// Brute force if testing everything costs no more than kBruteForceLimit, else Bvh8.
AccelKind chooseIndex(const Scene&);

}
