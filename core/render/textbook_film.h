#pragma once
// Sums of samples and their display, the simple way.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace eyeray::textbook {

/// Mean of n samples from that of n − 1, kept in 8 bits. F57: stops moving once (sample − mean)/n rounds to
/// 0.
inline std::uint8_t blended(std::uint8_t mean, std::uint8_t sample, int n) {
    return static_cast<std::uint8_t>(std::lround(mean + (sample - mean) / static_cast<double>(n)));
}

/// A linear value as a byte by a power of 1/2.2, cut to whole bytes. F55: up to 8 codes off sRGB in the dark.
template <class T>
std::uint8_t encoded(T linear) {
    return static_cast<std::uint8_t>(T(255) * std::pow(linear, 1 / T(2.2)));
}

/// The sum of all samples, each of `parts` threads its own part of them first. F62: the parts round in other
/// places, so every number of threads gives another sum.
template <class T>
T sumOfParts(std::span<const float> samples, int parts) {
    T sum = 0;
    const std::size_t size =
        (samples.size() + static_cast<std::size_t>(parts) - 1) / static_cast<std::size_t>(parts);
    for (std::size_t first = 0; first < samples.size(); first += size) {
        T part = 0;
        for (const float sample : samples.subspan(first, std::min(size, samples.size() - first)))
            part += sample;
        sum += part;
    }
    return sum;
}

/// Mean of `draw()` until its own standard error, looked at from the 16th sample on, is below `tolerance`.
/// F49: a pixel that by chance has met no light yet takes itself for done.
template <class T, class Draw>
T meanUntilCalm(const Draw& draw, T tolerance) {
    constexpr int kLeast = 16, kMost = 1 << 14;
    T sum = 0, squares = 0;
    for (int n = 1;; ++n) {
        const T x = draw();
        sum += x;
        squares += x * x;
        const T mean = sum / static_cast<T>(n), variance = squares / static_cast<T>(n) - mean * mean;
        if (n == kMost || (n >= kLeast && variance < tolerance * tolerance * static_cast<T>(n))) return mean;
    }
}

}
