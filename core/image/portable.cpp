#include <bit>

#include <fmt/format.h>

#include "core/image/codecs.h"

namespace eyeray {
namespace {

std::vector<std::byte> startWith(const std::string& header, std::size_t pixelBytes) {
    const auto text = std::as_bytes(std::span(header));
    std::vector<std::byte> bytes(text.begin(), text.end());
    bytes.reserve(bytes.size() + pixelBytes);
    return bytes;
}

}

std::vector<std::byte> encodePfm(const ColorImage& image) {
    static_assert(std::endian::native == std::endian::little); // what the scale of -1 promises
    const auto width = static_cast<std::size_t>(image.width());
    const std::span<const Color> pixels(image.values());
    std::vector<std::byte> bytes =
        startWith(fmt::format("PF\n{} {}\n-1.0\n", image.width(), image.height()), pixels.size_bytes());
    for (std::size_t row = pixels.size(); row > 0; row -= width) {
        const auto floats = std::as_bytes(pixels.subspan(row - width, width));
        bytes.insert(bytes.end(), floats.begin(), floats.end());
    }
    return bytes;
}

std::vector<std::byte> encodePpm(const ByteImage& image) {
    std::vector<std::byte> bytes =
        startWith(fmt::format("P6\n{} {}\n255\n", image.width(), image.height()), 3 * image.values().size());
    for (const Rgba8 pixel : image.values())
        for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b}) bytes.push_back(std::byte{channel});
    return bytes;
}

}
