#include "core/scene/gltf_files.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/scene/base64.h"

namespace eyeray {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kDataScheme = "data:";

[[noreturn]] void refuse(const std::string& where, std::string_view uri, const std::string& why) {
    throw InputError{where, fmt::format("its uri \"{}\" {}", printable(uri, 80), why),
                     "put the file into the scene's folder and name it there"};
}

std::string percentDecoded(std::string_view uri, const std::string& where) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            result += uri[i];
            continue;
        }
        unsigned code = 0;
        const char* const begin = uri.data() + i + 1;
        if (uri.size() - i < 3 || std::from_chars(begin, begin + 2, code, 16).ptr != begin + 2)
            refuse(where, uri, "has a broken percent code");
        result += static_cast<char>(code);
        i += 2;
    }
    return result;
}

/// RFC 3986, section 3.1: a letter, then letters, digits, + - . up to a colon.
bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    const auto inScheme = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' ||
               c == '-' || c == '.';
    };
    return colon != std::string_view::npos && colon > 0 &&
           std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), inScheme);
}

std::vector<std::byte> readDataUri(std::string_view uri, std::size_t maxBytes, const std::string& where) {
    constexpr std::string_view kBase64 = ";base64";
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(kBase64))
        throw InputError{where, "its data URI is not Base64", "export it again"};
    const std::string_view text = uri.substr(comma + 1);
    if (text.size() / 4 * 3 > maxBytes)
        throw InputError{where, fmt::format("holds more than {} bytes", maxBytes), "split the scene"};
    auto bytes = decodeBase64(text);
    if (!bytes) throw InputError{where, "its data URI is not Base64", "export it again"};
    return std::move(*bytes);
}

bool liesIn(const fs::path& folder, const fs::path& path) {
    const auto [end, at] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end() && at != path.end();
}

}

fs::path pathOfUri(std::string_view uri, const std::string& where) {
    if (uri.starts_with(kDataScheme)) return {};
    if (hasScheme(uri)) refuse(where, uri, "is not a relative path");
    const std::string name = percentDecoded(uri, where);
    if (name.empty()) refuse(where, uri, "is empty");
    if (name.find('\\') != std::string::npos || name.find('\0') != std::string::npos)
        refuse(where, uri, "has a backslash or a zero byte in it");
    const fs::path path(name);
    if (path.is_absolute()) refuse(where, uri, "is not a relative path");
    if (std::find(path.begin(), path.end(), "..") != path.end())
        refuse(where, uri, "leads out of the scene's folder");
    return path;
}

std::vector<std::byte> GltfFiles::read(std::string_view uri, std::size_t maxBytes,
                                       const std::string& where) const {
    const fs::path relative = pathOfUri(uri, where);
    if (relative.empty()) return readDataUri(uri, maxBytes, where);
    if (!folder_) refuse(where, uri, "names a file, but the scene was not read from one");

    std::error_code error;
    const fs::path folder = fs::canonical(folder_->empty() ? "." : *folder_, error);
    const fs::path path = error ? fs::path() : fs::weakly_canonical(folder / relative, error);
    if (error) refuse(where, uri, "cannot be followed: " + error.message());
    if (!liesIn(folder, path)) refuse(where, uri, "leads out of the scene's folder");
    if (!fs::is_regular_file(path, error)) refuse(where, uri, "is missing, or no regular file");
    return readFile(path, maxBytes);
}

}
