// labels: unit
// The subcommand `inspect`, through the program.

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "tests/app_process.h"

namespace eyeray {
namespace {

using Json = nlohmann::json;

struct Said {
    int code;
    std::string out, err;
};

class Inspect : public testing::Test {
protected:
    Said run(const std::vector<std::string>& arguments) const {
        Process process(EYERAY_BINARY_DIR "/eyeray", arguments, folder.path(),
                        {"HOME=" + folder.path().string(), "DISPLAY=", "WAYLAND_DISPLAY="});
        const int code = process.wait();
        return {code, process.out(), process.err()};
    }

    /// Of a small picture; the rest are further options.
    Said inspect(const std::string& scene, const std::string& pixel,
                 std::vector<std::string> options = {}) const {
        std::vector<std::string> all = {"inspect", scene, "--pixel",  pixel,
                                        "--width", "96",  "--height", "54"};
        all.insert(all.end(), options.begin(), options.end());
        return run(all);
    }

    Json json(const std::string& scene, const std::string& pixel,
              std::vector<std::string> options = {}) const {
        options.insert(options.end(), {"--format", "json"});
        const Said said = inspect(scene, pixel, options);
        EXPECT_EQ(said.code, 0) << said.err;
        return Json::parse(said.out);
    }

    TemporaryFolder folder;
};

std::array<float, 3> color(const Json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

/// Little-endian PFM, rows from the bottom.
std::array<float, 3> pfmPixel(const std::string& file, int width, int height, int x, int y) {
    const std::size_t values = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
    const std::size_t row = static_cast<std::size_t>(height - 1 - y);
    const std::size_t first = (row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
    std::array<float, 3> result{};
    std::copy_n(file.data() + file.size() - values * 4 + first * 4, 12,
                reinterpret_cast<char*>(result.data()));
    return result;
}

TEST_F(Inspect, PixelAndTotalOfTheJsonAreThePictureOfThatSample) {
    for (const std::string scene : {"homage", "mirrors", "bubble", "window", "metals"})
        for (const int sample : {0, 3}) {
            const Said rendered = run({"render", scene, "-o", "a.pfm", "--width", "96", "--height", "54",
                                       "--samples", "1", "--first-pass", fmt::format("{}", sample)});
            ASSERT_EQ(rendered.code, 0) << rendered.err;
            const std::string picture = textOf(folder / "a.pfm");
            for (const auto& [x, y] : {std::pair{48, 27}, {30, 30}, {95, 53}}) {
                const Json said =
                    json(scene, fmt::format("{},{}", x, y), {"--sample", fmt::format("{}", sample)});
                EXPECT_EQ(color(said.at("pixel")), pfmPixel(picture, 96, 54, x, y)) << scene;
                EXPECT_EQ(said.at("pixel"), said.at("total"));
            }
        }
}

/// A node of the JSON, computed from its leaves in float.
std::array<float, 3> sum(const Json& node) {
    if (!node.contains("operands")) return color(node.at("value"));
    const bool adds = node.at("operation") == "sum";
    std::array<float, 3> result;
    result.fill(adds ? 0.0F : 1.0F);
    for (const Json& operand : node.at("operands")) {
        const auto value = sum(operand);
        for (std::size_t c = 0; c < 3; ++c) adds ? result[c] += value[c] : result[c] *= value[c];
    }
    return result;
}

TEST_F(Inspect, LedgerOfTheJsonAddsUpToThePixelInFloat) {
    for (const std::string scene : {"homage", "bubble", "wedge"})
        for (const std::string pixel : {"48,27", "40,30", "20,40"}) {
            const Json said = json(scene, pixel);
            EXPECT_EQ(sum(said.at("ledger")), color(said.at("pixel"))) << scene << ' ' << pixel;
        }
}

TEST_F(Inspect, NumbersOfTheJsonHaveTheShortestDigitsOfAFloat) {
    const Said said = inspect("homage", "48,27", {"--format", "json"});
    const Json parsed = Json::parse(said.out);
    for (const Json& channel : parsed.at("pixel")) {
        const std::string shortest = fmt::format("{}", channel.get<float>());
        EXPECT_NE(said.out.find(shortest), std::string::npos) << shortest;
        EXPECT_EQ(channel.dump(), shortest);
    }
}

TEST_F(Inspect, JsonHasEveryRayLampAndUntracedRay) {
    const Json said = json("homage", "48,27", {"--max-depth", "1"});
    const Json& rays = said.at("rays");
    ASSERT_FALSE(rays.empty());
    EXPECT_EQ(rays[0].at("kind"), "eye");
    EXPECT_EQ(rays[0].at("parent"), -1);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(rays[i].at("ray"), i);
        EXPECT_LE(rays[i].at("depth"), 1);
        EXPECT_EQ(rays[i].contains("hit"), rays[i].at("end") == "hit");
        EXPECT_EQ(rays[i].at("t").is_null(), rays[i].at("end") == "background");
        EXPECT_GT(rays[i].at("tests"), 0);
    }
    for (const Json& lamp : said.at("lamps")) {
        EXPECT_TRUE(lamp.contains("visibility"));
        if (lamp.at("shadow_ray") >= 0) {
            EXPECT_EQ(rays.at(lamp.at("shadow_ray").get<std::size_t>()).at("kind"), "shadow");
        }
    }
    ASSERT_FALSE(said.at("untraced").empty());
    EXPECT_EQ(said.at("untraced")[0].at("reason"), "depth limit");
}

TEST_F(Inspect, JsonSaysWhatTheIndexHadToDo) {
    const Json tree = json("knot", "48,27"), all = json("homage", "48,27", {"--accel", "brute"});
    const auto primitives = tree.at("accelerator").at("primitives").get<std::size_t>();
    EXPECT_EQ(tree.at("accelerator").at("kind"), "bvh8");
    EXPECT_LT(tree.at("rays")[0].at("tests"), primitives / 100);
    EXPECT_GT(tree.at("rays")[0].at("boxes"), tree.at("rays")[0].at("nodes"));
    EXPECT_EQ(all.at("rays")[0].at("tests"), all.at("accelerator").at("primitives"));
    EXPECT_EQ(all.at("rays")[0].at("boxes"), 0);
}

TEST_F(Inspect, CsvHasARowForEachRay) {
    const Json rays = json("homage", "48,27").at("rays");
    const Said csv = inspect("homage", "48,27", {"--format", "csv"});
    ASSERT_EQ(csv.code, 0);
    std::istringstream lines(csv.out);
    std::string line;
    std::getline(lines, line);
    const auto columns = std::count(line.begin(), line.end(), ',');
    std::size_t rows = 0;
    for (; std::getline(lines, line); ++rows) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
        EXPECT_EQ(line.rfind(fmt::format("{},{},{},", rows, rays[rows].at("parent").dump(),
                                         rays[rows].at("kind").get<std::string>()),
                             0),
                  0U)
            << line;
    }
    EXPECT_EQ(rows, rays.size());
}

TEST_F(Inspect, TextShowsTheTreeAndTheSumWithItsNumbers) {
    const Said said = inspect("homage", "40,30");
    EXPECT_EQ(said.code, 0);
    EXPECT_EQ(said.err, "");
    for (const char* part :
         {"pixel (40, 30) of homage, 96×54, sample 0", "\n  eye #0: ", "\n    refraction #",
          "The sum: ka Ia + (kd (l·n) + ks (r·v)^sh) · I₁ · S₁ + kr · […] + kt · […]", "bit for bit"})
        EXPECT_NE(said.out.find(part), std::string::npos) << part << "\n" << said.out;
}

TEST_F(Inspect, SvgIsWrittenWholeUnderItsName) {
    const Said said = inspect("mirrors", "48,27", {"--format", "svg", "-o", "tree.svg"});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.out, "");
    const std::string svg = textOf(folder / "tree.svg");
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST_F(Inspect, SvgLeavesOutRaysOfLittleWeightIfAsked) {
    const auto boxes = [&](const char* least) {
        const std::string svg = inspect("homage", "40,30", {"--format", "svg", "--least-weight", least}).out;
        std::size_t count = 0;
        for (auto at = svg.find("<rect"); at != std::string::npos; at = svg.find("<rect", at + 1)) ++count;
        return count;
    };
    EXPECT_GT(boxes("0"), boxes("0.01"));
    EXPECT_GT(boxes("0.01"), boxes("1"));
}

TEST_F(Inspect, OptionsOfThePictureChangeTheSample) {
    const Json all = json("homage", "40,30"), flat = json("homage", "40,30", {"--max-depth", "0"}),
               local = json("homage", "40,30", {"--method", "local"});
    EXPECT_NE(all.at("pixel"), flat.at("pixel"));
    EXPECT_GT(all.at("rays").size(), flat.at("rays").size());
    EXPECT_EQ(local.at("rays").size(), 1U);
    EXPECT_EQ(local.at("method"), "local");
}

TEST_F(Inspect, AWrongRequestEndsWithCodeTwoAndOneLine) {
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--pixel", "96,0"},
                                                    {"--pixel", "0,54"},
                                                    {"--pixel", "-1,0"},
                                                    {"--pixel", "1"},
                                                    {"--pixel", "1,2,3"},
                                                    {"--pixel", ","},
                                                    {"--pixel", "1.5,2"},
                                                    {"--pixel", "nan,2"},
                                                    {},
                                                    {"--pixel", "1,1", "--sample", "-1"},
                                                    {"--pixel", "1,1", "--format", "xml"},
                                                    {"--pixel", "1,1", "--least-weight", "2"},
                                                    {"--pixel", "1,1", "--least-weight", "nan"},
                                                    {"--pixel", "1,1", "--width", "0"}}) {
        std::vector<std::string> all = {"inspect", "homage"};
        all.insert(all.end(), options.begin(), options.end());
        if (options.size() < 4) all.insert(all.end(), {"--width", "96", "--height", "54"});
        const Said said = run(all);
        EXPECT_EQ(said.code, 2) << said.err;
        EXPECT_EQ(said.out, "");
        EXPECT_EQ(said.err.rfind("eyeray: ", 0), 0U) << said.err;
        EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    }
    EXPECT_EQ(inspect("no such scene", "1,1").code, 2);
    EXPECT_EQ(inspect("homage", "1,1", {"-o", "no/such/folder.txt"}).code, 1);
}

}
}
