#pragma once
// Comma-separated values: RFC 4180.

#include <string>

namespace eyeray {

/// A cell that holds this text.
inline std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

}
