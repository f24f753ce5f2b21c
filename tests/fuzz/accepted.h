#pragma once

#include <string_view>

#include "core/base/errors.h"

namespace eyeray::fuzz {

/// Whether the parser took what it was given; a refusal is an InputError of one line.
template <class Parse>
bool accepted(const Parse& parse) {
    try {
        parse();
        return true;
    } catch (const InputError& error) {
        ENSURE(std::string_view(error.what()).find('\n') == std::string_view::npos);
        return false;
    }
}

}
