#pragma once
// Open files of the system: what reading and writing whole files share.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace eyeray {

/// Owns a descriptor; closes it when it goes.
class FileDescriptor {
public:
    /// Takes over the result of open(): negative for a failed one.
    explicit FileDescriptor(int number) : number_(number) {}
    FileDescriptor(FileDescriptor&& other) noexcept;
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    ~FileDescriptor();

    bool isOpen() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Bytes in the file as the system says it; 0 where it does not know.
    std::size_t size() const;
    /// Closes now; false with errno set if the system reports a late write error.
    bool close();

private:
    int number_;
};

/// The system's words for an errno value: "No space left on device".
std::string systemReason(int error);

/// A regular file open for reading. Never waits, whatever the path names.
/// Throws InputError for a folder, a pipe or a device, and for what is missing or may not be read.
FileDescriptor openForReading(const std::filesystem::path& path);

/// Fills `buffer` from the file as far as it goes and returns the number of bytes; less than asked means the
/// end. Throws InputError naming `path` when the disk fails.
std::size_t readInto(const FileDescriptor& file, std::span<std::byte> buffer,
                     const std::filesystem::path& path);

}
