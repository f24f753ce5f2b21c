// labels: unit robustness
// What the fuzzers begin with, and what they have found, does no harm. tests/fuzz/README.md says how to fuzz.

#include <filesystem>

#include <gtest/gtest.h>

#include "app/document/command.h"
#include "core/image/atomic_file.h"
#include "tests/fuzz/lines.h"
#include "tests/fuzz/picture.h"
#include "tests/fuzz/scene.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

/// Gives each file of a folder to a fuzzer's target; the target ends the program or throws where it finds
/// harm.
template <class Target>
void replay(const fs::path& folder, const Target& target) {
    int files = 0;
    for (const auto& file : fs::directory_iterator(fs::path(EYERAY_SOURCE_DIR) / folder)) {
        SCOPED_TRACE(file.path());
        EXPECT_NO_THROW(target(readFile(file.path(), 1U << 26U)));
        ++files;
    }
    EXPECT_GT(files, 0) << folder;
}

TEST(FuzzCorpus, OfScenesDoesNoHarm) {
    replay("tests/corpus/scene", fuzz::scene);
    replay("assets/scenes", fuzz::scene);
}

TEST(FuzzCorpus, OfPicturesDoesNoHarm) {
    replay("tests/corpus/picture", fuzz::picture);
    replay("tests/golden", fuzz::picture);
}

TEST(FuzzCorpus, OfLinesDoesNoHarm) { replay("tests/corpus/lines", fuzz::lines); }

}
}
