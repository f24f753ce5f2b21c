// Pictures are read right in all their kinds, and bad ones end in one clear error.
// labels: unit robustness

#include "core/image/decode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/encode.h"
#include "tests/write_pictures.h"

namespace eyeray {
namespace {

using Rows = std::vector<std::vector<unsigned char>>;
using Bytes = std::vector<std::byte>;

std::string errorOf(std::span<const std::byte> bytes) {
    try {
        decodeImage(bytes, "picture");
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
}

/// True if read, false if refused; anything else fails the test or, under the sanitizers, the program.
bool isRead(std::span<const std::byte> bytes) {
    try {
        decodeImage(bytes, "picture");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

ByteImage gradient(int width, int height, bool opaque) {
    ByteImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x * 9), static_cast<std::uint8_t>(y * 7),
                              static_cast<std::uint8_t>(x ^ y),
                              static_cast<std::uint8_t>(opaque ? 255 : x * y)};
    return image;
}

/// RGB samples of a smooth picture, which JPEG at best quality keeps to a few levels.
std::vector<unsigned char> smoothSamples(int width, int height, int components) {
    std::vector<unsigned char> samples;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < components; ++c)
                samples.push_back(static_cast<unsigned char>(40 + 3 * x + 2 * y + 20 * c));
    return samples;
}

void expectSmooth(const DecodedImage& image, int width, int height, int components) {
    ASSERT_EQ(image.pixels.width(), width);
    ASSERT_EQ(image.pixels.height(), height);
    EXPECT_FALSE(image.hasAlpha);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgba8 pixel = image.pixels.at(x, y);
            const int expected = 40 + 3 * x + 2 * y, step = components == 3 ? 20 : 0;
            EXPECT_NEAR(pixel.r, expected, 3);
            EXPECT_NEAR(pixel.g, expected + step, 3);
            EXPECT_NEAR(pixel.b, expected + 2 * step, 3);
            EXPECT_EQ(pixel.a, 255);
        }
}

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(value >> shift);
    return bytes;
}

