#pragma once
// Random numbers that are addressed, not drawn: each is a pure function of where it is used. So a picture
// repeats on any number of threads, and switching one ray off changes no other number.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/math.h"

namespace eyeray {

#include "core/base/bit_mixing.h"

/// What a number is used for; one value for each place in the code that asks.
enum class SamplePurpose : std::uint8_t { PixelFilter = 1, Lens, Lobe, Direction, Lamp, Roulette };

/// How the numbers of a pixel's samples are spread. independent: not at all. stratified: of each 16 samples
/// one lies in each cell of a 4 × 4 grid. sobol: Owen-scrambled (0,2)-sequence.
enum class Sampler : std::uint8_t { Independent, Stratified, Sobol };
inline constexpr std::array<std::string_view, 3> kSamplerNames = {"independent", "stratified", "sobol"};

/// Which sample of which pixel.
struct SampleAddress {
    std::uint32_t seed = 0;
    std::uint32_t x = 0, y = 0;
    std::uint32_t pass = 0;
};

/// Bijective mixing of 32 bits.
constexpr std::uint32_t hash32(std::uint32_t v) { return mixing::hash(v); }

constexpr std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b) { return mixing::combine(a, b); }

/// [0, 1) from the top 24 bits; never 1.
constexpr float toUnitFloat(std::uint32_t bits) { return static_cast<float>(bits >> 8U) * 0x1p-24F; }

/// Point `address.pass` of a pixel's own Owen-scrambled Sobol' (0,2)-sequence in [0, 1)².
/// `node` is the key of the ray-tree node that asks. Consecutive passes of a pixel are jointly stratified.
/// Scrambling by hash: B. Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 10(4).
Vec2 sobol2(const SampleAddress& address, std::uint32_t node, SamplePurpose purpose);

/// Point `address.pass` in [0, 1)² of the sequence that a sampler has for this pixel, node and purpose.
Vec2 sample2(Sampler, const SampleAddress&, std::uint32_t node, SamplePurpose);

/// Where in its pixel a sample lies, in [0, 1)²: the exact centre for pass 0, then the pixel's Sobol'
/// sequence (box filter).
Vec2 pixelSample(const SampleAddress& address);

}
