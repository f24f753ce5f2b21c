// labels: e2e
// The program short of memory, and killed while it writes (stability 4.4, 4.7): a message or a whole picture,
// never half of one.

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/sampling.h"
#include "core/image/decode.h"
#include "tests/app_process.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

class Limits : public testing::Test {
protected:
    Process run(const std::string& program, std::vector<std::string> arguments) const {
        return {program, std::move(arguments), folder.path(), {"HOME=" + folder.path().string()}};
    }

    ByteImage picture() const {
        const std::string bytes = textOf(folder / "picture.png");
        return decodeImage(std::as_bytes(std::span(bytes)), "picture.png").pixels;
    }

    TemporaryFolder folder;
};

TEST_F(Limits, ShortOfMemoryItSaysSoOrRendersTheWholePicture) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers take terabytes of addresses";
#endif
    int refused = 0, rendered = 0;
    for (const int megabytes : {350, 400, 450, 500, 600, 700, 900, 1200, 1600, 3000}) {
        fs::remove(folder / "picture.png");
        Process limited = run(
            "sh",
            {"-c", fmt::format("ulimit -v {} && exec {} render phong -o picture.png --width 3000 --height "
                               "2000 --samples 1 --threads 2",
                               megabytes * 1024, EYERAY_BINARY_DIR "/eyeray")});
        const int code = limited.wait();
        const std::string said = limited.err();
        if (code == 0) {
            ++rendered;
            EXPECT_EQ(picture().width(), 3000);
            continue;
        }
        ++refused;
        EXPECT_EQ(code, 1) << megabytes << " MB: " << said;
        EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
        EXPECT_NE(said.find("memory"), std::string::npos) << said;
        EXPECT_EQ(std::ranges::count(said, ':'), 3) << "eyeray: what: what is wrong: what to do: " << said;
        EXPECT_FALSE(fs::exists(folder / "picture.png")) << megabytes;
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(rendered, 0);
}

TEST_F(Limits, KilledAtAnyTimeItLeavesTheOldPictureOrTheNewOne) {
    const std::vector<std::string> small = {"render", "phong", "-o", "picture.png", "--width", "320"};
    const auto render = [&](const char* samples) {
        std::vector<std::string> arguments = small;
        arguments.insert(arguments.end(), {"--samples", samples});
        return run(EYERAY_BINARY_DIR "/eyeray", arguments);
    };
    ASSERT_EQ(render("2").wait(), 0);
    const std::string newer = textOf(folder / "picture.png");
    ASSERT_EQ(render("1").wait(), 0);
    const std::string older = textOf(folder / "picture.png");
    ASSERT_NE(older, newer);
    for (std::uint32_t i = 0; i < 100; ++i) {
        {
            const Process killed = render("2"); // its destructor kills it
            std::this_thread::sleep_for(std::chrono::microseconds(hash32(i) % 100'000));
        }
        const std::string left = textOf(folder / "picture.png");
        EXPECT_TRUE(left == older || left == newer) << left.size() << " bytes";
    }
}

}
}
