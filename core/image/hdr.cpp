#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/image/codecs.h"

namespace eyeray {
namespace {

constexpr float kLargest = 255 * 0x1p119F; // that RGBE can hold
constexpr std::size_t kShortestRun = 4;    // a shorter run saves nothing over plain bytes
constexpr std::size_t kLongestRun = 127;
constexpr std::size_t kMostPlainBytes = 128;
constexpr int kNarrowestRunLengthRow = 8,
              kWidestRunLengthRow = 32767; // outside, rows are plain by the format's rule

/// Three mantissas and the exponent they share: channel = mantissa · 2^(exponent − 136), the nearest there
/// is.
std::array<std::uint8_t, 4> toRgbe(const Color& color) {
    const auto storable = [](float value) { return value > 0 ? std::min(value, kLargest) : 0.0F; };
    const Vec3 c(storable(color.x), storable(color.y), storable(color.z));
    int exponent = 0;
    std::frexp(maxComponent(c), &exponent);
    double scale = std::ldexp(256.0, -exponent);
    if (std::lround(maxComponent(c) * scale) == 256) { // rounded up to the next power of two
        ++exponent;
        scale /= 2;
    }
    if (maxComponent(c) == 0 || exponent < -127) return {0, 0, 0, 0};
    const auto mantissa = [scale](float value) {
        return static_cast<std::uint8_t>(std::lround(value * scale));
    };
    return {mantissa(c.x), mantissa(c.y), mantissa(c.z), static_cast<std::uint8_t>(exponent + 128)};
}

std::size_t runLengthAt(std::span<const std::uint8_t> values, std::size_t start) {
    std::size_t end = start + 1;
    while (end < values.size() && end - start < kLongestRun && values[end] == values[start]) ++end;
    return end - start;
}

void appendPlain(std::vector<std::byte>& bytes, std::span<const std::uint8_t> values) {
    while (!values.empty()) {
        const auto piece = values.first(std::min(values.size(), kMostPlainBytes));
        bytes.push_back(static_cast<std::byte>(piece.size()));
        for (const std::uint8_t value : piece) bytes.push_back(std::byte{value});
        values = values.subspan(piece.size());
    }
}

/// One component of a row: plain pieces (count, bytes) and runs (128 + count, byte) in turn.
void appendRuns(std::vector<std::byte>& bytes, std::span<const std::uint8_t> values) {
    std::size_t done = 0, at = 0;
    while (at < values.size()) {
        const std::size_t length = runLengthAt(values, at);
        if (length >= kShortestRun) {
            appendPlain(bytes, values.subspan(done, at - done));
            bytes.push_back(static_cast<std::byte>(128 + length));
            bytes.push_back(std::byte{values[at]});
            done = at + length;
        }
        at += length;
    }
    appendPlain(bytes, values.subspan(done));
}

}

std::vector<std::byte> encodeHdr(const ColorImage& image) {
    const std::string header =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height(), image.width());
    const auto text = std::as_bytes(std::span(header));
    std::vector<std::byte> bytes(text.begin(), text.end());
    const bool withRuns = image.width() >= kNarrowestRunLengthRow && image.width() <= kWidestRunLengthRow;

    std::array<std::vector<std::uint8_t>, 4> components;
    for (int y = 0; y < image.height(); ++y) {
        for (auto& component : components) component.clear();
        for (int x = 0; x < image.width(); ++x) {
            const std::array<std::uint8_t, 4> rgbe = toRgbe(image.at(x, y));
            for (std::size_t i = 0; i < 4; ++i) components[i].push_back(rgbe[i]);
            if (!withRuns)
                for (const std::uint8_t value : rgbe) bytes.push_back(std::byte{value});
        }
        if (!withRuns) continue;
        for (const int start : {2, 2, image.width() >> 8, image.width() & 0xFF})
            bytes.push_back(static_cast<std::byte>(start));
        for (const auto& component : components) appendRuns(bytes, component);
    }
    return bytes;
}

}
