#include "core/transport/faults.h"

namespace eyeray {

Vec2 badlySeeded(const SampleAddress& address, int width, std::uint32_t node, SamplePurpose purpose) {
    constexpr std::uint64_t kModulus = 0x7fffffff, kMultiplier = 48271;
    const std::uint32_t pixel = address.y * static_cast<std::uint32_t>(width) + address.x;
    const std::uint32_t use = node == 0 ? 0 : hashCombine(node, static_cast<std::uint32_t>(purpose));
    std::uint64_t state = (static_cast<std::uint64_t>(pixel) + 1 + use) % kModulus;
    const auto next = [&] {
        state = state * kMultiplier % kModulus;
        return static_cast<float>(state >> 7U) * 0x1p-24F;
    };
    const float first = next();
    return {first, next()};
}

}
