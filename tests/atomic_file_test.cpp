// Files are written whole or not at all, and reading refuses whatever is no plain file.
// labels: unit robustness

#include "core/image/atomic_file.h"

#include <csignal>
#include <cstring>
#include <functional>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/errors.h"
#include "core/image/sha256.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

void setMode(const fs::path& path, mode_t mode) { ASSERT_EQ(chmod(path.c_str(), mode), 0); }

std::size_t entriesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// The one line of the error that the job must end with.
template <class Expected>
std::string errorOf(const std::function<void()>& job) {
    try {
        job();
    } catch (const Expected& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error of the expected kind";
    return {};
}

std::string failureOfWriting(const fs::path& path, const std::string& text = "new") {
    return errorOf<Failure>([&] { writeFileAtomically(path, bytesOf(text)); });
}

std::string errorOfReading(const fs::path& path, std::size_t maxBytes = 1000) {
    return errorOf<InputError>([&] { readFile(path, maxBytes); });
}

/// No file may grow over `bytes` while this lives: a disk that fills up in the middle of a write.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

private:
    rlimit old_{};
    void (*oldHandler_)(int);
};

/// Root may do anything: a test of permissions gives its rights up while this lives.
class WithoutRootRights {
public:
    WithoutRootRights() {
        if (user_ == 0 && seteuid(65534) != 0) throw std::runtime_error("cannot drop root's rights");
    }
    WithoutRootRights(const WithoutRootRights&) = delete;
    WithoutRootRights& operator=(const WithoutRootRights&) = delete;
    ~WithoutRootRights() {
        if (seteuid(user_) != 0) std::abort();
    }

private:
    uid_t user_ = geteuid();
};