/// A chunk with its length and checksum, as PNG has it.
Bytes chunk(const std::string& type, const std::string& data) {
    std::uint32_t crc = ~0U; // the bitwise form of PNG, annex D
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    const std::string text =
        bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(~crc);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

constexpr std::size_t kAfterHeader = 8 + 25; // signature and IHDR

void insertAfterHeader(Bytes& png, const Bytes& added) {
    png.insert(png.begin() + kAfterHeader, added.begin(), added.end());
}

/// The smallest PNG with another size in its header.
Bytes pngClaiming(std::uint32_t width, std::uint32_t height) {
    Bytes png = encodeDisplayed(ByteImage(1, 1), ImageFormat::Png, {});
    const Bytes header =
        chunk("IHDR", bigEndian(width) + bigEndian(height) + std::string("\x08\x02\x00\x00\x00", 5));
    std::copy(header.begin(), header.end(), png.begin() + 8);
    return png;
}

TEST(DecodePng, GivesBackWhatWasEncoded) {
    for (const bool opaque : {true, false}) {
        const DecodedImage read =
            decodeImage(encodeDisplayed(gradient(37, 23, opaque), ImageFormat::Png, {{"k", "v"}}), "p");
        EXPECT_EQ(read.pixels, gradient(37, 23, opaque));
        EXPECT_EQ(read.hasAlpha, !opaque);
    }
}

TEST(DecodePng, GraysOfFewBitsAreStretchedToFullRange) {
    for (const int bits : {1, 2, 4}) {
        const int most = (1 << bits) - 1;
        std::vector<unsigned char> row(static_cast<std::size_t>(bits)); // 8 pixels
        for (int x = 0; x < 8; ++x)
            row[static_cast<std::size_t>(x * bits / 8)] |=
                static_cast<unsigned char>((x & most) << (8 - bits - x * bits % 8));
        const DecodedImage read = decodeImage(makePng({8, 1, bits, PNG_COLOR_TYPE_GRAY}, {row}), "p");
        for (int x = 0; x < 8; ++x) {
            const auto gray = static_cast<std::uint8_t>((x & most) * 255 / most);
            EXPECT_EQ(read.pixels.at(x, 0), (Rgba8{gray, gray, gray, 255})) << bits;
        }
        EXPECT_FALSE(read.hasAlpha);
    }
}

TEST(DecodePng, SixteenBitsAreRoundedToEight) {
    std::vector<unsigned char> row;
    std::vector<std::uint8_t> expected;
    for (unsigned value = 0; value < 65536; value += 13) {
        row.insert(row.end(), {static_cast<unsigned char>(value >> 8U), static_cast<unsigned char>(value)});
        expected.push_back(static_cast<std::uint8_t>(std::lround(value / 257.0)));
    }
    const int width = static_cast<int>(expected.size());
    const DecodedImage read = decodeImage(makePng({width, 1, 16, PNG_COLOR_TYPE_GRAY}, {row}), "p");
    for (int x = 0; x < width; ++x)
        ASSERT_EQ(read.pixels.at(x, 0).g, expected[static_cast<std::size_t>(x)]) << x;
}

TEST(DecodePng, AGrayWithAlphaOf16BitsKeepsBoth) {
    const DecodedImage read =
        decodeImage(makePng({1, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA}, {{0x40, 0x40, 0x80, 0x80}}), "p");
    EXPECT_EQ(read.pixels.at(0, 0), (Rgba8{0x40, 0x40, 0x40, 0x80}));
    EXPECT_TRUE(read.hasAlpha);
}

TEST(DecodePng, APaletteMayBeTransparent) {
    const auto colors = [](bool transparent) {
        return [transparent](png_structp png, png_infop info) {
            const png_color palette[] = {{255, 0, 0}, {0, 10, 20}};
            const png_byte alpha[] = {7};
            png_set_PLTE(png, info, palette, 2);
            if (transparent) png_set_tRNS(png, info, alpha, 1, nullptr);
        };
    };
    const PngKind kind{2, 1, 8, PNG_COLOR_TYPE_PALETTE};
    const DecodedImage opaque = decodeImage(makePng(kind, {{0, 1}}, colors(false)), "p");
    EXPECT_EQ(opaque.pixels.at(0, 0), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(opaque.pixels.at(1, 0), (Rgba8{0, 10, 20, 255}));
    EXPECT_FALSE(opaque.hasAlpha);
    const DecodedImage transparent = decodeImage(makePng(kind, {{0, 1}}, colors(true)), "p");
    EXPECT_EQ(transparent.pixels.at(0, 0), (Rgba8{255, 0, 0, 7}));
    EXPECT_EQ(transparent.pixels.at(1, 0), (Rgba8{0, 10, 20, 255}));
    EXPECT_TRUE(transparent.hasAlpha);
}

TEST(DecodePng, OneColorMayBeTransparentAtItsFull16Bits) {
    const auto key = [](png_structp png, png_infop info) {
        png_color_16 color{};
        color.gray = 0x1234;
        png_set_tRNS(png, info, nullptr, 0, &color);
    };
    const DecodedImage read =
        decodeImage(makePng({2, 1, 16, PNG_COLOR_TYPE_GRAY}, {{0x12, 0x34, 0x12, 0x35}}, key), "p");
    EXPECT_EQ(read.pixels.at(0, 0), (Rgba8{0x12, 0x12, 0x12, 0}));
    EXPECT_EQ(read.pixels.at(1, 0), (Rgba8{0x12, 0x12, 0x12, 255}));
    EXPECT_TRUE(read.hasAlpha);
}

TEST(DecodePng, InterlacedIsTheSamePicture) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {37, 23}}) {
        const ByteImage image = gradient(width, height, false);
        Rows rows;
        for (int y = 0; y < height; ++y) {
            const auto* first = reinterpret_cast<const unsigned char*>(&image.at(0, y));
            rows.emplace_back(first, first + std::size_t{4} * static_cast<std::size_t>(width));
        }
        EXPECT_EQ(decodeImage(makePng({width, height, 8, PNG_COLOR_TYPE_RGB_ALPHA, true}, rows), "p").pixels,
                  image);
    }
}

