// labels: unit
#include "app/platform/input.h"

#include <cfloat>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace eyeray {
namespace {

/// The frames that a queue makes of these events: what ImGui is told before each, read from its state.
template <class Read>
auto frames(const std::vector<InputEvent>& events, Read read) {
    InputQueue queue;
    for (const InputEvent& event : events) queue.push(event);
    ImGuiIO io;
    std::vector<decltype(read(io))> seen;
    while (!queue.empty()) {
        queue.feed(io);
        seen.push_back(read(io));
    }
    return seen;
}

TEST(InputQueue, APressAndItsReleaseAreSeenInDifferentFrames) {
    const std::vector<InputEvent> twoClicks = {MouseButton{0, true}, MouseButton{0, false},
                                               MouseButton{0, true}, MouseButton{0, false}};
    EXPECT_EQ(frames(twoClicks, [](const ImGuiIO& io) { return io.MouseDown[0]; }),
              (std::vector{true, false, true, false}));
    EXPECT_EQ(frames({KeyChanged{'A', true}, KeyChanged{'A', false}},
                     [](const ImGuiIO& io) { return io.KeysDown['A']; }),
              (std::vector{true, false}));
}

TEST(InputQueue, MovesOfOneFrameCountAsTheLastAndAClickHappensWhereThePointerThenIs) {
    const auto seen = frames({MouseMoved{1, 1}, MouseMoved{5, 6}, MouseButton{0, true}, MouseMoved{9, 9}},
                             [](const ImGuiIO& io) { return std::pair(io.MousePos.x, io.MouseDown[0]); });
    EXPECT_EQ(seen, (std::vector<std::pair<float, bool>>{{5.0F, true}, {9.0F, true}}));
}

TEST(InputQueue, ADragShowsItsEndBeforeTheRelease) {
    const auto seen =
        frames({MouseButton{0, true}, MouseMoved{4, 0}, MouseMoved{8, 0}, MouseButton{0, false}},
               [](const ImGuiIO& io) { return std::pair(io.MousePos.x, io.MouseDown[0]); });
    ASSERT_EQ(seen.size(), 3U);
    EXPECT_EQ(seen[1], std::pair(8.0F, true));
    EXPECT_EQ(seen[2], std::pair(8.0F, false));
}

TEST(InputQueue, AModifierCountsForTheKeysAfterItOnly) {
    const auto modified = [](const ImGuiIO& io) { return std::pair(io.KeyCtrl, io.KeysDown['Z']); };
    EXPECT_EQ(frames({KeyChanged{kKeyLeftCtrl, true}, KeyChanged{'Z', true}}, modified),
              (std::vector{std::pair(true, true)}));
    EXPECT_EQ(frames({KeyChanged{'Z', true}, KeyChanged{kKeyRightCtrl, true}}, modified),
              (std::vector{std::pair(false, true), std::pair(true, true)}));
    EXPECT_EQ(frames({KeyChanged{kKeyLeftCtrl, true}, KeyChanged{kKeyRightCtrl, true},
                      KeyChanged{kKeyLeftCtrl, false}},
                     [](const ImGuiIO& io) { return io.KeyCtrl; }),
              (std::vector{true, true}))
        << "until both sides are up";
}

TEST(InputQueue, TurnsOfTheWheelInOneFrameAddUp) {
    const auto seen = frames({WheelTurned{0, 1}, WheelTurned{0.5F, 2}},
                             [](const ImGuiIO& io) { return std::pair(io.MouseWheelH, io.MouseWheel); });
    EXPECT_EQ(seen, (std::vector{std::pair(0.5F, 3.0F)}));
}

TEST(InputQueue, TypedLettersShareAFrameButAKeyAfterThemDoesNot) {
    const auto seen =
        frames({TextTyped{"a"}, TextTyped{"ß"}, KeyChanged{kKeyEnter, true}}, [](const ImGuiIO& io) {
            return std::pair(io.InputQueueCharacters.size(), io.KeysDown[kKeyEnter]);
        });
    EXPECT_EQ(seen, (std::vector{std::pair(2, false), std::pair(2, true)}));
}

TEST(InputQueue, TakesNoMoreThanAskedFor) {
    InputQueue queue;
    for (const float x : {1.0F, 2.0F}) queue.push(MouseMoved{x, 0});
    ImGuiIO io;
    queue.feed(io, 1);
    EXPECT_EQ(io.MousePos.x, 1);
    EXPECT_FALSE(queue.empty());
    queue.feed(io, 1);
    EXPECT_EQ(io.MousePos.x, 2);
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, ThePointerThatLeavesIsNowhere) {
    EXPECT_EQ(frames({MouseMoved{1, 1}, MouseLeft{}}, [](const ImGuiIO& io) { return io.MousePos.x; }),
              std::vector{-FLT_MAX}); // ImGui's word for nowhere
}

}
}
