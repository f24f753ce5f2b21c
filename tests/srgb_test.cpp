// The sRGB curve against its definition, and the fast bytes against the curve.
// labels: unit

#include "core/image/srgb.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace eyeray {
namespace {

/// The definition, with more digits than any float needs.
long double exactEncode(long double linear) {
    return linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1 / 2.4L) - 0.055L;
}

int exactByte(float linear) {
    if (!(linear > 0)) return 0;
    return linear >= 1 ? 255 : static_cast<int>(std::floor(255 * exactEncode(linear) + 0.5L));
}

float neighbour(float value, int ulps) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + static_cast<std::uint32_t>(ulps));
}

TEST(Srgb, KnownValuesOfTheStandard) {
    EXPECT_EQ(encodeSrgb8(0.5F), 188);
    EXPECT_EQ(encodeSrgb8(0.18F), 118);
    EXPECT_FLOAT_EQ(encodeSrgb(1), 1);
    EXPECT_FLOAT_EQ(encodeSrgb(0.001F), 0.01292F);
    EXPECT_FLOAT_EQ(decodeSrgb(1), 1);
    EXPECT_EQ(decodeSrgb8(0), 0);
    EXPECT_EQ(decodeSrgb8(255), 1);
}

TEST(Srgb, TheCurveIsNotClamped) {
    EXPECT_GT(encodeSrgb(4), 1.8F);
    EXPECT_FLOAT_EQ(encodeSrgb(-0.01F), -0.1292F);
    EXPECT_TRUE(std::isnan(encodeSrgb(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_TRUE(std::isinf(decodeSrgb(std::numeric_limits<float>::infinity())));
}

TEST(Srgb, DecodingUndoesEncoding) {
    // The two pieces of the standard's curve miss each other by 1e-7 at their joint: hence not closer.
    for (int i = -20'000; i < 7'000; ++i) {
        const float x = std::exp2(static_cast<float>(i) / 1000);
        EXPECT_NEAR(decodeSrgb(encodeSrgb(x)), x, 4e-7F * x + 3e-8F);
    }
}

TEST(Srgb, EveryByteSurvivesDecodingAndEncoding) {
    for (int byte = 0; byte < 256; ++byte) {
        const float linear = decodeSrgb8(static_cast<std::uint8_t>(byte));
        EXPECT_EQ(encodeSrgb8(linear), byte);
        EXPECT_FLOAT_EQ(linear, decodeSrgb(static_cast<float>(byte) / 255));
    }
}

TEST(Srgb, BytesChangeExactlyWhereTheExactCurveIsHalfwayBetweenTwo) {
    for (int byte = 1; byte < 256; ++byte) {
        const long double code = (byte - 0.5L) / 255;
        const auto edge =
            static_cast<float>(code <= 0.04045L ? code / 12.92L : std::pow((code + 0.055L) / 1.055L, 2.4L));
        for (int ulps = -200; ulps <= 200; ++ulps) {
            const float linear = neighbour(edge, ulps);
            ASSERT_EQ(encodeSrgb8(linear), exactByte(linear)) << linear;
        }
    }
}

TEST(Srgb, BytesAreRoundedExactlyOverTheWholeRange) {
    for (std::uint32_t bits = 1; bits < std::bit_cast<std::uint32_t>(2.0F); bits += 1009) {
        const auto linear = std::bit_cast<float>(bits);
        ASSERT_EQ(encodeSrgb8(linear), exactByte(linear)) << linear;
    }
}

TEST(Srgb, BytesClampWhatIsOutsideAndTakeNanAsBlack) {
    using Limits = std::numeric_limits<float>;
    for (const float dark : {-Limits::infinity(), -Limits::max(), -1.0F, -0.0F, 0.0F, Limits::denorm_min()})
        EXPECT_EQ(encodeSrgb8(dark), 0) << dark;
    for (const float bright : {1.0F, 1.5F, Limits::max(), Limits::infinity()})
        EXPECT_EQ(encodeSrgb8(bright), 255) << bright;
    EXPECT_EQ(encodeSrgb8(Limits::quiet_NaN()), 0);
    EXPECT_EQ(encodeSrgb8(-Limits::quiet_NaN()), 0);
}

}
}
