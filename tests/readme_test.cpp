// labels: unit
#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/document/command.h"
#include "app/gui/actions.h"
#include "app/platform/keys.h"

namespace eyeray {
namespace {

std::string readme() {
    std::ostringstream text;
    text << std::ifstream(EYERAY_SOURCE_DIR "/README.md").rdbuf();
    return text.str();
}

TEST(Readme, ListsEveryKeyWithItsCommand) {
    const std::string text = readme();
    for (const Action& action : actions()) {
        if (action.chord.empty()) continue;
        const std::string row = fmt::format("| {} | {} | `{}` |", action.chord, action.label, action.command);
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
}

TEST(Readme, ListsEveryGestureOfTheMouse) {
    const std::string text = readme();
    for (const Gesture& gesture : gestures())
        EXPECT_NE(text.find(fmt::format("| {} | {} |", gesture.what, gesture.does)), std::string::npos)
            << gesture.what;
}

TEST(Actions, HaveKeysAndCommandsThatCanBeReadAndNoKeyTwice) {
    std::vector<std::string> chords;
    for (const Action& action : actions()) {
        EXPECT_NO_THROW(Command::parse(action.command)) << action.command;
        if (action.chord.empty()) continue;
        const std::string chord = format(parseKeyChord(action.chord));
        EXPECT_EQ(chord, action.chord);
        EXPECT_EQ(std::count(chords.begin(), chords.end(), chord), 0) << chord;
        chords.push_back(chord);
    }
}

}
}
