// labels: unit threads
// From radiance to bytes: the sRGB curve, tone maps, exposure and its meter.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/render/display.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

Rgba8 shown(const Color& radiance, ToneMap map = ToneMap::Clamp, double exposure = 0) {
    return display(ColorImage(1, 1, radiance), {.exposure = exposure, .toneMap = map}).at(0, 0);
}

double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

int code(double value) { return static_cast<int>(std::floor(255 * std::clamp(value, 0.0, 1.0) + 0.5)); }

TEST(Display, HasTheCodesOfTheStandard) {
    EXPECT_EQ(shown({0.5F, 0.18F, 0.2158605F}), (Rgba8{188, 118, 128, 255}));
    EXPECT_EQ(shown({0, 1, 1000}), (Rgba8{0, 255, 255, 255}));
    EXPECT_EQ(shown({-1, -1e30F, 1e-9F}), (Rgba8{0, 0, 0, 255}));
}

TEST(Display, OfALargePictureIsThatOfItsPixels) {
    cases::Random random(2);
    ColorImage image(1025, 1027);
    for (Color& c : image.values())
        c = Color(random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2));
    std::vector<Rgba8> pixels(image.values().size());
    display(image.values(), {}, pixels);
    const ByteImage whole = display(image, {});
    EXPECT_TRUE(std::ranges::equal(whole.values(), pixels));
}

TEST(Display, WithoutToneMapIsLinear) {
    EXPECT_EQ(shown({0.5F, 0.25F, 1}, ToneMap::None), (Rgba8{128, 64, 255, 255}));
    EXPECT_EQ(shown({2, -2, 0}, ToneMap::None), (Rgba8{255, 0, 0, 255}));
}

TEST(Display, IsDefinedForAnyNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const ToneMap map : {ToneMap::None, ToneMap::Clamp, ToneMap::Reinhard, ToneMap::Aces}) {
        EXPECT_EQ(shown(Color(nan), map), (Rgba8{0, 0, 0, 255}));
        EXPECT_EQ(shown(Color(1e6F), map), (Rgba8{255, 255, 255, 255})) << static_cast<int>(map);
    }
}

TEST(Display, ExposureIsInStopsBeforeAllElse) {
    for (const ToneMap map : {ToneMap::None, ToneMap::Clamp, ToneMap::Reinhard, ToneMap::Aces})
        for (const float value : {0.01F, 0.1F, 0.7F}) {
            EXPECT_EQ(shown(Color(value), map, 2), shown(Color(4 * value), map));
            EXPECT_EQ(shown(Color(value), map, -1), shown(Color(value / 2), map));
        }
}

TEST(Display, ReinhardDividesByOnePlusTheLuminance) {
    EXPECT_EQ(shown(Color(1), ToneMap::Reinhard).g, 188);
    cases::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Color c(random.uniform(0, 5), random.uniform(0, 5), random.uniform(0, 5));
        const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        const Rgba8 actual = shown(c, ToneMap::Reinhard);
        EXPECT_NEAR(actual.r, code(srgb(c.r / (1 + y))), 1);
        EXPECT_NEAR(actual.g, code(srgb(c.g / (1 + y))), 1);
        EXPECT_NEAR(actual.b, code(srgb(c.b / (1 + y))), 1);
    }
}

TEST(Display, AcesIsTheFittedCurve) {
    for (double x = 0.001; x < 50; x *= 1.3) {
        const double curve = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        EXPECT_NEAR(shown(Color(static_cast<float>(x)), ToneMap::Aces).r, code(srgb(curve)), 1) << x;
    }
}

TEST(Display, NeverDarkensWhatIsBrighter) {
    for (const ToneMap map : {ToneMap::None, ToneMap::Clamp, ToneMap::Reinhard, ToneMap::Aces}) {
        int before = 0;
        for (float value = 1e-5F; value < 1e3F; value *= 1.01F) {
            const int now = shown(Color(value), map).g;
            EXPECT_GE(now, before);
            before = now;
        }
        EXPECT_GE(before, 254);
    }
}

TEST(Display, OfAPictureIsThatOfItsPixels) {
    ColorImage picture(3, 2);
    for (int i = 0; i < 6; ++i)
        picture.values()[static_cast<std::size_t>(i)] = Color(static_cast<float>(i) / 5);
    const ByteImage bytes = display(picture, {});
    ASSERT_EQ(bytes.width(), 3);
    ASSERT_EQ(bytes.height(), 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) EXPECT_EQ(bytes.at(x, y), shown(picture.at(x, y)));
}

TEST(DisplaySlope, IsThatOfTheCurve) {
    for (const double exposure : {0.0, 2.0, -3.0})
        for (const double y : {0.001, 0.01, 0.1, 0.5, 0.9}) {
            const double e = std::exp2(exposure), x = y * e;
            if (x > 0.95) continue;
            const double h = 1e-6, slope = e * (srgb(x + h) - srgb(x - h)) / (2 * h);
            const double actual = displaySlope(static_cast<float>(y), {.exposure = exposure});
            EXPECT_NEAR(actual, slope, 0.25 * slope) << y; // a secant over a visible step, not a tangent
        }
}

TEST(DisplaySlope, IsNoneWhereTheScreenIsWhite) {
    EXPECT_EQ(displaySlope(1.5F, {}), 0);
    EXPECT_GT(displaySlope(1.5F, {.exposure = 0, .toneMap = ToneMap::Reinhard}), 0);
}

double logAverage(const ColorImage& picture, double exposure) {
    double sum = 0;
    for (const Color& c : picture.values()) sum += std::log2(luminance(c) * std::exp2(exposure));
    return std::exp2(sum / static_cast<double>(picture.values().size()));
}

TEST(MeteredExposure, BringsTheLogAverageToMiddleGrey) {
    EXPECT_NEAR(meteredExposure(ColorImage(4, 4, Color(0.18F))), 0, 0.01);
    EXPECT_NEAR(meteredExposure(ColorImage(4, 4, Color(18))), std::log2(0.01), 0.01);
    cases::Random random(2);
    ColorImage picture(50, 40);
    for (Color& c : picture.values()) c = Color(static_cast<float>(std::exp2(random.uniform(-4, 6))));
    EXPECT_NEAR(logAverage(picture, meteredExposure(picture)), 0.18, 0.002);
}

TEST(MeteredExposure, OfABlackPictureIsNone) {
    EXPECT_EQ(meteredExposure(ColorImage(4, 4, Color(0))), 0);
    EXPECT_EQ(meteredExposure(ColorImage()), 0);
}

TEST(MeteredExposure, DoesNotLookAtABlackBackground) {
    ColorImage picture(10, 10, Color(0));
    picture.at(4, 4) = picture.at(5, 5) = Color(0.5F);
    EXPECT_NEAR(meteredExposure(picture), std::log2(0.18 / 0.5), 0.01);
}

}
}
