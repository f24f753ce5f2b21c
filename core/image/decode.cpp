#include "core/image/decode.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/codecs.h"

namespace eyeray {
namespace {

constexpr std::array<unsigned char, 8> kPngStart{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<unsigned char, 3> kJpegStart{0xFF, 0xD8, 0xFF};

template <std::size_t N>
bool startsWith(std::span<const std::byte> bytes, const std::array<unsigned char, N>& start) {
    return bytes.size() >= N && std::ranges::equal(bytes.first(N), std::as_bytes(std::span(start)));
}

}

void checkPictureSize(long long width, long long height, const std::string& where) {
    if (width > kMaxPictureSide || height > kMaxPictureSide || width * height > kMaxPicturePixels)
        throw InputError{where, fmt::format("is {}x{} pixels", width, height),
                         fmt::format("scale it to at most {} a side and {} million in all", kMaxPictureSide,
                                     kMaxPicturePixels / 1'000'000)};
}

DecodedImage decodeImage(std::span<const std::byte> bytes, const std::string& where) {
    if (startsWith(bytes, kPngStart)) return decodePng(bytes, where);
    if (startsWith(bytes, kJpegStart)) return decodeJpeg(bytes, where);
    throw InputError{where, "is neither PNG nor JPEG", "convert it to one of them"};
}

}