TEST(AtomicFile, WritesANewFileAndReadsItBack) {
    const TemporaryFolder folder;
    std::string text(300'000, 'x');
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * 31 % 251);
    writeFileAtomically(folder / "picture.png", bytesOf(text));
    const std::vector<std::byte> read = readFile(folder / "picture.png", text.size());
    ASSERT_EQ(read.size(), text.size());
    EXPECT_EQ(std::memcmp(read.data(), text.data(), text.size()), 0);
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

TEST(AtomicFile, ReplacesAnOldFileAndKeepsItsMode) {
    const TemporaryFolder folder;
    writeText(folder / "a", "a longer old text");
    setMode(folder / "a", 0640);
    writeFileAtomically(folder / "a", bytesOf("new"));
    EXPECT_EQ(textOf(folder / "a"), "new");
    struct stat status{};
    stat((folder / "a").c_str(), &status);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(AtomicFile, WritesAnEmptyFileAndOneInTheWorkingFolder) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    writeFileAtomically("empty", {});
    fs::current_path(before);
    EXPECT_TRUE(fs::is_empty(folder / "empty"));
}

TEST(AtomicFile, ALinkStaysALinkAndItsFileIsReplaced) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    writeText(folder / "real/a", "old");
    fs::create_symlink("real/a", folder / "link");
    writeFileAtomically(folder / "link", bytesOf("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(textOf(folder / "real/a"), "new");
}

TEST(AtomicFile, NamesOf255BytesAndInUtf8Work) {
    const TemporaryFolder folder;
    std::string russian = "p"; // so that the cut falls inside a character for one of the two
    while (russian.size() + 2 <= 255) russian += "ж";
    for (const std::string& name :
         {std::string(255, 'n'), russian, "x" + russian.substr(1, 252), std::string("影.png")}) {
        writeFileAtomically(folder / name, bytesOf(name));
        EXPECT_EQ(textOf(folder / name), name);
    }
    EXPECT_EQ(entriesIn(folder.path()), 4U);
    EXPECT_NE(failureOfWriting(folder / std::string(256, 'n')).find("File name too long"), std::string::npos);
}

TEST(AtomicFile, AStaleTemporaryFileIsNoObstacleAndNoLinkIsFollowed) {
    const TemporaryFolder folder;
    writeText(folder / "victim", "untouched");
    fs::create_symlink(folder / "victim", folder / ("a.tmp-" + std::to_string(getpid())));
    writeFileAtomically(folder / "a", bytesOf("new"));
    EXPECT_EQ(textOf(folder / "a"), "new");
    EXPECT_EQ(textOf(folder / "victim"), "untouched");
    EXPECT_EQ(entriesIn(folder.path()), 3U);
}

TEST(AtomicFile, WritersAtTheSameTimeLeaveTheWholeFileOfOneOfThem) {
    const TemporaryFolder folder;
    {
        std::vector<std::jthread> writers;
        for (char letter = 'a'; letter < 'i'; ++letter)
            writers.emplace_back([&, letter] {
                for (int i = 0; i < 5; ++i)
                    writeFileAtomically(folder / "f", bytesOf(std::string(50'000, letter)));
            });
    }
    const std::string text = textOf(folder / "f");
    ASSERT_EQ(text.size(), 50'000U);
    EXPECT_EQ(text.find_first_not_of(text[0]), std::string::npos);
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

TEST(AtomicFile, AWriteThatFailsHalfwayKeepsTheOldFileAndLeavesNothing) {
    const TemporaryFolder folder;
    writeText(folder / "a", "old");
    std::string message;
    {
        const FileSizeLimit limit(10'000);
        message = failureOfWriting(folder / "a", std::string(20'000, 'x'));
    }
    EXPECT_NE(message.find((folder / "a").native() + ": cannot be written: File too large: "),
              std::string::npos);
    EXPECT_EQ(textOf(folder / "a"), "old");
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

TEST(AtomicFile, AFullDeviceIsReportedAndStaysADevice) {
    EXPECT_EQ(failureOfWriting("/dev/full"), "/dev/full: cannot be written: No space left on device: "
                                             "free some space or choose another disk");
    const TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder / "full.png");
    EXPECT_NE(failureOfWriting(folder / "full.png").find("No space left on device"), std::string::npos);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_TRUE(fs::is_symlink(folder / "full.png"));
    EXPECT_NO_THROW(writeFileAtomically("/dev/null", bytesOf("gone")));
}

TEST(AtomicFile, APipeIsWrittenThrough) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::string received;
    {
        const std::jthread reader([&] { received = textOf(folder / "pipe"); });
        writeFileAtomically(folder / "pipe", bytesOf("through"));
    }
    EXPECT_EQ(received, "through");
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(AtomicFile, StandardOutputIsAppendedTo) {
    const TemporaryFolder folder;
    const int output = open((folder / "log").c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_EQ(write(output, "first ", 6), 6);
    writeFileAtomically("/dev/fd/" + std::to_string(output), bytesOf("second"));
    close(output);
    EXPECT_EQ(textOf(folder / "log"), "first second");
}

TEST(AtomicFile, SaysWhyAPlaceCannotBeWrittenTo) {
    const TemporaryFolder folder;
    writeText(folder / "file", "old");
    EXPECT_NE(failureOfWriting(folder.path()).find("is a folder"), std::string::npos);
    EXPECT_NE(failureOfWriting(folder / "new/").find("is a folder"), std::string::npos);
    EXPECT_NE(failureOfWriting(folder / "file/a").find("Not a directory"), std::string::npos);
    EXPECT_NE(failureOfWriting(folder / "missing/a").find("create its folder first"), std::string::npos);
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

TEST(AtomicFile, RespectsProtectedFilesAndFolders) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "closed");
    writeText(folder / "protected", "old");
    setMode(folder / "protected", 0444);
    setMode(folder.path(), 0777);
    setMode(folder / "closed", 0555);
    {
        const WithoutRootRights unprivileged;
        EXPECT_NE(failureOfWriting(folder / "protected").find("Permission denied"), std::string::npos);
        EXPECT_NE(failureOfWriting(folder / "closed/a").find("Permission denied"), std::string::npos);
    }
    EXPECT_EQ(textOf(folder / "protected"), "old");
    EXPECT_TRUE(fs::is_empty(folder / "closed"));
}

TEST(ReadFile, TakesAFileOfExactlyTheLimitAndRefusesALargerOne) {
    const TemporaryFolder folder;
    writeText(folder / "a", "12345");
    EXPECT_EQ(readFile(folder / "a", 5).size(), 5U);
    EXPECT_NE(errorOfReading(folder / "a", 4).find("is larger than 4 bytes"), std::string::npos);
}

TEST(ReadFile, ReadsAFileThatHidesItsSize) {
    EXPECT_GT(readFile("/proc/self/maps", 10'000'000).size(), 100U);
    EXPECT_NE(errorOfReading("/proc/self/maps", 10).find("is larger than 10 bytes"), std::string::npos);
}

TEST(ReadFile, RefusesWhatIsNoPlainFileWithoutWaiting) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_NE(errorOfReading(folder / "pipe").find("is not a regular file"), std::string::npos);
    EXPECT_NE(errorOfReading(folder.path()).find("is a folder"), std::string::npos);
    EXPECT_NE(errorOfReading("/dev/zero").find("is not a regular file"), std::string::npos);
    EXPECT_NE(errorOfReading(folder / "missing").find("No such file or directory"), std::string::npos);
    EXPECT_NE(errorOfReading("").find("No such file or directory"), std::string::npos);
    writeText(folder / "a", "secret");
    EXPECT_NE(errorOfReading((folder / "a").native() + std::string("\0.png", 5)).find("zero byte"),
              std::string::npos);
}

TEST(Sha256, KnownDigestsOfTheStandard) {
    EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256Hex(bytesOf("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256Hex(bytesOf(std::string(1'000'000, 'a'))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, AFileHasTheDigestOfItsBytes) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0U, 3U, 1U << 20U, 2'500'000U}) {
        const std::string text(size, 'q');
        writeText(folder / "a", text);
        EXPECT_EQ(sha256HexOfFile(folder / "a"), sha256Hex(bytesOf(text)));
    }
    EXPECT_THROW(sha256HexOfFile(folder / "missing"), InputError);
}

}
}