TEST(DecodePng, AGammaInTheFileChangesNoNumber) {
    const auto gamma = [](png_structp png, png_infop info) { png_set_gAMA(png, info, 1.0); };
    const DecodedImage read =
        decodeImage(makePng({1, 1, 8, PNG_COLOR_TYPE_RGB}, {{10, 100, 200}}, gamma), "p");
    EXPECT_EQ(read.pixels.at(0, 0), (Rgba8{10, 100, 200, 255}));
}

TEST(DecodePng, ALargeChunkOfNoConcernIsPassedOver) {
    Bytes png = encodeDisplayed(gradient(5, 4, true), ImageFormat::Png, {});
    insertAfterHeader(png, chunk("eXIf", std::string(8'100'000, 'x')));
    insertAfterHeader(png, chunk("iCCP", "broken"));
    EXPECT_EQ(decodeImage(png, "p").pixels, gradient(5, 4, true));
}

TEST(DecodeJpeg, ColorGrayAndProgressiveOnesAreRead) {
    for (const auto& scans : {std::function<void(j_compress_ptr)>(), {jpeg_simple_progression}}) {
        expectSmooth(decodeImage(makeJpeg(30, 20, 3, JCS_RGB, smoothSamples(30, 20, 3), scans), "p"), 30, 20,
                     3);
        expectSmooth(decodeImage(makeJpeg(30, 20, 1, JCS_GRAYSCALE, smoothSamples(30, 20, 1), scans), "p"),
                     30, 20, 1);
    }
}

TEST(DecodeJpeg, PrintingColorsAreRefusedByName) {
    for (const J_COLOR_SPACE colors : {JCS_CMYK, JCS_YCCK}) {
        const Bytes jpeg = makeJpeg(8, 8, 4, colors, smoothSamples(8, 8, 4));
        EXPECT_EQ(errorOf(jpeg), "picture: is a JPEG in CMYK, the colors of printing: save it as RGB");
    }
}

TEST(DecodeJpeg, ArithmeticCodingIsRefusedByName) {
    const Bytes jpeg = makeJpeg(8, 8, 1, JCS_GRAYSCALE, smoothSamples(8, 8, 1),
                                [](j_compress_ptr encoder) { encoder->arith_code = TRUE; });
    EXPECT_NE(errorOf(jpeg).find("arithmetic coding"), std::string::npos);
}

TEST(DecodeJpeg, StrayBytesBetweenSegmentsDoNoHarm) {
    Bytes jpeg = makeJpeg(30, 20, 3, JCS_RGB, smoothSamples(30, 20, 3));
    jpeg.insert(jpeg.end() - 2, 5, std::byte{0x55});
    expectSmooth(decodeImage(jpeg, "p"), 30, 20, 3);
}

TEST(DecodeJpeg, HundredsOfScansAreRefused) {
    const Bytes jpeg =
        makeJpeg(16, 16, 1, JCS_GRAYSCALE, smoothSamples(16, 16, 1), [](j_compress_ptr encoder) {
            static const jpeg_scan_info scans[] = {{1, {0}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 0}};
            encoder->scan_info = scans;
            encoder->num_scans = 2;
        });
    const std::array scanMarker{std::byte{0xFF}, std::byte{0xDA}};
    const auto lastScan = std::find_end(jpeg.begin(), jpeg.end(), scanMarker.begin(), scanMarker.end());
    const auto repeated = [&](int times) {
        Bytes file(jpeg.begin(), lastScan);
        for (int i = 0; i < times; ++i) file.insert(file.end(), lastScan, jpeg.end() - 2);
        file.insert(file.end(), jpeg.end() - 2, jpeg.end());
        return file;
    };
    expectSmooth(decodeImage(repeated(50), "p"), 16, 16, 1);
    EXPECT_NE(errorOf(repeated(3000)).find("more than 100 scans"), std::string::npos);
}

