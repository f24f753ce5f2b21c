#include "core/base/sampling.h"

namespace eyeray {
namespace {

constexpr std::uint32_t keyOf(const SampleAddress& address, std::uint32_t node, SamplePurpose purpose) {
    return mixing::keyOf(address.seed, address.x, address.y, node, static_cast<std::uint32_t>(purpose));
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
    const auto point = mixing::sobol(address.pass, keyOf(address, node, purpose));
    return {toUnitFloat(point.x), toUnitFloat(point.y)};
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
