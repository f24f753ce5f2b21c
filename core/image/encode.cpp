#include "core/image/encode.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/errors.h"
#include "core/image/codecs.h"

namespace eyeray {

ImageFormat formatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().native();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".png") return ImageFormat::Png;
    if (ending == ".exr") return ImageFormat::Exr;
    if (ending == ".hdr") return ImageFormat::Hdr;
    if (ending == ".pfm") return ImageFormat::Pfm;
    if (ending == ".ppm") return ImageFormat::Ppm;
    throw InputError{path.native(), "its ending names no picture format",
                     "end it in .png, .exr, .hdr, .pfm or .ppm"};
}

bool holdsRadiance(ImageFormat format) { return format != ImageFormat::Png && format != ImageFormat::Ppm; }

std::vector<std::byte> encodeDisplayed(const ByteImage& image, ImageFormat format, const Metadata& metadata) {
    ENSURE(!image.empty() && !holdsRadiance(format));
    return format == ImageFormat::Png ? encodePng(image, metadata) : encodePpm(image);
}

std::vector<std::byte> encodeRadiance(const ColorImage& image, ImageFormat format, const Metadata& metadata) {
    ENSURE(!image.empty() && holdsRadiance(format));
    switch (format) {
    case ImageFormat::Hdr:
        return encodeHdr(image);
    case ImageFormat::Pfm:
        return encodePfm(image);
    default:
        return encodeChannels(std::array{ImageChannel{"R", &image, 0}, ImageChannel{"G", &image, 1},
                                         ImageChannel{"B", &image, 2}},
                              metadata);
    }
}

}
