// labels: ui
#include <string>

#include <gtest/gtest.h>

#include "app/gl/font.h"
#include "app/gl/framebuffer.h"
#include "app/gl/imgui_renderer.h"
#include "core/base/errors.h"
#include "tests/app_frames.h"

namespace eyeray {
namespace {

/// Every pixel has a colour of its own.
ByteImage distinctPixels(int width, int height) {
    ByteImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 5),
                              static_cast<std::uint8_t>(x ^ y), 255};
    return image;
}

/// What stands in the framebuffer when the texture is drawn at (x, y), `size` large.
ByteImage drawn(HeadlessPlatform& platform, const GlTexture& texture, ImVec2 at, ImVec2 size) {
    play(platform, [&] {
        ImGui::GetForegroundDrawList()->AddImage(textureId(texture), at, {at.x + size.x, at.y + size.y});
    });
    return platform.screenshot();
}

TEST(Font, IsATrueTypeFile) {
    ASSERT_GT(fontBytes().size(), 100'000U);
    EXPECT_EQ(std::to_integer<int>(fontBytes()[0]), 0);
    EXPECT_EQ(std::to_integer<int>(fontBytes()[1]), 1); // sfnt version 1.0
}

TEST(GlTexture, IsDrawnPixelForPixelAtItsOwnSize) {
    HeadlessPlatform platform(64, 48);
    const ByteImage image = distinctPixels(33, 21);
    GlTexture texture(platform.gl());
    texture.upload(image);
    const ByteImage shown = drawn(platform, texture, {7, 11}, {33, 21});
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            ASSERT_EQ(shown.at(x + 7, y + 11), image.at(x, y)) << x << ' ' << y;
    EXPECT_EQ(shown.at(6, 11), (Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(shown.at(40, 31), (Rgba8{0, 0, 0, 255}));
}

TEST(GlTexture, AnUploadedPartChangesNothingBesideIt) {
    HeadlessPlatform platform(33, 21);
    const ByteImage before = distinctPixels(33, 21);
    const ByteImage after(33, 21, Rgba8{200, 100, 50, 255});
    GlTexture texture(platform.gl());
    texture.upload(before);
    texture.upload(after, {5, 3, 7, 9});
    const ByteImage shown = drawn(platform, texture, {0, 0}, {33, 21});
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 33; ++x) {
            const bool inside = x >= 5 && x < 12 && y >= 3 && y < 12;
            ASSERT_EQ(shown.at(x, y), (inside ? after : before).at(x, y)) << x << ' ' << y;
        }
}

TEST(GlTexture, APartOutsideOrOfAnotherSizeIsRefused) {
    const HeadlessPlatform platform(8, 8);
    GlTexture texture(platform.gl());
    const ByteImage image(8, 8);
    texture.upload(image);
    EXPECT_THROW(texture.upload(image, {4, 0, 5, 1}), InternalError);
    EXPECT_THROW(texture.upload(image, {0, -1, 1, 1}), InternalError);
    EXPECT_THROW(texture.upload(ByteImage(9, 8), {0, 0, 1, 1}), InternalError);
}

TEST(GlTexture, ASizeBeyondTheCardsIsAFailure) {
    const HeadlessPlatform platform(8, 8);
    GlTexture texture(platform.gl());
    EXPECT_THROW(texture.upload(ByteImage(1 << 20, 1)), Failure);
}

TEST(GlTexture, MagnifiedItShowsItsPixelsOrIsSmooth) {
    HeadlessPlatform platform(16, 16);
    ByteImage image(2, 2, Rgba8{0, 0, 0, 255});
    image.at(1, 0) = image.at(1, 1) = {255, 255, 255, 255};
    GlTexture texture(platform.gl());
    texture.upload(image);
    const ByteImage hard = drawn(platform, texture, {0, 0}, {16, 16});
    EXPECT_EQ(hard.at(7, 5).r, 0);
    EXPECT_EQ(hard.at(8, 5).r, 255);
    texture.setMagnify(Magnify::Smooth);
    const ByteImage smooth = drawn(platform, texture, {0, 0}, {16, 16});
    EXPECT_NEAR(smooth.at(7, 5).r, 255 * (7.5 / 16 - 0.25) * 2, 2); // linear between the texels' centres
    EXPECT_NEAR(smooth.at(8, 5).r, 255 * (8.5 / 16 - 0.25) * 2, 2);
}

TEST(Framebuffer, ItsFirstRowIsTheTopOne) {
    const HeadlessPlatform platform(8, 8);
    const Framebuffer framebuffer(platform.gl(), 4, 3);
    framebuffer.bind();
    const Gl& gl = platform.gl();
    gl.clearColor(1, 0, 0, 1);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl.enable(GL_SCISSOR_TEST);
    gl.scissor(0, 2, 4, 1); // OpenGL counts rows from below
    gl.clearColor(0, 1, 0, 1);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl.disable(GL_SCISSOR_TEST);
    const ByteImage image = framebuffer.read();
    EXPECT_EQ(image.at(3, 0), (Rgba8{0, 255, 0, 255}));
    EXPECT_EQ(image.at(0, 1), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(image.at(0, 2), (Rgba8{255, 0, 0, 255}));
}

TEST(ImGuiRenderer, DrawsOnlyInsideTheClipRectangle) {
    HeadlessPlatform platform(32, 32);
    play(platform, [] {
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        list.PushClipRect({4, 6}, {20, 9});
        list.AddRectFilled({0, 0}, {32, 32}, IM_COL32(10, 20, 30, 255));
        list.PopClipRect();
    });
    const ByteImage shown = platform.screenshot();
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const bool inside = x >= 4 && x < 20 && y >= 6 && y < 9;
            ASSERT_EQ(shown.at(x, y), inside ? (Rgba8{10, 20, 30, 255}) : (Rgba8{0, 0, 0, 255}))
                << x << ' ' << y;
        }
}

TEST(ImGuiRenderer, AListOfMoreVerticesThanAnIndexCanCountIsDrawnWhole) {
    constexpr int kSide = 160; // 25600 squares of 4 vertices
    HeadlessPlatform platform(kSide, kSide);
    play(platform, [] {
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const ImVec2 corner(static_cast<float>(x), static_cast<float>(y));
                list.AddRectFilled(corner, {corner.x + 1, corner.y + 1}, IM_COL32(x, y, 255, 255));
            }
    });
    const ByteImage shown = platform.screenshot();
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            ASSERT_EQ(shown.at(x, y),
                      (Rgba8{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 255, 255}));
}

TEST(Gl, AMissingFunctionIsNamed) {
    try {
        const Gl gl([](const char* name) -> void* {
            return std::string(name) == "glDrawElementsBaseVertex" ? nullptr : reinterpret_cast<void*>(1);
        });
        FAIL() << "nothing thrown";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("glDrawElementsBaseVertex"), std::string::npos);
    }
}

TEST(Program, AShaderThatDoesNotCompileFailsWithTheReason) {
    const HeadlessPlatform platform(8, 8);
    EXPECT_THROW(Program(platform.gl(), "#version 330 core\nvoid main() { nonsense; }", ""), Failure);
}

}
}
