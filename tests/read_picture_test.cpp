// labels: unit robustness
// Pictures to be compared: what was written is read back, and damaged files are refused in one line.

#include "core/image/read_picture.h"

#include <span>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/encode.h"
#include "core/image/srgb.h"

namespace eyeray {
namespace {

ColorImage radiance(int width = 21, int height = 9) {
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) =
                Color(static_cast<float>(x) * 0.37F, static_cast<float>(y) / 7, x == y ? 1000.0F : 0.01F);
    return image;
}

ByteImage displayed() {
    ByteImage image(21, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 21; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x * 12), static_cast<std::uint8_t>(y * 28), 77};
    return image;
}

std::vector<std::byte> bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

TEST(ReadPicture, ReadsRadianceBackAsItWasWritten) {
    for (const ImageFormat format : {ImageFormat::Exr, ImageFormat::Pfm}) {
        const ReadPicture read = readPicture(encodeRadiance(radiance(), format, {}), "picture");
        EXPECT_EQ(read.linear, radiance());
        EXPECT_FALSE(read.displayed);
    }
    for (const int width : {5, 21, 300}) { // without and with run lengths
        const ColorImage image = radiance(width, 9);
        const ReadPicture read = readPicture(encodeRadiance(image, ImageFormat::Hdr, {}), "picture.hdr");
        ASSERT_EQ(read.linear.width(), width);
        for (std::size_t i = 0; i < image.values().size(); ++i) {
            const Color &a = image.values()[i], &b = read.linear.values()[i];
            ASSERT_LE(maxComponent(glm::abs(a - b)), maxComponent(a) / 128);
        }
    }
}

TEST(ReadPicture, ReadsDisplayedPicturesAsBytesAndAsLight) {
    for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Ppm}) {
        const ReadPicture read = readPicture(encodeDisplayed(displayed(), format, {}), "picture");
        ASSERT_TRUE(read.displayed);
        EXPECT_EQ(*read.displayed, displayed());
        EXPECT_EQ(read.linear.at(3, 2), Color(decodeSrgb8(36), decodeSrgb8(56), decodeSrgb8(77)));
    }
}

TEST(ReadPicture, RefusesEveryFileThatIsCutShort) {
    for (const ImageFormat format :
         {ImageFormat::Exr, ImageFormat::Pfm, ImageFormat::Hdr, ImageFormat::Png, ImageFormat::Ppm}) {
        const std::vector<std::byte> whole = holdsRadiance(format) ? encodeRadiance(radiance(), format, {})
                                                                   : encodeDisplayed(displayed(), format, {});
        for (std::size_t size = 0; size < whole.size(); size += 1 + size / 16) {
            try {
                readPicture(std::span(whole).first(size), "cut.file");
                // OpenEXR and libpng may do without their last bytes, but never without half.
                EXPECT_GT(size, whole.size() / 2);
            } catch (const InputError& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            }
        }
    }
}

TEST(ReadPicture, RefusesHeadersThatLie) {
    for (const char* const text :
         {"P6\n99999 99999\n255\n", "P6\n-1 4\n255\n", "P6\n2 2\n65535\nxxxx", "PF\n0 0\n-1.0\n",
          "PF\nwide high\n-1\n", "#?RADIANCE\n\n-Y 4 +X 999999999\n", "#?RADIANCE\n\n+Y 4 +X 4\nxxxx",
          "GIF89a", "", "#?RADIANCE\n\n-Y 1 +X 8\n\x02\x02\x00\x08\xff\x01"})
        EXPECT_THROW(readPicture(bytesOf(text), "bad"), InputError) << text;
}

TEST(ReadPicture, SurvivesFlippedBytes) {
    for (const ImageFormat format : {ImageFormat::Exr, ImageFormat::Pfm, ImageFormat::Hdr}) {
        const std::vector<std::byte> whole = encodeRadiance(radiance(), format, {});
        for (std::size_t i = 0; i < whole.size(); i += 3) {
            std::vector<std::byte> bent = whole;
            bent[i] ^= std::byte{0x81};
            try {
                readPicture(bent, "bent.file");
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()), "");
            }
        }
    }
}

}
}
