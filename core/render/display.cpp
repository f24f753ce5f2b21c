#include "core/render/display.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "core/image/srgb.h"

namespace eyeray {
namespace {

float aces(float x) {
    return std::clamp(x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F), 0.0F, 1.0F);
}

Color toneMapped(const Color& c, ToneMap map) {
    switch (map) {
    case ToneMap::Reinhard:
        return c / (1 + luminance(c));
    case ToneMap::Aces:
        return {aces(c.r), aces(c.g), aces(c.b)};
    case ToneMap::None:
    case ToneMap::Clamp:
        break;
    }
    return c;
}

std::uint8_t linearByte(float value) {
    return value > 0 ? static_cast<std::uint8_t>(std::lround(std::min(value, 1.0F) * 255.0F))
                     : std::uint8_t{0};
}

float displayedValue(float luminance, const DisplaySettings& settings) {
    const float exposed = luminance * static_cast<float>(std::exp2(settings.exposure));
    const float mapped = std::clamp(toneMapped(Color(exposed), settings.toneMap).r, 0.0F, 1.0F);
    return settings.toneMap == ToneMap::None ? mapped : encodeSrgb(mapped);
}

}

void display(std::span<const Color> radiance, const DisplaySettings& settings, std::span<Rgba8> shown) {
    ENSURE(radiance.size() == shown.size());
    const auto scale = static_cast<float>(std::exp2(settings.exposure));
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const Color c = toneMapped(radiance[i] * scale, settings.toneMap);
        shown[i] = settings.toneMap == ToneMap::None
                       ? Rgba8{linearByte(c.r), linearByte(c.g), linearByte(c.b)}
                       : Rgba8{encodeSrgb8(c.r), encodeSrgb8(c.g), encodeSrgb8(c.b)};
    }
}

ByteImage display(const ColorImage& radiance, const DisplaySettings& settings) {
    constexpr std::size_t kWorthAThread = 1U << 18U; // pixels: a millisecond
    ByteImage shown(radiance.width(), radiance.height());
    const std::span<const Color> from = radiance.values();
    const std::span<Rgba8> to = shown.values();
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t parts = std::clamp<std::size_t>(from.size() / kWorthAThread, 1, cores);
    const auto displayPart = [&](std::size_t part) {
        const std::size_t begin = from.size() * part / parts, end = from.size() * (part + 1) / parts;
        display(from.subspan(begin, end - begin), settings, to.subspan(begin, end - begin));
    };
    std::vector<std::jthread> others;
    for (std::size_t part = 1; part < parts; ++part) others.emplace_back(displayPart, part);
    displayPart(0);
    return shown;
}

float displaySlope(float luminance, const DisplaySettings& settings) {
    const float step = std::max(1e-3F, 0.01F * luminance);
    return (displayedValue(luminance + step, settings) - displayedValue(luminance, settings)) / step;
}

double meteredExposure(const ColorImage& radiance) {
    constexpr double kMiddleGrey = 0.18, kSmallest = 1e-4;
    double sum = 0;
    int lit = 0;
    for (const Color& c : radiance.values()) {
        const double y = luminance(c);
        if (!(y > 0)) continue;
        sum += std::log2(y + kSmallest);
        ++lit;
    }
    return lit > 0 ? std::log2(kMiddleGrey) - sum / lit : 0;
}

}
