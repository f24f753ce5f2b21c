#pragma once
// One table makes keys, menus, the help page and the README's list of keys.

#include <span>
#include <string_view>

namespace eyeray {

struct Action {
    std::string_view menu; // where it stands; empty: in no menu
    std::string_view label;
    std::string_view chord;   // as parseKeyChord reads it; empty: no key
    std::string_view command; // the line that it carries out
};

std::span<const Action> actions();

/// What the mouse does over the picture, and keys that are held: for the help page and the README.
struct Gesture {
    std::string_view what, does;
};
std::span<const Gesture> gestures();

}
