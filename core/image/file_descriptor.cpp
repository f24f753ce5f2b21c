#include "core/image/file_descriptor.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

[[noreturn]] void cannotBeRead(const std::filesystem::path& path, int error) {
    throw InputError{path.native(), "cannot be read: " + systemReason(error),
                     "check its name and its permissions"};
}

}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_); // what was open here is closed with `other`
    return *this;
}

FileDescriptor::~FileDescriptor() {
    if (isOpen()) ::close(number_);
}

std::size_t FileDescriptor::size() const {
    struct stat status{};
    return ::fstat(number_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

bool FileDescriptor::close() {
    // Linux has closed the file even when a signal interrupts.
    return ::close(std::exchange(number_, -1)) == 0 || errno == EINTR;
}

std::string systemReason(int error) { return std::generic_category().message(error); }

FileDescriptor openForReading(const std::filesystem::path& path) {
    if (path.native().find('\0') != std::string::npos) // the system would read the part before it
        throw InputError{path.native(), "has a zero byte in its name", "correct the name"};
    // O_NONBLOCK: a pipe that nobody writes to must not hold us up.
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status{};
    if (!file.isOpen() || ::fstat(file.number(), &status) != 0) cannotBeRead(path, errno);
    if (S_ISDIR(status.st_mode)) throw InputError{path.native(), "is a folder", "give the name of a file"};
    if (!S_ISREG(status.st_mode))
        throw InputError{path.native(), "is not a regular file", "copy its content to a file and give that"};
    return file;
}

std::size_t readInto(const FileDescriptor& file, std::span<std::byte> buffer,
                     const std::filesystem::path& path) {
    std::size_t filled = 0;
    while (filled < buffer.size()) {
        const ssize_t count = ::read(file.number(), buffer.data() + filled, buffer.size() - filled);
        if (count == 0) break;
        if (count > 0)
            filled += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            cannotBeRead(path, errno);
    }
    return filled;
}

}
