#include "app/platform/keys.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

struct NamedKey {
    std::string_view name;
    int key;
};

// Letters, digits, function keys and the digits of the keypad follow rules; these are all others.
constexpr std::array kNamedKeys = {
    NamedKey{"Space", kKeySpace},
    NamedKey{"'", '\''},
    NamedKey{",", ','},
    NamedKey{"-", '-'},
    NamedKey{".", '.'},
    NamedKey{"/", '/'},
    NamedKey{";", ';'},
    NamedKey{"=", '='},
    NamedKey{"[", '['},
    NamedKey{"\\", '\\'},
    NamedKey{"]", ']'},
    NamedKey{"`", '`'},
    NamedKey{"Escape", kKeyEscape},
    NamedKey{"Enter", kKeyEnter},
    NamedKey{"Tab", kKeyTab},
    NamedKey{"Backspace", kKeyBackspace},
    NamedKey{"Insert", kKeyInsert},
    NamedKey{"Delete", kKeyDelete},
    NamedKey{"Right", kKeyRight},
    NamedKey{"Left", kKeyLeft},
    NamedKey{"Down", kKeyDown},
    NamedKey{"Up", kKeyUp},
    NamedKey{"PageUp", kKeyPageUp},
    NamedKey{"PageDown", kKeyPageDown},
    NamedKey{"Home", kKeyHome},
    NamedKey{"End", kKeyEnd},
    NamedKey{"CapsLock", kKeyCapsLock},
    NamedKey{"ScrollLock", kKeyScrollLock},
    NamedKey{"NumLock", kKeyNumLock},
    NamedKey{"PrintScreen", kKeyPrintScreen},
    NamedKey{"Pause", kKeyPause},
    NamedKey{"KeypadDecimal", kKeyPadDecimal},
    NamedKey{"KeypadDivide", kKeyPadDivide},
    NamedKey{"KeypadMultiply", kKeyPadMultiply},
    NamedKey{"KeypadSubtract", kKeyPadSubtract},
    NamedKey{"KeypadAdd", kKeyPadAdd},
    NamedKey{"KeypadEnter", kKeyPadEnter},
    NamedKey{"LeftShift", kKeyLeftShift},
    NamedKey{"LeftCtrl", kKeyLeftCtrl},
    NamedKey{"LeftAlt", kKeyLeftAlt},
    NamedKey{"LeftSuper", kKeyLeftSuper},
    NamedKey{"RightShift", kKeyRightShift},
    NamedKey{"RightCtrl", kKeyRightCtrl},
    NamedKey{"RightAlt", kKeyRightAlt},
    NamedKey{"RightSuper", kKeyRightSuper},
    NamedKey{"Menu", kKeyMenu},
};

std::string nameOf(int key) {
    if ((key >= 'A' && key <= 'Z') || (key >= '0' && key <= '9')) return {static_cast<char>(key)};
    if (key >= kKeyF1 && key <= kKeyF25) return fmt::format("F{}", key - kKeyF1 + 1);
    if (key >= kKeyPad0 && key <= kKeyPad9) return fmt::format("Keypad{}", key - kKeyPad0);
    const auto* const found = std::ranges::find(kNamedKeys, key, &NamedKey::key);
    return found == kNamedKeys.end() ? std::string{} : std::string(found->name);
}

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool sameText(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

std::optional<int> keyNamed(std::string_view name) {
    if (name.empty()) return std::nullopt;
    for (int key = kKeySpace; key <= kKeyMenu; ++key)
        if (sameText(nameOf(key), name)) return key;
    return std::nullopt;
}

/// Whether `text` begins with `modifier` and a plus, which are then cut off.
bool takeModifier(std::string_view& text, std::string_view modifier) {
    if (text.size() <= modifier.size() || text[modifier.size()] != '+' ||
        !sameText(text.substr(0, modifier.size()), modifier))
        return false;
    text.remove_prefix(modifier.size() + 1);
    return true;
}

}

KeyChord parseKeyChord(std::string_view text) {
    KeyChord chord;
    std::string_view rest = text;
    for (;;) {
        if (takeModifier(rest, "Ctrl"))
            chord.ctrl = true;
        else if (takeModifier(rest, "Shift"))
            chord.shift = true;
        else if (takeModifier(rest, "Alt"))
            chord.alt = true;
        else
            break;
    }
    const std::optional<int> key = keyNamed(rest);
    if (!key)
        throw InputError{fmt::format("key \"{}\"", text), "there is no such key",
                         "write it like Space, F1, Left, A or Ctrl+Shift+Z"};
    chord.key = *key;
    return chord;
}

std::string format(const KeyChord& chord) {
    const std::string name = nameOf(chord.key);
    ENSURE(!name.empty());
    return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl+" : "", chord.shift ? "Shift+" : "",
                       chord.alt ? "Alt+" : "", name);
}

}
