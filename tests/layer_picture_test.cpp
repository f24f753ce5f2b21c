// labels: unit image
// Layers as pictures: their colours, and as the channels of one EXR.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/image/srgb.h"
#include "core/study/color_map.h"
#include "core/study/layer_picture.h"
#include "tests/read_pictures.h"

namespace eyeray {
namespace {

/// OKLab of a displayed colour. Ottosson 2020, from linear sRGB.
DVec3 oklab(const Rgba8& c) {
    const double r = decodeSrgb8(c.r), g = decodeSrgb8(c.g), b = decodeSrgb8(c.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

LayerImage imageOf(Quantity quantity, const std::vector<float>& values, const std::string& name = "layer") {
    LayerImage image;
    image.layer.quantity = quantity;
    image.layer.name = name;
    image.values = ColorImage(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i) image.values.values()[i] = Color(values[i]);
    return image;
}

TEST(ColorMap, EqualStepsOfHeatAreEqualStepsOfColorAndAlwaysLighter) {
    constexpr int kSteps = 16; // wide against the rounding to bytes
    std::array<double, kSteps> steps{};
    for (int i = 0; i < kSteps; ++i) {
        const DVec3 from = oklab(heatColor(i / 16.0)), to = oklab(heatColor((i + 1) / 16.0));
        steps[static_cast<std::size_t>(i)] = glm::length(to - from);
        EXPECT_GT(to.x, from.x) << i;
    }
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_LT(*most, 1.15 * *least);
    EXPECT_EQ(heatColor(-1), heatColor(0));
    EXPECT_EQ(heatColor(2), heatColor(1));
}

TEST(ColorMap, EqualStepsOfDepthAreEqualStepsOfLightnessWithoutHue) {
    for (int i = 0; i < 8; ++i) {
        const Rgba8 near = depthColor(i / 8.0), far = depthColor((i + 1) / 8.0);
        EXPECT_NEAR(oklab(near).x - oklab(far).x, 0.78 / 8, 0.006);
        EXPECT_EQ(near.r, near.g);
        EXPECT_EQ(near.g, near.b);
    }
    EXPECT_EQ(depthColor(0), (Rgba8{255, 255, 255}));
}

TEST(ColorMap, ObjectsOfSmallNumbersAreFarApart) {
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < i; ++j)
            EXPECT_GT(glm::length(oklab(objectColor(i)) - oklab(objectColor(j))), 0.045) << i << " " << j;
}

TEST(LayerPicture, ANormalIsShownAsHalfPlusHalfOfItAndNoHitAsBlack) {
    LayerImage image = imageOf(Quantity::Normal, {0, 0, 0});
    image.values.values() = {Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(0)};
    const ByteImage shown = displayLayer(image, {}, {.exposure = 3});
    EXPECT_EQ(shown.at(0, 0), (Rgba8{128, 128, 255}));
    EXPECT_EQ(shown.at(1, 0), (Rgba8{0, 128, 128}));
    EXPECT_EQ(shown.at(2, 0), (Rgba8{0, 0, 0}));
}

TEST(LayerPicture, DepthRunsFromTheNearestInWhiteAndItsBackgroundIsBlack) {
    const LayerImage image = imageOf(Quantity::Depth, {2, 8, 32, kInfinity});
    const LayerRange range = rangeOf(image);
    EXPECT_EQ(range.lowest, 2);
    EXPECT_EQ(range.highest, 32);
    EXPECT_NEAR(placeIn(range, Quantity::Depth, 8), 0.5, 1e-12) << "equal ratios are equal steps";
    EXPECT_NEAR(valueAt(range, Quantity::Depth, 0.75), 16, 1e-12);
    EXPECT_NEAR(valueAt(range, Quantity::Rays, 0.5), 17, 1e-12);
    const ByteImage shown = displayLayer(image, range, {});
    EXPECT_EQ(shown.at(0, 0), depthColor(0));
    EXPECT_EQ(shown.at(1, 0), depthColor(0.5));
    EXPECT_EQ(shown.at(2, 0), depthColor(1));
    EXPECT_EQ(shown.at(3, 0), (Rgba8{0, 0, 0}));
    EXPECT_NE(rangeText(image, range).find("2 m (white) to 32 m"), std::string::npos);
}

TEST(LayerPicture, AFewOutliersDoNotDarkenAHeatMapAndTheRangeSaysSo) {
    std::vector<float> values(1000, 3);
    values[7] = 1e6F;
    const LayerImage rays = imageOf(Quantity::Rays, values), depths = imageOf(Quantity::Recursion, values);
    EXPECT_EQ(rangeOf(rays).lowest, 0);
    EXPECT_EQ(rangeOf(rays).highest, 3);
    EXPECT_TRUE(rangeOf(rays).cut);
    EXPECT_EQ(rangeOf(depths).highest, 1e6);
    EXPECT_FALSE(rangeOf(depths).cut);
    EXPECT_GT(rangeOf(imageOf(Quantity::Error, {0, 0})).highest, 0) << "no division by zero";
}

TEST(LayerPicture, RadianceGoesThroughTheDisplayTransformAndAlbedoDoesNot) {
    LayerImage image = imageOf(Quantity::Lamp, {0.1F, 0.5F});
    const DisplaySettings brighter{.exposure = 2};
    EXPECT_EQ(displayLayer(image, {}, brighter), display(image.values, brighter));
    image.layer.quantity = Quantity::Albedo;
    EXPECT_EQ(displayLayer(image, {}, brighter), display(image.values, DisplaySettings{}));
}

TEST(LayerPicture, ObjectsHaveTheirColorsNothingIsBlackAndLampsAreWhite) {
    const ByteImage shown = displayLayer(imageOf(Quantity::Object, {0, 5, -1, -2}), {}, {});
    EXPECT_EQ(shown.values(),
              (LargeArray<Rgba8>{objectColor(0), objectColor(5), Rgba8{0, 0, 0}, Rgba8{255, 255, 255}}));
}

/// One channel of an EXR.
std::vector<float> readChannel(std::span<const std::byte> bytes, const std::string& name) {
    ExrBytes stream(bytes);
    Imf::InputFile file(stream, 0);
    if (!file.header().channels().findChannel(name)) throw std::runtime_error("no channel " + name);
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x) + 1,
               height = static_cast<std::size_t>(window.max.y) + 1;
    std::vector<float> values(width * height);
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                  sizeof(float) * width));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

TEST(LayerPicture, AllLayersStandInOneExrUnderTheirConventionalNames) {
    const std::string longName = "lamp." + std::string(90, 'x');
    std::vector<LayerImage> images = {
        imageOf(Quantity::Picture, {1, 2}, "color"), imageOf(Quantity::Normal, {0.5F, -1}, "normal"),
        imageOf(Quantity::Depth, {3, kInfinity}, "depth"), imageOf(Quantity::Rays, {4, 7}, "rays"),
        imageOf(Quantity::Lamp, {0.25F, 8}, longName)};
    images[1].values.at(0, 0) = Vec3(0.5F, 0.25F, -0.125F);
    std::vector<ImageChannel> channels;
    for (const LayerImage& image : images)
        for (const ImageChannel& channel : channelsOf(image)) channels.push_back(channel);
    const auto bytes = encodeChannels(channels, {{"eyeray.scene", "two balls"}});
    using Values = std::vector<float>;
    EXPECT_EQ(readChannel(bytes, "R"), (Values{1, 2}));
    EXPECT_EQ(readChannel(bytes, "normal.X"), (Values{0.5F, -1}));
    EXPECT_EQ(readChannel(bytes, "normal.Z"), (Values{-0.125F, -1}));
    EXPECT_EQ(readChannel(bytes, "depth.Z"), (Values{3, kInfinity}));
    EXPECT_EQ(readChannel(bytes, "rays.Y"), (Values{4, 7}));
    EXPECT_EQ(readChannel(bytes, longName + ".B"), (Values{0.25F, 8}));
    EXPECT_EQ(readExr(bytes).image, images[0].values);
}

}
}
