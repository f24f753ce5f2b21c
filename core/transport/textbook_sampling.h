#pragma once
// Random directions, points and numbers as one first thinks of them.

#include <cstdint>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// normal + a point in the unit ball, normalised. F43: meant to be distributed as the cosine, but crowded
/// about the normal; points on the sphere would be right. A white furnace does not notice. Where u is in [0,
/// 1)³.
template <class T>
Vector<T> aroundNormal(const Vector<T>& normal, const Vector<T>& u) {
    const T z = 1 - 2 * u.x, angle = static_cast<T>(2 * kPiD) * u.y, ring = std::sqrt(1 - z * z);
    const T radius = std::cbrt(u.z);
    return glm::normalize(normal + radius * Vector<T>(ring * std::cos(angle), ring * std::sin(angle), z));
}

/// A point on a lens of radius 1. F44: u for the distance from its middle, where √u would spread them evenly.
template <class T>
glm::vec<2, T> onLens(const glm::vec<2, T>& u) {
    const T angle = static_cast<T>(2 * kPiD) * u.y;
    return u.x * glm::vec<2, T>(std::cos(angle), std::sin(angle));
}

/// Density of directions in the cone of a ball: 1 / 2π(1 − cos θ). F46: 1 − cos θ cancels where it looks
/// small, and is 0 at 1/10,000 in float.
template <class T>
T conePdfW(T radius, T distance) {
    const T sine = radius / distance;
    return 1 / (static_cast<T>(2 * kPiD) * (1 - std::sqrt(1 - sine * sine)));
}

/// u / 2³² for a number in [0, 1). F51: rounds to 1 for the last 128 of them in float.
template <class T>
T toUnit(std::uint32_t bits) {
    return static_cast<T>(bits) * static_cast<T>(0x1p-32);
}

/// The first number of a linear congruential generator with this seed: S. K. Park, K. W. Miller 1988, "Random
/// Number Generators: Good Ones Are Hard to Find". F50: neighbours' seeds give neighbours' numbers.
template <class T>
T firstOfSeed(std::uint32_t seed) {
    constexpr std::uint64_t kFactor = 16807, kModulus = 2147483647;
    return static_cast<T>(kFactor * (seed + 1) % kModulus) / static_cast<T>(kModulus);
}

/// The digits of `index` in a base, mirrored at the point. J. Halton 1960, "On the Efficiency of Certain
/// Quasi-random Sequences of Points". F52: in high bases the first points lie on few lines.
template <class T>
T halton(std::uint32_t index, std::uint32_t base) {
    T place = 1, value = 0;
    for (; index > 0; index /= base) {
        place /= static_cast<T>(base);
        value += place * static_cast<T>(index % base);
    }
    return value;
}

}
