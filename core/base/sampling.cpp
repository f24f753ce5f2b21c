#include "core/base/sampling.h"

namespace eyeray {
namespace {

constexpr std::uint32_t reverseBits(std::uint32_t v) {
    v = (v << 16U) | (v >> 16U);
    v = ((v & 0x00ff00ffU) << 8U) | ((v & 0xff00ff00U) >> 8U);
    v = ((v & 0x0f0f0f0fU) << 4U) | ((v & 0xf0f0f0f0U) >> 4U);
    v = ((v & 0x33333333U) << 2U) | ((v & 0xccccccccU) >> 2U);
    return ((v & 0x55555555U) << 1U) | ((v & 0xaaaaaaaaU) >> 1U);
}

// Burley 2020, section 2.4, with N. Vegdahl's constants (2021, "Building a Better LK Hash").
constexpr std::uint32_t laineKarrasPermutation(std::uint32_t v, std::uint32_t seed) {
    v ^= v * 0x3d20adeaU;
    v += seed;
    v *= (seed >> 16U) | 1U;
    v ^= v * 0x05526c56U;
    v ^= v * 0x53a22864U;
    return v;
}

constexpr std::uint32_t owenScramble(std::uint32_t v, std::uint32_t seed) {
    return reverseBits(laineKarrasPermutation(reverseBits(v), seed));
}

// Second Sobol' dimension, its bits in reverse. Its direction numbers are the rows of Pascal's triangle
// modulo 2, in which bit j of row i is set where j's bits are among i's: so each bit becomes the sum of those
// whose numbers contain its own, which five halvings add up.
constexpr std::uint32_t sobolSecondDimensionReversed(std::uint32_t index) {
    index ^= (index >> 1U) & 0x55555555U;
    index ^= (index >> 2U) & 0x33333333U;
    index ^= (index >> 4U) & 0x0f0f0f0fU;
    index ^= (index >> 8U) & 0x00ff00ffU;
    return index ^ (index >> 16U);
}

// Of a sequence: all that addresses a number but which sample it is for.
constexpr std::uint32_t keyOf(const SampleAddress& address, std::uint32_t node, SamplePurpose purpose) {
    std::uint32_t key = hashCombine(address.seed, address.x);
    key = hashCombine(key, address.y);
    key = hashCombine(key, node);
    return hashCombine(key, static_cast<std::uint32_t>(purpose));
}

Vec2 independent2(std::uint32_t key, std::uint32_t pass) {
    const std::uint32_t own = hashCombine(key, pass);
    return {toUnitFloat(hashCombine(own, 1)), toUnitFloat(hashCombine(own, 2))};
}

// Cells are taken in an order of their own for each 16 samples. A. Kensler 2013, "Correlated Multi-Jittered
// Sampling", section 3, for the permutation: bijective steps on four bits.
Vec2 stratified2(std::uint32_t key, std::uint32_t pass) {
    constexpr std::uint32_t kSide = 4, kCells = kSide * kSide;
    const std::uint32_t round = hashCombine(key, pass / kCells);
    std::uint32_t cell = (pass % kCells) ^ (round & 15U);
    cell = (cell * ((round >> 4U) | 1U)) & 15U;
    cell ^= cell >> 2U;
    cell = (cell * ((round >> 8U) | 1U) + (round >> 12U)) & 15U;
    const Vec2 jitter = independent2(hashCombine(key, 3), pass);
    return (Vec2(cell % kSide, cell / kSide) + jitter) / static_cast<float>(kSide);
}

}

Vec2 sobol2(const SampleAddress& address, std::uint32_t node, SamplePurpose purpose) {
    const std::uint32_t key = keyOf(address, node, purpose);
    const std::uint32_t index = owenScramble(address.pass, key);
    // Scrambling begins by reversing the bits, as the first dimension does: twice is not at all.
    const auto scrambled = [&](std::uint32_t reversed, std::uint32_t axis) {
        return toUnitFloat(reverseBits(laineKarrasPermutation(reversed, hashCombine(key, axis))));
    };
    return {scrambled(index, 1), scrambled(sobolSecondDimensionReversed(index), 2)};
}

Vec2 sample2(Sampler sampler, const SampleAddress& address, std::uint32_t node, SamplePurpose purpose) {
    switch (sampler) {
    case Sampler::Independent:
        return independent2(keyOf(address, node, purpose), address.pass);
    case Sampler::Stratified:
        return stratified2(keyOf(address, node, purpose), address.pass);
    case Sampler::Sobol:
        break;
    }
    return sobol2(address, node, purpose);
}

Vec2 pixelSample(const SampleAddress& address) {
    if (address.pass == 0) return Vec2(0.5F);
    return sobol2(address, 0, SamplePurpose::PixelFilter);
}

}
