// labels: unit
// eyeray compare, and rendering by the methods that draw at random, as a script uses them.

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "tests/app_process.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

struct Said {
    int code;
    std::string out, err;
};

class Comparing : public testing::Test {
protected:
    Said run(const std::vector<std::string>& arguments) const {
        Process process(EYERAY_BINARY_DIR "/eyeray", arguments, folder.path(),
                        {"HOME=" + folder.path().string(), "DISPLAY="});
        const int code = process.wait();
        return {code, process.out(), process.err()};
    }

    void render(const std::string& file, const std::string& method, const std::string& samples = "2",
                const std::string& seed = "0") const {
        const Said said = run({"render", "cornell", "-o", file, "--width", "48", "--height", "36", "--method",
                               method, "--samples", samples, "--seed", seed, "--stats", file + ".json"});
        ASSERT_EQ(said.code, 0) << said.err;
    }

    nlohmann::json compared(const std::string& a, const std::string& b) const {
        const Said said = run({"compare", a, b, "--json"});
        EXPECT_EQ(said.code, 0) << said.err;
        return nlohmann::json::parse(said.out);
    }

    nlohmann::json stats(const std::string& file) const {
        const auto bytes = readFile(folder / (file + ".json"), 1U << 20U);
        return nlohmann::json::parse(reinterpret_cast<const char*>(bytes.data()),
                                     reinterpret_cast<const char*>(bytes.data()) + bytes.size());
    }

    TemporaryFolder folder;
};

TEST_F(Comparing, APictureWithItselfAllIsZero) {
    render("a.png", "path");
    const auto json = compared("a.png", "a.png");
    for (const char* const key : {"rmse", "relmse", "p95", "max", "flip", "max_displayed", "pixels_differ"})
        EXPECT_EQ(json.at(key), 0) << key;
}

TEST_F(Comparing, MoreSamplesComeNearerInEveryFigure) {
    render("few.exr", "path", "2", "1");
    render("more.exr", "path", "32", "2");
    render("reference.exr", "path", "256");
    const auto few = compared("reference.exr", "few.exr"), more = compared("reference.exr", "more.exr");
    for (const char* const key : {"rmse", "relmse", "p95", "flip"})
        EXPECT_LT(2 * more.at(key).get<double>(), few.at(key).get<double>()) << key;
}

TEST_F(Comparing, TheDifferenceIsDrawnInTheSizeOfThePictures) {
    render("a.png", "whitted");
    render("b.png", "path");
    const Said said = run({"compare", "a.png", "b.png", "-o", "difference.png"});
    EXPECT_EQ(said.code, 0) << said.err;
    for (const char* const word : {"rmse", "relmse", "flip", "max"})
        EXPECT_NE(said.out.find(word), std::string::npos) << word;
    const ByteImage drawn = decodeImage(readFile(folder / "difference.png", 1U << 20U), "drawn").pixels;
    EXPECT_EQ(drawn.width(), 48);
    EXPECT_EQ(drawn.height(), 36);
}

TEST_F(Comparing, WhatCannotBeComparedIsToldInOneLine) {
    render("a.png", "local");
    ASSERT_EQ(
        run({"render", "cornell", "-o", "wide.png", "--width", "60", "--height", "36", "--samples", "1"})
            .code,
        0);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"compare", "a.png", "wide.png"},
          {"compare", "a.png", "nothing.png"},
          {"compare", "a.png", "a.png.json"},
          {"compare", "a.png"},
          {"compare", "a.png", "a.png", "-o", "d.exr"}}) {
        const Said said = run(arguments);
        EXPECT_NE(said.code, 0);
        EXPECT_EQ(said.out, "");
        EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    }
    EXPECT_EQ(run({"compare", "a.png", "wide.png"}).code, 2);
}

TEST_F(Comparing, PathTracingCountsDiffuseRaysAndTheyCanBeSwitchedOff) {
    render("a.png", "path");
    EXPECT_EQ(stats("a.png").at("method"), "path");
    EXPECT_GT(stats("a.png").at("rays").at("diffuse").get<int>(), 1000);
    render("b.png", "distributed");
    EXPECT_EQ(stats("b.png").at("rays").at("diffuse"), 0);
    EXPECT_GT(compared("a.png", "b.png").at("flip").get<double>(), 0.1) << "the ceiling is dark without them";
    ASSERT_EQ(run({"render", "cornell", "-o", "c.png", "--width", "48", "--height", "36", "--method", "path",
                   "--samples", "2", "--no-diffuse", "--stats", "c.png.json"})
                  .code,
              0);
    EXPECT_EQ(stats("c.png").at("rays").at("diffuse"), 0);
}

}
}
