#include "core/image/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/errors.h"
#include "core/image/file_descriptor.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 255; // bytes in a file name on Linux
constexpr int kTemporaryNames = 100;      // names to try: other threads and a killed process may hold some

std::string remedyFor(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "free some space or choose another disk";
    case ENOENT:
        return "create its folder first";
    case ENOTDIR:
        return "a part of its path is a file: choose another folder";
    case ENAMETOOLONG:
        return "choose a shorter name";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a folder that you may write to";
    default:
        return "choose another place";
    }
}

[[noreturn]] void cannotBeWritten(const fs::path& path, int error) {
    throw Failure{path.native(), "cannot be written: " + systemReason(error), remedyFor(error)};
}

void writeAll(const FileDescriptor& file, std::span<const std::byte> bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
        if (count >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            cannotBeWritten(path, errno);
    }
}

bool namesStandardStream(const fs::path& path) {
    return path == "/dev/stdout" || path == "/dev/stderr" || path.parent_path() == "/dev/fd";
}

void writeDirectly(const fs::path& path, std::span<const std::byte> bytes) {
    // O_APPEND: standard output may be a file with something in it already.
    FileDescriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
    if (!file.isOpen()) cannotBeWritten(path, errno);
    writeAll(file, bytes, path);
    if (!file.close()) cannotBeWritten(path, errno);
}

/// "picture.png" + ".tmp-123", the name cut between two characters where the whole would be too long.
std::string temporaryName(std::string name, int attempt) {
    const std::string ending =
        attempt == 0 ? fmt::format(".tmp-{}", ::getpid()) : fmt::format(".tmp-{}-{}", ::getpid(), attempt);
    if (name.size() + ending.size() > kLongestName) {
        std::size_t length = kLongestName - ending.size();
        while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0U) == 0x80U)
            --length; // inside UTF-8
        name.resize(length);
    }
    return name + ending;
}

/// A new file beside `target`, deleted at the end of its scope unless it has taken the target's name.
class TemporaryFile {
public:
    /// `path` is what messages name: the target as the user gave it.
    TemporaryFile(const fs::path& target, const fs::path& path) : target_(target), path_(path) {
        for (int attempt = 0; !file_.isOpen() && attempt < kTemporaryNames; ++attempt) {
            name_ = target.parent_path() / temporaryName(target.filename(), attempt);
            file_ = FileDescriptor(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            if (!file_.isOpen() && errno != EEXIST) break;
        }
        if (!file_.isOpen()) cannotBeWritten(path_, errno);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_) ::unlink(name_.c_str());
    }

    void setMode(mode_t mode) const {
        if (::fchmod(file_.number(), mode & 07777U) != 0) cannotBeWritten(path_, errno);
    }

    void fill(std::span<const std::byte> bytes) {
        writeAll(file_, bytes, path_);
        // EINVAL: a file system that has no such call, where closing must do.
        if (::fsync(file_.number()) != 0 && errno != EINVAL) cannotBeWritten(path_, errno);
        if (!file_.close()) cannotBeWritten(path_, errno);
    }

    void takeName() {
        if (::rename(name_.c_str(), target_.c_str()) != 0) cannotBeWritten(path_, errno);
        renamed_ = true;
    }

private:
    const fs::path& target_;
    const fs::path& path_;
    fs::path name_;
    FileDescriptor file_{-1};
    bool renamed_ = false;
};

/// Makes a rename last through a power cut. Where the system cannot, the file is whole all the same.
void syncFolder(const fs::path& folder) {
    const FileDescriptor directory(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.isOpen()) ::fsync(directory.number());
}

/// The file that a chain of symbolic links leads to, so that the links stay.
fs::path behindLinks(const fs::path& path) {
    std::error_code ignored;
    const fs::path real = fs::canonical(path, ignored);
    return real.empty() ? path : real;
}

}

void writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
    struct stat old{};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) cannotBeWritten(path, errno);
    if (exists ? S_ISDIR(old.st_mode) : path.filename().empty())
        throw Failure{path.native(), "is a folder", "give the name of a file in it"};
    if (exists && (!S_ISREG(old.st_mode) || namesStandardStream(path))) return writeDirectly(path, bytes);
    // A rename would replace even a file that is write-protected.
    if (exists && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) cannotBeWritten(path, errno);

    const fs::path target = exists ? behindLinks(path) : path;
    TemporaryFile temporary(target, path);
    if (exists) temporary.setMode(old.st_mode);
    temporary.fill(bytes);
    temporary.takeName();
    syncFolder(target.parent_path());
}

std::vector<std::byte> readFile(const fs::path& path, std::size_t maxBytes) {
    const FileDescriptor file = openForReading(path);
    std::vector<std::byte> bytes;
    const std::size_t expected = file.size();
    std::size_t size = 0;
    do {
        if (std::max(expected, size) > maxBytes)
            throw InputError{path.native(), fmt::format("is larger than {} bytes", maxBytes),
                             "give a smaller file"};
        // Room for one byte more than expected shows a file that grows, or one in /proc that hides its size.
        bytes.resize(std::min(std::max(expected, 2 * size), maxBytes) + 1);
        size += readInto(file, std::span(bytes).subspan(size), path);
    } while (size == bytes.size());
    bytes.resize(size);
    return bytes;
}

}
