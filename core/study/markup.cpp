#include "core/study/markup.h"

namespace eyeray {
namespace {

bool continues(std::string_view text, std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80;
}

/// Bytes of the UTF-8 character that begins at i; 0 if none does (RFC 3629, section 4).
std::size_t characterAt(std::string_view text, std::size_t i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) return byte >= 0x20 || byte == '\n' || byte == '\t' ? 1 : 0;
    const std::size_t bytes = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
    if (byte < 0xC2 || byte > 0xF4) return 0;
    for (std::size_t k = 1; k < bytes; ++k)
        if (!continues(text, i + k)) return 0;
    const auto second = static_cast<unsigned char>(text[i + 1]);
    const bool overlong = (byte == 0xE0 && second < 0xA0) || (byte == 0xF0 && second < 0x90);
    const bool surrogate = byte == 0xED && second >= 0xA0, beyond = byte == 0xF4 && second >= 0x90;
    return overlong || surrogate || beyond ? 0 : bytes;
}

}

std::string escaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t bytes = characterAt(text, i);
        if (text[i] == '<')
            result += "&lt;";
        else if (text[i] == '>')
            result += "&gt;";
        else if (text[i] == '&')
            result += "&amp;";
        else if (text[i] == '"')
            result += "&quot;";
        else
            result += text.substr(i, bytes);
        i += bytes == 0 ? 1 : bytes;
    }
    return result;
}

}
