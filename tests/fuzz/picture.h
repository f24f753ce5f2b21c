#pragma once
// Any bytes as a picture, and as the text in one.

#include <span>

#include "core/image/decode.h"
#include "tests/fuzz/accepted.h"

namespace eyeray::fuzz {

/// The picture is refused with an InputError, or is within the limits.
inline void picture(std::span<const std::byte> bytes) {
    accepted([&] {
        const ByteImage pixels = decodeImage(bytes, "fuzzed").pixels;
        ENSURE(pixels.width() > 0 && pixels.width() <= kMaxPictureSide);
        ENSURE(pixels.height() > 0 && pixels.height() <= kMaxPictureSide);
    });
    accepted([&] { readPngText(bytes, "fuzzed"); });
}

}
