// What the encoders write, read back by other means.
// labels: unit

#include "core/image/encode.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <png.h>

#include "core/base/errors.h"
#include "tests/read_pictures.h"

namespace eyeray {
namespace {

ByteImage randomBytes(int width, int height, bool opaque) {
    std::mt19937 numbers(7);
    ByteImage image(width, height);
    for (Rgba8& pixel : image.values()) {
        const auto byte = [&] { return static_cast<std::uint8_t>(numbers()); };
        pixel = {byte(), byte(), byte(), byte()};
        if (opaque) pixel.a = 255;
    }
    return image;
}

/// Finite values of all magnitudes and signs, and flat stretches for the run lengths.
ColorImage randomColors(int width, int height) {
    std::mt19937 numbers(11);
    ColorImage image(width, height);
    const auto value = [&] {
        const auto bits = static_cast<std::uint32_t>(numbers());
        const auto number = std::bit_cast<float>(bits);
        return std::isfinite(number) ? number : 1.0F;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool flat = x > 0 && (x / 50) % 2 == 1;
            image.at(x, y) = flat ? image.at(x - 1, y) : Color(value(), value(), value());
        }
    return image;
}

bool sameBits(const ColorImage& a, const ColorImage& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.values().data(), b.values().data(), a.values().size() * sizeof(Color)) == 0;
}

/// libpng's simplified reader, which is not the one that decodeImage uses.
ByteImage readPng(std::span<const std::byte> bytes, std::uint32_t* format = nullptr) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
        throw std::runtime_error(png.message);
    if (format) *format = png.format;
    png.format = PNG_FORMAT_RGBA;
    ByteImage image(static_cast<int>(png.width), static_cast<int>(png.height));
    if (!png_image_finish_read(&png, nullptr, image.values().data(), 0, nullptr))
        throw std::runtime_error(png.message);
    return image;
}

bool contains(std::span<const std::byte> bytes, std::string_view text) {
    const auto sought = std::as_bytes(std::span(text));
    return std::search(bytes.begin(), bytes.end(), sought.begin(), sought.end()) != bytes.end();
}

TEST(ImageFormat, IsToldByTheEndingInAnyCase) {
    EXPECT_EQ(formatOf("a/b.png"), ImageFormat::Png);
    EXPECT_EQ(formatOf("B.ExR"), ImageFormat::Exr);
    EXPECT_EQ(formatOf("x.y.HDR"), ImageFormat::Hdr);
    EXPECT_EQ(formatOf("ж.pfm"), ImageFormat::Pfm);
    EXPECT_EQ(formatOf(".a.ppm"), ImageFormat::Ppm);
}

TEST(ImageFormat, AnotherEndingIsRefusedNamingTheFive) {
    for (const char* name : {"picture.jpg", "picture", "", ".png", "png", "a.png/", "a.png "})
        EXPECT_THROW(formatOf(name), InputError) << name;
    try {
        formatOf("picture.jpg");
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "picture.jpg: its ending names no picture format: "
                                   "end it in .png, .exr, .hdr, .pfm or .ppm");
    }
}

TEST(ImageFormat, RadianceIsHeldByTheFormatsOfFloats) {
    EXPECT_TRUE(holdsRadiance(ImageFormat::Exr) && holdsRadiance(ImageFormat::Hdr) &&
                holdsRadiance(ImageFormat::Pfm));
    EXPECT_FALSE(holdsRadiance(ImageFormat::Png) || holdsRadiance(ImageFormat::Ppm));
}

TEST(EncodePng, KeepsEveryByteAndLeavesAlphaOutWhereAllIsOpaque) {
    for (const bool opaque : {true, false})
        for (const auto& [width, height] : {StatedSize{1, 1}, StatedSize{37, 23}, StatedSize{16384, 1}}) {
            const ByteImage image = randomBytes(width, height, opaque);
            std::uint32_t format = 0;
            EXPECT_EQ(readPng(encodeDisplayed(image, ImageFormat::Png, {}), &format), image);
            EXPECT_EQ((format & PNG_FORMAT_FLAG_ALPHA) == 0, opaque);
        }
}

TEST(EncodePng, SaysThatItIsSrgb) {
    EXPECT_TRUE(contains(encodeDisplayed(randomBytes(2, 2, true), ImageFormat::Png, {}), "sRGB"));
}

TEST(EncodePng, TheSamePictureGivesTheSameBytes) {
    const ByteImage image = randomBytes(40, 30, false);
    EXPECT_EQ(encodeDisplayed(image, ImageFormat::Png, {{"k", "v"}}),
              encodeDisplayed(image, ImageFormat::Png, {{"k", "v"}}));
}

TEST(EncodePpm, KeepsColoursAndDropsAlpha) {
    ByteImage image = randomBytes(37, 23, false);
    const std::vector<std::byte> bytes = encodeDisplayed(image, ImageFormat::Ppm, {{"k", "v"}});
    for (Rgba8& pixel : image.values()) pixel.a = 255;
    EXPECT_EQ(readPpm(bytes), image);
}

