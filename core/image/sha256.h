#pragma once
// The SHA-256 of scenes, which pictures carry to find their scene again.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace eyeray {

/// 64 lower-case hexadecimal digits. FIPS 180-4, "Secure Hash Standard".
std::string sha256Hex(std::span<const std::byte> bytes);

/// The same of a file's content, read in pieces. Throws InputError for whatever is no readable regular file.
std::string sha256HexOfFile(const std::filesystem::path& path);

}
