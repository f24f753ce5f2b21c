#pragma once
// Whole files in and out: a reader never sees half a file under its real name.

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace eyeray {

/// Puts `bytes` under the name `path`, all of them or none: they go to a temporary file beside it,
/// NAME.tmp-PID, which takes the name once it is safely on disk. The mode of a file replaced is kept, and a
/// symbolic link stays one. What is there already and is no regular file (/dev/full, a pipe), and standard
/// output and error by their names under /dev, are written to directly. Throws Failure with the system's
/// reason; then the old file is as it was and no temporary file remains.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// All bytes of a regular file. Never waits on a pipe.
/// Throws InputError for one of more than `maxBytes`, and for whatever is no readable regular file.
std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maxBytes);

}
