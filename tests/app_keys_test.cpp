// labels: unit
#include "app/platform/keys.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

TEST(Keys, AChordReadsItsModifiersAndItsKey) {
    EXPECT_EQ(parseKeyChord("Space"), (KeyChord{.key = kKeySpace}));
    EXPECT_EQ(parseKeyChord("F1"), (KeyChord{.key = kKeyF1}));
    EXPECT_EQ(parseKeyChord("F12"), (KeyChord{.key = kKeyF1 + 11}));
    EXPECT_EQ(parseKeyChord("A"), (KeyChord{.key = 'A'}));
    EXPECT_EQ(parseKeyChord("Ctrl+Z"), (KeyChord{.key = 'Z', .ctrl = true}));
    EXPECT_EQ(parseKeyChord("Ctrl+Shift+Alt+Left"),
              (KeyChord{.key = kKeyLeft, .ctrl = true, .shift = true, .alt = true}));
    EXPECT_EQ(parseKeyChord("Ctrl+="), (KeyChord{.key = '=', .ctrl = true}));
    EXPECT_EQ(parseKeyChord("LeftCtrl"), (KeyChord{.key = kKeyLeftCtrl}));
}

TEST(Keys, ModifiersComeInAnyOrderAndCase) {
    EXPECT_EQ(parseKeyChord("shift+CTRL+pageup"), parseKeyChord("Ctrl+Shift+PageUp"));
    EXPECT_EQ(parseKeyChord("z"), parseKeyChord("Z"));
}

TEST(Keys, EveryNamedKeyReadsBackAsItself) {
    int named = 0;
    for (int key = 0; key < 512; ++key) {
        std::string text;
        try {
            text = format({.key = key, .shift = true});
        } catch (const InternalError&) {
            continue;
        }
        ++named;
        EXPECT_EQ(parseKeyChord(text), (KeyChord{.key = key, .shift = true})) << text;
    }
    EXPECT_EQ(named, 26 + 10 + 25 + 10 + 12 + 19 + 6 + 9); // letters … keypad signs, modifiers and Menu
}

TEST(Keys, AChordIsSpelledInOneWay) {
    EXPECT_EQ(format(parseKeyChord("alt+shift+ctrl+end")), "Ctrl+Shift+Alt+End");
    EXPECT_EQ(format({.key = kKeyPad0 + 7}), "Keypad7");
    EXPECT_EQ(format({.key = kKeyF25}), "F25");
}

TEST(Keys, WhatNamesNoKeyIsAnInputError) {
    for (const char* text :
         {"", "Ctrl", "Ctrl+", "+", "Ctrl++Z", "Hyper+Z", "F0", "F26", "Z+Ctrl", "ä", " Space"})
        EXPECT_THROW(parseKeyChord(text), InputError) << text;
}

TEST(Keys, AKeyWithoutANameCannotBeSpelled) { EXPECT_THROW(format({.key = 1}), InternalError); }

}
}
