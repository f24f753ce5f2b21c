#pragma once
// Pictures from bytes that nobody vouches for. Color spaces and gamma that a file states are left out of
// account, as glTF 2.0 asks (section 3.8.3): the numbers are the file's own.

#include <cstddef>
#include <map>
#include <span>
#include <string>

#include "core/image/pixels.h"

namespace eyeray {

inline constexpr long long kMaxPicturePixels = 64'000'000; // 256 MB as bytes

struct DecodedImage {
    ByteImage pixels;
    bool hasAlpha; // the file has an alpha channel or transparent colors; else all alpha is 255
};

/// A PNG of any kind (16-bit channels are rounded to 8) or a gray or color JPEG, told apart by their first
/// bytes. `where` names the picture in errors. Throws InputError for anything else, for a picture over the
/// limits (before any memory is taken for it), and for data that is damaged or cut short.
DecodedImage decodeImage(std::span<const std::byte> bytes, const std::string& where);

/// The texts of a PNG that stand before its pixels, key to text, in UTF-8 if the writer kept to the rules; of
/// several under one key the first. At most 100 are taken in, and none that unpacks to more than 1 MB. Throws
/// InputError where the bytes are no PNG or damaged up to there.
std::map<std::string, std::string> readPngText(std::span<const std::byte> bytes, const std::string& where);

}
