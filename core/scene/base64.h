#pragma once
// Base64 (RFC 4648, section 4), for data URIs.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eyeray {

/// The bytes that the text stands for, or nothing if it is not Base64. Padding may be missing.
std::optional<std::vector<std::byte>> decodeBase64(std::string_view text);

/// The text that stands for the bytes, with padding.
std::string encodeBase64(std::span<const std::byte> bytes);

}
