#include "core/study/palette.h"

namespace eyeray {

std::uint32_t colorOfKind(RayKind kind, bool dark) {
    constexpr std::array<std::uint32_t, kRayKinds> kOnDark = {0xf0e442, 0xa9afbd, 0x56b4e9, 0x3fd0a0,
                                                              0xd98cc0};
    constexpr std::array<std::uint32_t, kRayKinds> kOnLight = {0x8a7d00, 0x5d6577, 0x0072b2, 0x007a58,
                                                               0xa8487f};
    return (dark ? kOnDark : kOnLight)[static_cast<std::size_t>(kind)];
}

std::uint32_t colorOfBox(SpaceBox::Role role, bool dark) {
    constexpr std::array<std::uint32_t, 5> kOnDark = {0x7cc4f5, 0xf2a33c, 0x4fdc8b, 0x8f96a8, 0xffe14d};
    constexpr std::array<std::uint32_t, 5> kOnLight = {0x0b62a8, 0xb35c00, 0x0a8043, 0x7d8596, 0x9a6a00};
    return (dark ? kOnDark : kOnLight)[static_cast<std::size_t>(role)];
}

std::uint32_t colorOfSeries(int number, bool dark) {
    constexpr std::array<std::uint32_t, kSeriesColors> kOnDark = {0x56b4e9, 0xff8f4d, 0x3fd0a0,
                                                                  0xd98cc0, 0xf0e442, 0xb4bacb};
    constexpr std::array<std::uint32_t, kSeriesColors> kOnLight = {0x0072b2, 0xc24a00, 0x00805d,
                                                                   0xa8488f, 0x8a7d01, 0x5d6578};
    return (dark ? kOnDark : kOnLight)[static_cast<std::size_t>(number) % kSeriesColors];
}

std::uint32_t shownColor(const Color& radiance, const DisplaySettings& settings) {
    std::array<Rgba8, 1> shown;
    display(std::span(&radiance, 1), settings, shown);
    return static_cast<std::uint32_t>(shown[0].r) << 16U | static_cast<std::uint32_t>(shown[0].g) << 8U |
           shown[0].b;
}

std::span<const float> dashesOf(RayKind kind) {
    static constexpr std::array kDots = {0.12F, 0.3F};
    static constexpr std::array kDashes = {0.8F, 0.35F};
    static constexpr std::array kDotDashes = {0.8F, 0.3F, 0.12F, 0.3F};
    switch (kind) {
    case RayKind::Shadow:
        return kDots;
    case RayKind::Refraction:
        return kDashes;
    case RayKind::Diffuse:
        return kDotDashes;
    case RayKind::Eye:
    case RayKind::Reflection:
        return {};
    }
    return {};
}

const Ground& groundOf(bool dark) {
    static constexpr Ground kDark{0x16181d, 0x1d2027, 0xe9ebf0, 0x969db0, 0x343945};
    static constexpr Ground kLight{0xf2f3f6, 0xffffff, 0x15181e, 0x5d6577, 0xc3c9d4};
    return dark ? kDark : kLight;
}

}
