#pragma once
// Paths of random length.

namespace eyeray::textbook {

/// Light that a path collects in a closed room that glows with radiance 1 and reflects `albedo`; `draw` gives
/// numbers in [0, 1). From the third bounce on it goes on with probability `albedo`. F41: without dividing by
/// that probability all later light is too dark. After J. Arvo, D. Kirk 1990, "Particle Transport and Image
/// Synthesis".
template <class T, class Draw>
T furnaceByRoulette(T albedo, const Draw& draw) {
    constexpr int kFirst = 3;
    T sum = 0, weight = 1;
    for (int bounce = 0;; ++bounce) {
        sum += weight;
        if (bounce >= kFirst && draw() >= albedo) return sum;
        weight *= albedo;
    }
}

}
