#pragma once
// Which index `--accel auto` takes.

#include "core/scene/world.h"

namespace eyeray {

// Brute force tests a ray against everything, eight rays at a time: 2.3 ns for a ball, 2.7 for a plane, 4 for
// a box, 13 for a cylinder or cone. What Bvh8 takes before the first test is worth about seven balls: whole
// pictures by brute force took 0.46 times as long on bubble (six balls and planes), 0.74 on window (seven and
// boxes), but 1.9 on cornell (eight) and 3.2 on shadows (two, a cylinder and a cone); one thread.
inline constexpr std::size_t kBruteForceLimit = 7, kCylinderCost = 5; // in balls

/// Brute force if testing everything costs no more than kBruteForceLimit, else Bvh8.
AccelKind chooseIndex(const Scene&);

}