TEST(DecodeImage, WhatIsNoPictureIsRefused) {
    const std::string text = "GIF89a is none of ours";
    const std::string message = "picture: is neither PNG nor JPEG: convert it to one of them";
    EXPECT_EQ(errorOf({}), message);
    EXPECT_EQ(errorOf(std::as_bytes(std::span(text))), message);
}

TEST(DecodeImage, EveryShorteningOfAFileIsRefused) {
    const Bytes files[] = {
        encodeDisplayed(gradient(9, 7, false), ImageFormat::Png, {{"key", "text"}}),
        makePng({9, 2, 8, PNG_COLOR_TYPE_GRAY, true}, Rows(2, std::vector<unsigned char>(9, 50))),
        makeJpeg(16, 16, 3, JCS_RGB, smoothSamples(16, 16, 3)),
        makeJpeg(16, 16, 3, JCS_RGB, smoothSamples(16, 16, 3), jpeg_simple_progression),
    };
    for (const Bytes& file : files) {
        EXPECT_TRUE(isRead(file));
        for (std::size_t size = 0; size < file.size(); ++size)
            EXPECT_FALSE(isRead(std::span(file).first(size))) << size << " of " << file.size();
    }
}

TEST(DecodeImage, NoDamagedByteDoesHarm) {
    const Bytes files[] = {
        encodeDisplayed(gradient(9, 7, false), ImageFormat::Png, {{"key", "text"}}),
        makeJpeg(16, 16, 3, JCS_RGB, smoothSamples(16, 16, 3)),
        makeJpeg(16, 16, 3, JCS_RGB, smoothSamples(16, 16, 3), jpeg_simple_progression),
    };
    int refused = 0;
    for (const Bytes& file : files)
        for (std::size_t at = 0; at < file.size(); ++at)
            for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
                Bytes damaged = file;
                damaged[at] ^= static_cast<std::byte>(flip);
                refused += isRead(damaged) ? 0 : 1;
            }
    EXPECT_GT(refused, 100);
}

TEST(DecodeImage, ClaimsOverTheLimitsAreRefusedByTheirNumbers) {
    EXPECT_EQ(errorOf(pngClaiming(30000, 30000)),
              "picture: is 30000x30000 pixels: scale it to at most 16384 a side and 64 million in all");
    EXPECT_NE(errorOf(pngClaiming(16385, 1)).find("is 16385x1 pixels"), std::string::npos);
    EXPECT_NE(errorOf(pngClaiming(10000, 10000)).find("64 million"), std::string::npos);
    EXPECT_NE(errorOf(pngClaiming(0x7FFFFFFF, 0x7FFFFFFF)).find("is 2147483647x2147483647 pixels"),
              std::string::npos);
    EXPECT_NE(errorOf(pngClaiming(0, 5)).find("damaged PNG"), std::string::npos);
    EXPECT_NE(errorOf(pngClaiming(8000, 8000)).find("is cut short"), std::string::npos);

    Bytes jpeg = makeJpeg(8, 8, 1, JCS_GRAYSCALE, smoothSamples(8, 8, 1));
    const std::array<std::byte, 2> frame{std::byte{0xFF}, std::byte{0xC0}};
    const auto size = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end()) + 5;
    std::fill(size, size + 4, std::byte{0xFA}); // 64250 both ways
    EXPECT_NE(errorOf(jpeg).find("is 64250x64250 pixels"), std::string::npos);
}

TEST(DecodeImage, TheWidestPictureIsRead) {
    const ByteImage image = gradient(kMaxPictureSide, 1, true);
    EXPECT_EQ(decodeImage(encodeDisplayed(image, ImageFormat::Png, {}), "p").pixels, image);
}

