// labels: unit robustness
// `eyeray hits` as a program: rays on standard input, answers on standard output.

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/image/atomic_file.h"
#include "tests/app_process.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

class Hits : public testing::Test {
protected:
    struct Said {
        int code;
        std::string out, err;
    };

    Said hits(const std::string& lines, std::vector<std::string> arguments = {"homage"}) const {
        writeFileAtomically(folder / "rays", std::as_bytes(std::span(lines)));
        arguments.insert(arguments.begin(), "hits");
        Process process(EYERAY_BINARY_DIR "/eyeray", std::move(arguments), folder.path(),
                        {"HOME=" + folder.path().string()}, folder / "rays");
        const int code = process.wait();
        return {code, process.out(), process.err()};
    }

    TemporaryFolder folder;
};

std::string randomRays(int count) {
    cases::Random random(1);
    std::string lines;
    for (int i = 0; i < count; ++i) {
        const DVec3 o = random.inCube(4), d = random.direction();
        lines += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", o.x, o.y, o.z, d.x, d.y, d.z);
    }
    return lines;
}

TEST_F(Hits, AreTheSameInOrderByAnyAcceleratorOnAnyNumberOfThreads) {
    const std::string lines = randomRays(50'000); // more than one block for a thread
    const Said one = hits(lines, {"homage", "--threads", "1", "--accel", "brute"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(one.err, "");
    EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 50'000);
    for (const char* accel : {"auto", "bvh2", "bvh8"})
        EXPECT_EQ(hits(lines, {"homage", "--threads", "3", "--accel", accel}).out, one.out) << accel;
    for (const char* question : {"--any", "--spawn"})
        EXPECT_EQ(hits(lines, {"homage", "--threads", "3", question}).out,
                  hits(lines, {"homage", "--threads", "1", question}).out);
}

TEST_F(Hits, AWrongLineIsNamedAndThoseBeforeItAreAnswered) {
    const std::string lines = randomRays(20'000);
    const std::string before = hits(lines).out;
    const Said said = hits("# rays\n\n" + lines + "1 2 three\n" + lines, {"homage", "--threads", "3"});
    EXPECT_EQ(said.code, 2);
    EXPECT_EQ(said.out, before);
    EXPECT_EQ(said.err, "eyeray: rays: line 20003: \"three\" is not a number: write ox oy oz dx dy dz [tmin "
                        "tmax]\n");
}

TEST_F(Hits, OfNoRaysAreNone) {
    EXPECT_EQ(hits("").out, "");
    EXPECT_EQ(hits("").code, 0);
    EXPECT_EQ(hits("0 5 0 0 -1 0").out, hits("0 5 0 0 -1 0\n").out) << "the last line break may lack";
}

TEST_F(Hits, ALineWithoutEndIsRefused) {
    const Said said = hits(std::string(5U << 20U, '1'));
    EXPECT_EQ(said.code, 2);
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
}

TEST_F(Hits, OneQuestionIsAskedAtATime) { EXPECT_EQ(hits("", {"homage", "--any", "--spawn"}).code, 2); }

}
}
