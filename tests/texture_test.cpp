// labels: unit
// Reading textures: wrapping, filtering, coding, the checkerboard, and coordinates that are no numbers.

#include <gtest/gtest.h>

#include "core/scene/texture.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

constexpr int kWidth = 4, kHeight = 3;

/// A scene with one image; each texel's red is its column and its green its row.
Scene sceneWithImage() {
    ByteImage pixels(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            pixels.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 128};
    Scene scene;
    scene.images = {{"", std::make_shared<const ByteImage>(pixels), nullptr}};
    return scene;
}

/// Column and row as read at uv.
Vec2 read(const ImageTexture& texture, const Vec2& uv) {
    const Color value = textureValue(sceneWithImage(), {"", texture}, uv, TextureCoding::Linear);
    return 255.0F * Vec2(value);
}

Vec2 middleOf(int x, int y) {
    return {(static_cast<float>(x) + 0.5F) / kWidth, (static_cast<float>(y) + 0.5F) / kHeight};
}

void expectNear(const Vec2& actual, const Vec2& expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-4);
    EXPECT_NEAR(actual.y, expected.y, 1e-4);
}

TEST(Texture, MiddleOfATexelIsTheTexel) {
    for (const bool nearest : {true, false})
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                expectNear(read({.nearest = nearest}, middleOf(x, y)), Vec2(x, y)); // the first row is on top
}

TEST(Texture, BilinearIsLinearBetweenTexels) {
    expectNear(read({}, Vec2(1.75F / kWidth, 1.25F / kHeight)), {1.25F, 0.75F});
    expectNear(read({}, Vec2(0, 0.5F)), {1.5F, 1}); // half way round from the last column to the first
    expectNear(read({.wrapU = Wrap::Clamp}, Vec2(0, 0.5F)), {0, 1});
    expectNear(read({.wrapU = Wrap::Mirror}, Vec2(1, 0.5F)), {3, 1});
}

TEST(Texture, WrapsAsItsSamplerSays) {
    struct Case {
        int column;
        int repeated, clamped, mirrored;
    };
    for (const Case& c :
         {Case{-1, 3, 0, 0}, {-4, 0, 0, 3}, {-5, 3, 0, 3}, {4, 0, 3, 3}, {7, 3, 3, 0}, {8, 0, 3, 0}}) {
        const Vec2 uv = middleOf(c.column, 0);
        EXPECT_EQ(read({.wrapU = Wrap::Repeat, .nearest = true}, uv).x, static_cast<float>(c.repeated))
            << c.column;
        EXPECT_EQ(read({.wrapU = Wrap::Clamp, .nearest = true}, uv).x, static_cast<float>(c.clamped))
            << c.column;
        EXPECT_EQ(read({.wrapU = Wrap::Mirror, .nearest = true}, uv).x, static_cast<float>(c.mirrored))
            << c.column;
        const Vec2 down = middleOf(0, 1 - kHeight);
        EXPECT_EQ(read({.wrapV = Wrap::Repeat, .nearest = true}, down).y, 1);
    }
}

TEST(Texture, CodedBytesAreDecodedBeforeFiltering) {
    const Scene scene = sceneWithImage();
    const Texture texture{"", ImageTexture{}};
    EXPECT_NEAR(textureValue(scene, texture, Vec2(0.5F), TextureCoding::Srgb).b, 0.215860500, 1e-6);
    EXPECT_NEAR(textureValue(scene, texture, Vec2(0.5F), TextureCoding::Linear).b, 128.0 / 255, 1e-6);
}

TEST(Texture, IsSafeAtAnyCoordinates) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Scene scene = sceneWithImage();
    for (const float u : {nan, kInfinity, -kInfinity, 1e30F, -3e9F, 2.2e9F, 1e-40F})
        for (const float v : {0.5F, u})
            for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror})
                for (const bool nearest : {true, false}) {
                    const ImageTexture image{.wrapU = wrap, .wrapV = wrap, .nearest = nearest};
                    const Color c = textureValue(scene, {"", image}, {u, v}, TextureCoding::Srgb);
                    EXPECT_TRUE(isFinite(c) && minComponent(c) >= 0 && maxComponent(c) <= 1) << u;
                }
    EXPECT_TRUE(isFinite(textureValue(scene, {"", CheckerTexture{}}, Vec2(nan), TextureCoding::Srgb)));
}

TEST(Checker, HasUnitCellsThatAlternateAcrossZero) {
    const Scene scene;
    const Texture checker{"", CheckerTexture{Color(1), Color(0)}};
    for (int y = -5; y <= 5; ++y)
        for (int x = -5; x <= 5; ++x)
            for (const float inside : {0.0F, 0.5F, 0.999F}) {
                const Vec2 uv = Vec2(x, y) + inside;
                EXPECT_EQ(textureValue(scene, checker, uv, TextureCoding::Srgb).r, (x + y) % 2 == 0 ? 1 : 0);
            }
}

}
}
