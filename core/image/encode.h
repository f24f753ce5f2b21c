#pragma once
// Pictures as the bytes of a file; writeFileAtomically puts them on disk.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/image/pixels.h"

namespace eyeray {

/// What a picture says of itself, in order: a key, and text in UTF-8 up to its first zero byte.
/// Keys are ours: 1 to 79 printable ASCII characters, each key once.
using Metadata = std::vector<std::pair<std::string, std::string>>;

enum class ImageFormat : std::uint8_t { Png, Exr, Hdr, Pfm, Ppm };

/// The format that the ending of a name asks for, in any case of letters. Throws InputError naming the five
/// endings.
ImageFormat formatOf(const std::filesystem::path& path);

/// True for the formats of linear radiance (EXR, HDR, PFM), false for those of what the screen shows (PNG,
/// PPM).
bool holdsRadiance(ImageFormat format);

/// A PNG, RGB where every pixel is opaque, else RGBA, marked as sRGB, with metadata as iTXt; or a binary PPM,
/// which keeps neither alpha nor metadata.
std::vector<std::byte> encodeDisplayed(const ByteImage& image, ImageFormat format, const Metadata& metadata);

/// An EXR (32-bit floats, bit for bit, metadata as string attributes), a PFM (the same floats, no metadata)
/// or a Radiance HDR (RGBE: the channels to 1/256 of the largest; NaN and negative values become 0; no
/// metadata).
std::vector<std::byte> encodeRadiance(const ColorImage& image, ImageFormat format, const Metadata& metadata);

/// One channel of an EXR: its name, as in "R" or "normal.X", and the component of an image that it holds.
struct ImageChannel {
    std::string name;
    const ColorImage* image;
    int component;
};

/// An EXR of any channels, at least one, of images of one size; names differ and are 1 to 255 bytes. 32-bit
/// floats, bit for bit; metadata as string attributes.
std::vector<std::byte> encodeChannels(std::span<const ImageChannel>, const Metadata& metadata);

}
