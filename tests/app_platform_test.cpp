// labels: ui
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/platform/glfw_platform.h"
#include "core/base/errors.h"
#include "tests/app_frames.h"

namespace eyeray {
namespace {

ByteImage frameWithText() {
    HeadlessPlatform platform(320, 200);
    play(platform, [] {
        fullWindow([] {
            ImGui::TextUnformatted("η θ σ ° × · ± ≤ ≥ → ↑ ↓ − … – “ ” ✓");
            float slider = 0.5F;
            ImGui::SliderFloat("index of refraction", &slider, 0, 1);
        });
    });
    return platform.screenshot();
}

TEST(Headless, AFrameWithTextIsTheSameByteForByteInASecondContext) {
    const ByteImage first = frameWithText();
    EXPECT_EQ(first, frameWithText());
    std::set<int> greens;
    for (const Rgba8& pixel : first.values()) {
        EXPECT_EQ(pixel.a, 255);
        greens.insert(pixel.g);
    }
    EXPECT_GT(greens.size(), 50U) << "smooth letters have many grey levels";
}

TEST(Headless, AnInjectedClickPressesAButtonExactlyOnce) {
    HeadlessPlatform platform(200, 100);
    int presses = 0;
    const auto ui = [&] { fullWindow([&] { presses += ImGui::Button("press", {100, 40}); }); };
    play(platform, ui);
    click(platform, 50, 20);
    play(platform, ui);
    EXPECT_EQ(presses, 1);
    click(platform, 150, 80);
    play(platform, ui);
    EXPECT_EQ(presses, 1) << "a click beside it";
    click(platform, 50, 20);
    click(platform, 50, 20);
    play(platform, ui);
    EXPECT_EQ(presses, 3);
}

TEST(Headless, TypedTextAndKeysReachATextField) {
    HeadlessPlatform platform(200, 100);
    std::array<char, 32> field{};
    const auto ui = [&] { fullWindow([&] { ImGui::InputText("##field", field.data(), field.size()); }); };
    play(platform, ui);
    click(platform, 20, 8);
    platform.text("η = 1.49");
    platform.chord({.key = kKeyBackspace});
    play(platform, ui);
    EXPECT_STREQ(field.data(), "η = 1.4");
    platform.chord(parseKeyChord("Ctrl+A"));
    platform.text("x");
    play(platform, ui);
    EXPECT_STREQ(field.data(), "x");
}

TEST(Headless, AChordIsPressedInOneFrameWithExactlyItsModifiers) {
    HeadlessPlatform platform(100, 100);
    int undo = 0;
    int redo = 0;
    int plain = 0;
    const auto ui = [&] {
        undo += pressed(parseKeyChord("Ctrl+Z"));
        redo += pressed(parseKeyChord("Ctrl+Shift+Z"));
        plain += pressed(parseKeyChord("Z"));
    };
    platform.chord(parseKeyChord("Ctrl+Z"));
    platform.chord(parseKeyChord("Ctrl+Shift+Z"));
    platform.chord(parseKeyChord("Ctrl+Shift+Z"));
    play(platform, ui);
    EXPECT_EQ(undo, 1);
    EXPECT_EQ(redo, 2);
    EXPECT_EQ(plain, 0);
}

TEST(Headless, LettersAndMeasuresGrowWithScreenAndPresenterScale) {
    HeadlessPlatform platform(100, 100, 2);
    float line = 0;
    float padding = 0;
    const auto ui = [&] {
        line = ImGui::GetFontSize();
        padding = ImGui::GetStyle().FramePadding.x;
    };
    ImGuiStyle style;
    style.FramePadding.x = 5;
    platform.setStyle(style);
    play(platform, ui);
    const float lineAtTwo = line;
    EXPECT_EQ(padding, 10);
    platform.setTextScale(1.5F);
    play(platform, ui);
    EXPECT_EQ(padding, 15);
    EXPECT_EQ(line, lineAtTwo * 1.5F);
    EXPECT_EQ(platform.scale(), 3);
}

TEST(Headless, TheFontHasTheSignsOfTheLectures) {
    HeadlessPlatform platform(100, 100);
    play(platform, [] {});
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    for (const ImWchar character : std::u16string_view(u"ηθσΛäé°×·±²≤≥≈→↑↓−…–“”✓⚠▶▲●⁻⁹₀∞√∫∂"))
        EXPECT_NE(font.FindGlyphNoFallback(character), nullptr) << "U+" << std::hex << character;
}

TEST(Headless, AFrameThatAnExceptionEndedDoesNotEndTheProgram) {
    HeadlessPlatform platform(100, 100);
    const auto broken = [] {
        ImGui::Begin("panel");
        ImGui::BeginGroup();
        ImGui::PushID(1);
        throw Failure{"panel", "broken", "go on"};
    };
    EXPECT_THROW(play(platform, broken), Failure);
    int items = 0;
    play(platform, [&] {
        fullWindow([&] {
            ImGui::Button("whole");
            ++items;
        });
    });
    EXPECT_EQ(items, 1);
    EXPECT_NO_THROW(platform.screenshot());
}

TEST(Glfw, WithoutADisplayTheFailureNamesTheHeadlessWay) {
    setenv("DISPLAY", "", 1); // NOLINT(concurrency-mt-unsafe): no other thread here
    try {
        const GlfwPlatform platform("no display", std::nullopt);
        FAIL() << "nothing thrown";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("`eyeray snapshot`"), std::string::npos) << failure.what();
    }
}

}
}