TEST(EncodePfm, KeepsEveryBit) {
    const ColorImage image = randomColors(37, 23);
    EXPECT_TRUE(sameBits(readPfm(encodeRadiance(image, ImageFormat::Pfm, {})), image));
}

TEST(EncodeExr, KeepsEveryBitAtAnySize) {
    for (const auto& [width, height] :
         {StatedSize{1, 1}, StatedSize{37, 23}, StatedSize{16384, 1}, StatedSize{1, 16384}}) {
        const ColorImage image = randomColors(width, height);
        EXPECT_TRUE(sameBits(readExr(encodeRadiance(image, ImageFormat::Exr, {})).image, image));
    }
}

TEST(EncodeExr, KeepsNanAndInfinity) {
    ColorImage image(2, 1);
    image.at(0, 0) = Color(std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity);
    image.at(1, 0) =
        Color(-0.0F, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max());
    EXPECT_TRUE(sameBits(readExr(encodeRadiance(image, ImageFormat::Exr, {})).image, image));
}

TEST(EncodeExr, CarriesMetadataAsStrings) {
    const Metadata metadata{{"eyeray:commands", "set max-depth=5\nset name=\"Übung 影\""},
                            {"eyeray:scene", ""}};
    EXPECT_EQ(readExr(encodeRadiance(ColorImage(3, 2), ImageFormat::Exr, metadata)).strings, metadata);
}

TEST(EncodeHdr, KeepsRepresentableColoursExactlyInRunsAndPlainRows) {
    // 7 and 40000 columns are outside the widths that may have runs.
    for (const int width : {1, 7, 8, 300, 32767, 32768, 40000}) {
        ColorImage image(width, 3);
        std::mt19937 numbers(3);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < width; ++x) {
                const bool flat = x > 0 && (x / 150) % 2 == 1;
                const auto mantissa = [&] { return static_cast<float>(numbers() % 256); };
                const Color color = std::ldexp(1.0F, static_cast<int>(numbers() % 40) - 20) *
                                    Color(mantissa(), 255, mantissa());
                image.at(x, y) = flat ? image.at(x - 1, y) : color;
            }
        EXPECT_EQ(readHdr(encodeRadiance(image, ImageFormat::Hdr, {})), image) << width;
    }
}

TEST(EncodeHdr, IsOffByAtMostA256thOfTheLargestChannel) {
    ColorImage image(500, 20);
    std::mt19937 numbers(5);
    std::uniform_real_distribution<float> exponents(-60, 60);
    for (Color& color : image.values())
        color = Color(std::exp2(exponents(numbers)), std::exp2(exponents(numbers)),
                      std::exp2(exponents(numbers)));
    for (int i = 0; i < 500; ++i)
        image.at(i, 0) = Color(1 - static_cast<float>(i) * 1e-5F); // around the carry to 1
    const ColorImage read = readHdr(encodeRadiance(image, ImageFormat::Hdr, {}));
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        const Color difference = glm::abs(read.values()[i] - image.values()[i]);
        EXPECT_LE(maxComponent(difference), maxComponent(image.values()[i]) / 256);
    }
}

TEST(EncodeHdr, TakesWhatItCannotHoldAsTheNearestItCan) {
    ColorImage image(5, 1);
    const float largest = 255 * 0x1p119F;
    image.at(0, 0) = Color(std::numeric_limits<float>::quiet_NaN(), -1, 1);
    image.at(1, 0) = Color(kInfinity, std::numeric_limits<float>::max(), 0);
    image.at(2, 0) = Color(std::numeric_limits<float>::denorm_min());
    image.at(3, 0) = Color(0x1p-127F, 0, 0);
    const ColorImage read = readHdr(encodeRadiance(image, ImageFormat::Hdr, {}));
    EXPECT_EQ(read.at(0, 0), Color(0, 0, 1));
    EXPECT_EQ(read.at(1, 0), Color(largest, largest, 0));
    EXPECT_EQ(read.at(2, 0), Color(0));
    EXPECT_EQ(read.at(3, 0), Color(0x1p-127F, 0, 0));
    EXPECT_EQ(read.at(4, 0), Color(0));
}

TEST(EncodeHdr, RunsMakeFlatPicturesSmall) {
    EXPECT_LT(encodeRadiance(ColorImage(1000, 100, Color(0.5F)), ImageFormat::Hdr, {}).size(),
              100U * 1000U * 4U / 40U);
}

TEST(Encode, AFormatOfTheOtherKindOrAnEmptyPictureIsOurMistake) {
    EXPECT_THROW(encodeDisplayed(ByteImage(1, 1), ImageFormat::Exr, {}), InternalError);
    EXPECT_THROW(encodeRadiance(ColorImage(1, 1), ImageFormat::Png, {}), InternalError);
    EXPECT_THROW(encodeDisplayed({}, ImageFormat::Png, {}), InternalError);
    EXPECT_THROW(encodeRadiance({}, ImageFormat::Exr, {}), InternalError);
}

}
}