TEST(PngText, ComesBackInUtf8WithLineBreaks) {
    const Metadata metadata{{"eyeray:commands", "set max-depth=5\nset name=\"Übung 影 🙂\"\n"},
                            {"eyeray:scene", ""}};
    const Bytes png = encodeDisplayed(gradient(3, 2, true), ImageFormat::Png, metadata);
    EXPECT_EQ(readPngText(png, "p"), (std::map<std::string, std::string>(metadata.begin(), metadata.end())));
    EXPECT_TRUE(readPngText(encodeDisplayed(gradient(3, 2, true), ImageFormat::Png, {}), "p").empty());
}

TEST(PngText, OldTextChunksAreLatin1AndTheFirstOfAKeyCounts) {
    Bytes png = encodeDisplayed(gradient(3, 2, true), ImageFormat::Png, {{"Author", "second"}});
    insertAfterHeader(png, chunk("tEXt", std::string("Author\0J\xFCrgen", 13)));
    EXPECT_EQ(readPngText(png, "p"), (std::map<std::string, std::string>{{"Author", "Jürgen"}}));
}

void expectTextRefusedAndPictureRead(const Bytes& png, const std::string& reason) {
    EXPECT_EQ(decodeImage(png, "p").pixels.at(0, 0), (Rgba8{9, 9, 9, 255}));
    try {
        readPngText(png, "p");
        ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

TEST(PngText, BombsOfTextAreRefusedAndHarmNoPicture) {
    const Bytes small = encodeDisplayed(ByteImage(1, 1, {9, 9, 9, 255}), ImageFormat::Png, {});
    const auto compressed = [](png_structp png, png_infop info) {
        const std::string blanks(8'000'000, ' ');
        png_text text{};
        text.compression = PNG_ITXT_COMPRESSION_zTXt;
        text.key = const_cast<char*>("bomb");
        text.text = const_cast<char*>(blanks.c_str());
        png_set_text(png, info, &text, 1);
    };
    const Bytes bomb = makePng({1, 1, 8, PNG_COLOR_TYPE_GRAY}, {{9}}, compressed);
    ASSERT_LT(bomb.size(), 100'000U);
    expectTextRefusedAndPictureRead(bomb, "iTXt");

    Bytes many = small, texts;
    for (int i = 0; i < 20'000; ++i) {
        const Bytes one = chunk("tEXt", "key" + std::to_string(i) + '\0' + "v");
        texts.insert(texts.end(), one.begin(), one.end());
    }
    insertAfterHeader(many, texts);
    expectTextRefusedAndPictureRead(many, "no space in chunk cache");

    Bytes large = small;
    insertAfterHeader(large, chunk("tEXt", std::string("key\0", 4) + std::string(2'000'000, 'x')));
    expectTextRefusedAndPictureRead(large, "too large");
}

TEST(PngText, AChunkThatClaimsGigabytesTakesNone) {
    Bytes png = encodeDisplayed(gradient(1, 1, true), ImageFormat::Png, {{"key", "some text"}});
    png[kAfterHeader + 13] = std::byte{0x7A}; // the length of iTXt, after sRGB
    try {
        readPngText(png, "p");
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("too large"), std::string::npos) << error.what();
    }
}

TEST(PngText, ABrokenColorProfileIsNoObstacle) {
    Bytes png = encodeDisplayed(gradient(1, 1, true), ImageFormat::Png, {{"key", "some text"}});
    insertAfterHeader(png, chunk("iCCP", "broken"));
    EXPECT_EQ(readPngText(png, "p").at("key"), "some text");
}

TEST(PngText, IsRefusedWhereThePngIsDamagedOrNone) {
    const Bytes png = encodeDisplayed(gradient(1, 1, true), ImageFormat::Png, {{"key", "some text"}});
    for (std::size_t size = 0; size < kAfterHeader + 30; ++size)
        EXPECT_THROW(readPngText(std::span(png).first(size), "p"), InputError) << size;
    EXPECT_THROW(readPngText(makeJpeg(8, 8, 1, JCS_GRAYSCALE, smoothSamples(8, 8, 1)), "p"), InputError);
}

}
}
