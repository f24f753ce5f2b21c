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

/// The same light while a bounce still weighs `cutoff` or more. F40: what is cut off is the whole rest of the
/// series, albedo^k / (1 − albedo). After R. Hall, D. Greenberg 1983, "A Testbed for Realistic Image
/// Synthesis".
template <class T>
T furnaceCutOff(T albedo, T cutoff) {
    T sum = 0, weight = 1;
    while (weight >= cutoff) {
        sum += weight;
        weight *= albedo;
    }
    return sum;
}

/// The same light if each bounce takes the walls for lamps, and counts their glow again where the path goes
/// on. F42: each is right for itself; together they want weights (E. Veach, L. Guibas 1995).
template <class T>
T furnaceLitTwice(T albedo) {
    constexpr T kNothing = T(1e-9);
    T sum = 0, weight = 1;
    while (weight > kNothing) {
        sum += weight + weight * albedo;
        weight *= albedo;
    }
    return sum;
}

}
