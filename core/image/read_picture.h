#pragma once
// Pictures to be compared, of every format that Eyeray writes, and JPEG.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/image/pixels.h"

namespace eyeray {

struct ReadPicture {
    ColorImage linear;                  // light: of a displayed picture, its bytes decoded by the sRGB curve
    std::optional<ByteImage> displayed; // of PNG, JPEG and PPM
};

/// EXR (channels R, G, B of any type), PFM, Radiance HDR, PPM, PNG or JPEG, told apart by their first bytes.
/// `where` names the picture in errors. Throws InputError for anything else, for a picture over the limits of
/// decode.h (before memory is taken for it), and for data that is damaged or cut short.
ReadPicture readPicture(std::span<const std::byte> bytes, const std::string& where);

}
