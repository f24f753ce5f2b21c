#pragma once
// Any bytes as a picture, and as the text in one.

#include <span>

#include "core/base/errors.h"
#include "core/image/decode.h"

namespace eyeray::fuzz {

/// The picture is refused with an InputError, or is within the limits.
inline void picture(std::span<const std::byte> bytes) {
    try {
        const ByteImage pixels = decodeImage(bytes, "fuzzed").pixels;
        ENSURE(pixels.width() > 0 && pixels.width() <= kMaxPictureSide);
        ENSURE(pixels.height() > 0 && pixels.height() <= kMaxPictureSide);
    } catch (const InputError&) {
    }
    try {
        readPngText(bytes, "fuzzed");
    } catch (const InputError&) {
    }
}

}
