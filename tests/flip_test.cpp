// labels: unit
// ꟻLIP against values done by hand, and against its filters written as plain sums in two dimensions.

#include "core/image/flip.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/srgb.h"

namespace eyeray {
namespace {

constexpr Rgba8 kBlack{0, 0, 0}, kWhite{255, 255, 255}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

double ofFlats(const Rgba8& a, const Rgba8& b) {
    return meanFlip(flip(ByteImage(8, 6, a), ByteImage(8, 6, b)));
}

TEST(Flip, EqualPicturesDoNotDiffer) {
    ByteImage picture(40, 30);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            picture.at(x, y) = {static_cast<std::uint8_t>(x * 6), static_cast<std::uint8_t>(y * 8), 90};
    EXPECT_EQ(meanFlip(flip(picture, picture)), 0);
    EXPECT_EQ(meanFlip(flip({}, {})), 0);
}

TEST(Flip, OfFlatColoursIsTheirDistanceAlone) {
    // Green and blue are as far apart as can be. White and black: ΔL = 100, 100^0.7 = 25.12 of at most 41.28,
    // so 0.95 + (25.12 − 0.4 · 41.28) / (0.6 · 41.28) · 0.05.
    EXPECT_NEAR(ofFlats(kGreen, kBlue), 1, 1e-5);
    EXPECT_NEAR(ofFlats(kBlack, kWhite), 0.9674, 2e-4);
    EXPECT_DOUBLE_EQ(ofFlats(kBlack, kWhite), ofFlats(kWhite, kBlack));
    EXPECT_LT(ofFlats({100, 100, 100}, {102, 100, 100}), 0.1);
    EXPECT_GT(ofFlats({100, 100, 100}, {102, 100, 100}), 0.005);
}

/// Luminance of a grey picture as the metric takes it for features: that of the display.
double luminance(const ByteImage& picture, int x, int y) {
    return decodeSrgb8(
        picture.at(std::clamp(x, 0, picture.width() - 1), std::clamp(y, 0, picture.height() - 1)).g);
}

TEST(Flip, FindsEdgesAndPointsAsPlainSumsDo) {
    // Greys, so that one Gaussian, that of luminance, filters all of colour.
    const ByteImage a(48, 40, {60, 60, 60});
    ByteImage b = a;
    for (int y = 0; y < 40; ++y)
        for (int x = 25; x < 48; ++x) b.at(x, y) = {90, 90, 90};
    b.at(10, 12) = {255, 255, 255};
    const Pixels<float> result = flip(a, b);

    const double ppd = kPixelsPerDegree, deviation = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const int wide = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPiD * kPiD)) * ppd));
    for (const auto& pixel : {std::pair{10, 12}, {11, 13}, {25, 30}, {24, 5}, {40, 20}}) {
        const int px = pixel.first, py = pixel.second;
        const auto feature = [&](const ByteImage& picture, auto weight) {
            DVec2 sum(0), positive(0), negative(0);
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i) {
                    const double bell = std::exp(-(i * i + j * j) / (2 * deviation * deviation));
                    const DVec2 w = bell * DVec2(weight(i), weight(j));
                    positive += glm::max(w, DVec2(0));
                    negative -= glm::min(w, DVec2(0));
                }
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i) {
                    const double bell = std::exp(-(i * i + j * j) / (2 * deviation * deviation));
                    const DVec2 w = bell * DVec2(weight(i), weight(j));
                    for (int k = 0; k < 2; ++k)
                        sum[k] += w[k] / (w[k] > 0 ? positive[k] : negative[k]) *
                                  luminance(picture, px + i, py + j);
                }
            return glm::length(sum);
        };
        const auto edge = [](int i) { return -static_cast<double>(i); };
        const auto point = [&](int i) { return i * i / (deviation * deviation) - 1; };
        const double f = std::max(std::abs(feature(a, edge) - feature(b, edge)),
                                  std::abs(feature(a, point) - feature(b, point)));
        const auto lightness = [&](const ByteImage& picture) {
            double sum = 0, weights = 0;
            for (int j = -wide; j <= wide; ++j)
                for (int i = -wide; i <= wide; ++i) {
                    const double w = std::exp(-kPiD * kPiD * (i * i + j * j) / (ppd * ppd) / 0.0047);
                    sum += w * luminance(picture, px + i, py + j);
                    weights += w;
                }
            return 116 * std::cbrt(sum / weights) - 16;
        };
        const double largest = 41.28; // of green and blue, to the power of 0.7
        const double error = std::pow(std::abs(lightness(a) - lightness(b)), 0.7);
        const double color = error < 0.4 * largest ? 0.95 / (0.4 * largest) * error
                                                   : 0.95 + (error - 0.4 * largest) / (0.6 * largest) * 0.05;
        const double expected = std::pow(color, 1 - std::min(1.0, std::sqrt(f / std::sqrt(2.0))));
        EXPECT_NEAR(result.at(px, py), expected, 2e-3) << px << " " << py;
    }
}

TEST(Flip, StaysWithinItsRange) {
    ByteImage a(64, 64), b(64, 64);
    std::uint32_t state = 1;
    const auto next = [&] {
        return static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24U);
    };
    for (auto* picture : {&a, &b})
        for (Rgba8& p : picture->values()) p = {next(), next(), next()};
    const Pixels<float> differences = flip(a, b);
    for (const float v : differences.values()) ASSERT_TRUE(v >= 0 && v <= 1);
}

TEST(Flip, PicturesOfDifferentSizesAreRefused) {
    EXPECT_THROW(flip(ByteImage(2, 3), ByteImage(3, 2)), InputError);
}

}
}
