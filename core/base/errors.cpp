#include "core/base/errors.h"

#include <fmt/format.h>

namespace eyeray {

Error::Error(std::string where, const std::string& what, const std::string& remedy)
    : std::runtime_error(
          fmt::format("{}: {}: {}", printable(where, 400), printable(what, 400), printable(remedy, 400))),
      where_(std::move(where)) {}

std::string printable(std::string_view text, std::size_t limit) {
    constexpr std::size_t kContinuations = 3; // most bytes that UTF-8 adds to a character's first
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool amidCharacter = (byte & 0xc0U) == 0x80U && result.size() < limit + kContinuations;
        if (result.size() >= limit && !amidCharacter) return result + "…";
        if (byte < 0x20 || byte == 0x7f)
            result += fmt::format("\\x{:02x}", byte);
        else
            result += c;
    }
    return result;
}

void detail::ensureFailed(const char* condition, const char* file, int line) {
    throw InternalError(fmt::format("{}:{}: does not hold: {}", file, line, condition));
}

}
