#pragma once
// One function per file format, for encode.cpp and decode.cpp. Images to encode are not empty.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/image/decode.h"
#include "core/image/encode.h"
#include "core/image/pixels.h"

namespace eyeray {

/// Throws InputError when the limits in decode.h are passed.
void checkPictureSize(long long width, long long height, const std::string& where);

/// What decodeImage promises, for one format each. ITU-T T.81 (1992) through libjpeg-turbo.
DecodedImage decodePng(std::span<const std::byte> bytes, const std::string& where);
DecodedImage decodeJpeg(std::span<const std::byte> bytes, const std::string& where);

/// R, G and B of an EXR, through OpenEXR; what it throws becomes InputError.
ColorImage decodeExr(std::span<const std::byte> bytes, const std::string& where);

/// W3C, "Portable Network Graphics (PNG) Specification (Second Edition)", 2003; through libpng.
std::vector<std::byte> encodePng(const ByteImage& image, const Metadata& metadata);

/// Ward, "Real Pixels", Graphics Gems II, 1991; run lengths as in the file format of Radiance.
std::vector<std::byte> encodeHdr(const ColorImage& image);

/// Portable float map: little-endian, bottom row first. Debevec, "PFM format", 1998.
std::vector<std::byte> encodePfm(const ColorImage& image);

/// Binary portable pixmap (P6); alpha is dropped.
std::vector<std::byte> encodePpm(const ByteImage& image);

}
