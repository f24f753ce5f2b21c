#pragma once
// The bytes behind the URIs of a scene file.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eyeray {

/// Reads data URIs, and files that lie in the scene's own folder or below: nothing else, whatever the URI
/// or a symbolic link says.
class GltfFiles {
public:
    /// No folder: only data URIs can be read.
    explicit GltfFiles(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

    /// The bytes that a URI stands for. Throws InputError naming `where` if there are more than `maxBytes`
    /// or they cannot be had.
    std::vector<std::byte> read(std::string_view uri, std::size_t maxBytes, const std::string& where) const;

private:
    std::optional<std::filesystem::path> folder_;
};

/// The relative path that a URI names, with percent codes replaced; empty for a data URI. Throws InputError
/// for other schemes, absolute paths, and whatever would lead out of the folder.
std::filesystem::path pathOfUri(std::string_view uri, const std::string& where);

}
