#pragma once
// Any bytes as lines of commands and of rays.

#include <span>

#include "app/document/command.h"
#include "core/study/hit_lines.h"
#include "tests/fuzz/accepted.h"

namespace eyeray::fuzz {

inline void command(std::string_view line) {
    accepted([&] {
        const Command parsed = Command::parse(line);
        ENSURE(Command::parse(parsed.text()) == parsed);
    });
}

inline void ray(std::string_view line) {
    accepted([&] {
        if (const auto parsed = parseRayLine(line, 1)) ENSURE(isFinite(parsed->origin) && parsed->tMin >= 0);
    });
}

/// Each line is refused with an InputError, or says the same when written again.
inline void lines(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        command(text.substr(0, end));
        ray(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

}
