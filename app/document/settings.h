#pragma once
// The table of everything that `set key=value` changes; panels, command line and metadata are made from it.

#include <span>
#include <string>
#include <string_view>

#include "app/document/document.h"

namespace eyeray {

struct Setting {
    std::string_view key;
    std::string_view help; // one line, with unit and range
    std::string (*get)(const Document&);
    /// Throws InputError if the command's value for `key` is not one.
    void (*set)(Document&, const Command&, std::string_view key);
};

std::span<const Setting> settings();

/// Throws InputError naming the known keys.
const Setting& settingNamed(std::string_view key);

}
