#pragma once
// Keys and their names in text, the same for window, headless input, command table and help page.

#include <cstdint>
#include <string>
#include <string_view>

namespace eyeray {

/// Keys are numbered as GLFW does, so that a window's events need no translation. Letters and digits are
/// their capital ASCII character, 'A' or '7'. They fit ImGuiIO::KeysDown.
enum Key : std::uint16_t {
    kKeySpace = 32,
    kKeyEscape = 256,
    kKeyEnter,
    kKeyTab,
    kKeyBackspace,
    kKeyInsert,
    kKeyDelete,
    kKeyRight,
    kKeyLeft,
    kKeyDown,
    kKeyUp,
    kKeyPageUp,
    kKeyPageDown,
    kKeyHome,
    kKeyEnd,
    kKeyCapsLock = 280,
    kKeyScrollLock,
    kKeyNumLock,
    kKeyPrintScreen,
    kKeyPause,
    kKeyF1 = 290,
    kKeyF25 = 314,
    kKeyPad0 = 320,
    kKeyPad9 = 329,
    kKeyPadDecimal,
    kKeyPadDivide,
    kKeyPadMultiply,
    kKeyPadSubtract,
    kKeyPadAdd,
    kKeyPadEnter,
    kKeyLeftShift = 340,
    kKeyLeftCtrl,
    kKeyLeftAlt,
    kKeyLeftSuper,
    kKeyRightShift,
    kKeyRightCtrl,
    kKeyRightAlt,
    kKeyRightSuper,
    kKeyMenu,
};

/// Whether the key is Shift, Ctrl, Alt or Super, of either side.
constexpr bool isModifier(int key) { return key >= kKeyLeftShift && key <= kKeyRightSuper; }

/// A key with the modifiers held when it goes down.
struct KeyChord {
    int key = 0;
    bool ctrl = false, shift = false, alt = false;
    friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// Reads "Space", "F1", "Ctrl+Shift+Z", "Alt+=": modifiers in any order, upper and lower case alike.
/// Throws InputError when it names no key.
KeyChord parseKeyChord(std::string_view text);

/// The one spelling of a chord: modifiers in the order Ctrl, Shift, Alt. Throws InternalError for a key
/// without a name.
std::string format(const KeyChord& chord);

}
