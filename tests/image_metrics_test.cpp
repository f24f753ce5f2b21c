// Differences of pictures against sums done by hand.
// labels: unit

#include "core/image/metrics.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

TEST(Metrics, EqualPicturesDoNotDiffer) {
    EXPECT_EQ(rmse(ColorImage(3, 2, Color(0.3F)), ColorImage(3, 2, Color(0.3F))), 0);
    EXPECT_EQ(maxByteDifference(ByteImage(3, 2), ByteImage(3, 2)), 0);
    EXPECT_EQ(countDifferingPixels(ByteImage(3, 2), ByteImage(3, 2)), 0U);
    EXPECT_EQ(rmse({}, {}), 0);
    EXPECT_EQ(maxByteDifference({}, {}), 0);
}

TEST(Metrics, RmseIsTheRootOfTheMeanSquareOverChannels) {
    ColorImage a(2, 2, Color(1)), b = a;
    b.at(1, 0) = Color(1, 4, -3); // squares 9 and 16 in 12 channels
    EXPECT_DOUBLE_EQ(rmse(a, b), std::sqrt(25.0 / 12));
    EXPECT_DOUBLE_EQ(rmse(b, a), std::sqrt(25.0 / 12));
    EXPECT_DOUBLE_EQ(rmse(ColorImage(1000, 1000, Color(0.25F)), ColorImage(1000, 1000)), 0.25);
    a.at(0, 1).y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(rmse(a, b)));
}

TEST(Metrics, RelativeErrorIsAShareOfTheReference) {
    const ColorImage reference(2, 1, Color(1));
    ColorImage test = reference;
    test.at(1, 0) = Color(1, 2, 1); // one of six channels: 1 / 1.01
    EXPECT_NEAR(relativeMse(reference, test), 1 / 1.01 / 6, 1e-12);
    EXPECT_NEAR(relativeMse(test, reference), 1 / 4.01 / 6, 1e-12);
    EXPECT_EQ(relativeMse({}, {}), 0);
}

TEST(Metrics, LargestAndNinetyFifthOfTheDifferences) {
    ColorImage a(10, 10, Color(0.5F)), b = a;
    b.at(3, 3) = Color(0.5F, 0.5F, 2.5F);
    for (int i = 0; i < 6; ++i) b.at(i, 9) = Color(0.25F); // 18 of 300 channels, with the one: 6.3 %
    EXPECT_EQ(maxDifference(a, b), 2);
    EXPECT_EQ(percentile95(a, b), 0.25);
    b.at(5, 9) = b.at(4, 9) = Color(0.5F);
    EXPECT_EQ(percentile95(a, b), 0);
    a.at(0, 0) = b.at(0, 0) = Color(kInfinity);
    EXPECT_EQ(maxDifference(a, b), 2) << "the same infinity is no difference";
    a.at(0, 0).x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(maxDifference(a, b)));
}

TEST(Metrics, BytesAreComparedInEveryChannel) {
    const ByteImage black(4, 1, {0, 0, 0, 0});
    ByteImage other = black;
    other.at(1, 0).g = 3;
    other.at(2, 0) = {1, 1, 2, 0};
    EXPECT_EQ(maxByteDifference(black, other), 3);
    other.at(3, 0).a = 255;
    EXPECT_EQ(maxByteDifference(black, other), 255);
    EXPECT_EQ(maxByteDifference(other, black), 255);
    EXPECT_EQ(countDifferingPixels(black, other), 3U);
}

TEST(Metrics, PicturesOfDifferentSizesAreRefusedWithBothSizes) {
    EXPECT_THROW(rmse(ColorImage(2, 3), ColorImage(3, 2)), InputError);
    EXPECT_THROW(maxByteDifference(ByteImage(2, 3), ByteImage(2, 2)), InputError);
    try {
        countDifferingPixels(ByteImage(640, 480), ByteImage(320, 240));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "comparison: 640x480 and 320x240 pixels: compare pictures of one size");
    }
}

}
}
