// labels: unit robustness
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/document/scene_files.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "core/image/metrics.h"
#include "tests/app_process.h"
#include "tests/read_pictures.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

struct Said {
    int code;
    std::string out, err;
};

class CommandLine : public testing::Test {
protected:
    Process start(const std::vector<std::string>& arguments) const {
        return {EYERAY_BINARY_DIR "/eyeray",
                arguments,
                folder.path(),
                {"HOME=" + folder.path().string(), "XDG_CONFIG_HOME=" + folder.path().string(),
                 "DISPLAY=", "WAYLAND_DISPLAY="}};
    }

    Said run(const std::vector<std::string>& arguments) const {
        Process process = start(arguments);
        const int code = process.wait();
        return {code, process.out(), process.err()};
    }

    /// Renders a small picture; the rest are further options.
    Said render(const std::string& scene, const std::string& file,
                std::vector<std::string> options = {}) const {
        std::vector<std::string> all = {"render", scene, "-o", file, "--width", "64", "--height", "36"};
        if (std::find(options.begin(), options.end(), "--samples") == options.end())
            options.insert(options.end(), {"--samples", "2"});
        all.insert(all.end(), options.begin(), options.end());
        return run(all);
    }

    ByteImage picture(const std::string& file) const {
        return decodeImage(readFile(folder / file, 1U << 26U), file).pixels;
    }
    std::string commandsIn(const std::string& file) const {
        return readPngText(readFile(folder / file, 1U << 26U), file).at("eyeray.commands");
    }

    TemporaryFolder folder;
};

void expectOneLine(const Said& said, int code) {
    EXPECT_EQ(said.code, code) << said.err;
    EXPECT_EQ(said.out, "");
    EXPECT_EQ(said.err.rfind("eyeray: ", 0), 0U) << said.err;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_GE(std::count(said.err.begin(), said.err.end(), ':'), 3)
        << "FILE: what is wrong: what to do: " << said.err;
}

TEST_F(CommandLine, ScenesAreListedByNameWithWhatToLookAt) {
    const Said said = run({"scenes"});
    EXPECT_EQ(said.code, 0);
    EXPECT_EQ(said.err, "");
    EXPECT_GE(std::count(said.out.begin(), said.out.end(), '\n'), 14);
    EXPECT_NE(said.out.find("\nhomage  "), std::string::npos);
}

TEST_F(CommandLine, HelpAndVersionGoToStandardOutput) {
    EXPECT_EQ(run({"--version"}).out.rfind("eyeray ", 0), 0U);
    const Said help = run({"render", "--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* option :
         {"--width", "--max-depth", "--no-shadows", "--first-pass", "--stats", "--tonemap"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option;
}

TEST_F(CommandLine, APictureIsWrittenInEachFormat) {
    for (const auto& [ending, magic] : {std::pair{"png", "\x89PNG"},
                                        {"exr", "\x76\x2f\x31\x01"},
                                        {"hdr", "#?"},
                                        {"pfm", "PF\n64 36"},
                                        {"ppm", "P6\n64 36"},
                                        {"PNG", "\x89PNG"}}) {
        const std::string file = std::string("picture.") + ending;
        const Said said = render("homage", file);
        EXPECT_EQ(said.code, 0) << said.err;
        EXPECT_EQ(said.err, "");
        EXPECT_EQ(textOf(folder / file).rfind(magic, 0), 0U) << file;
    }
}

TEST_F(CommandLine, ALayerIsWrittenInEachFormatThatHoldsItsValues) {
    for (const char* layer : {"normal", "depth", "albedo", "id", "cost", "rays", "eye", "shadow",
                              "reflection", "refraction", "lamp.sun"})
        for (const char* ending : {"png", "exr", "hdr", "pfm", "ppm"}) {
            const std::string file = fmt::format("{}.{}", layer, ending);
            const Said said = render("homage", file, {"--layer", layer});
            const bool negative = std::string(layer) == "normal" || std::string(layer) == "id";
            if (negative && std::string(ending) == "hdr") {
                expectOneLine(said, 2);
                continue;
            }
            EXPECT_EQ(said.code, 0) << said.err;
            EXPECT_GT(fs::file_size(folder / file), 64U * 36U / 4U) << file;
        }
    EXPECT_EQ(render("homage", "a.png").code, 0);
    EXPECT_EQ(render("homage", "b.png", {"--layer", "color"}).code, 0);
    EXPECT_EQ(picture("a.png"), picture("b.png"));
}

TEST_F(CommandLine, APictureOfALayerSaysWhatItsColorsStandForAndIsRenderedAgainFromItself) {
    const Said said = render("homage", "depth.png", {"--layer", "depth"});
    EXPECT_EQ(said.err.rfind("eyeray: depth: ", 0), 0U) << said.err;
    const auto text = readPngText(readFile(folder / "depth.png", 1U << 26U), "depth.png");
    EXPECT_EQ("eyeray: " + text.at("eyeray.range") + "\n", said.err);
    EXPECT_NE(text.at("eyeray.commands").find("layer name=depth"), std::string::npos);
    ASSERT_EQ(render("depth.png", "again.png").code, 0);
    EXPECT_EQ(picture("again.png"), picture("depth.png"));
    ASSERT_EQ(render("homage", "color.png").code, 0);
    EXPECT_NE(picture("color.png"), picture("depth.png"));
}

TEST_F(CommandLine, AllLayersStandInOneExr) {
    ASSERT_EQ(render("homage", "all.exr", {"--layer", "all", "--stats", "stats.json"}).code, 0);
    ASSERT_EQ(render("homage", "color.exr").code, 0);
    const auto all = readFile(folder / "all.exr", 1U << 28U),
               color = readFile(folder / "color.exr", 1U << 28U);
    EXPECT_EQ(readExr(all).image, readExr(color).image) << "the picture itself, bit for bit";
    const std::string bytes(reinterpret_cast<const char*>(all.data()), 4000);
    for (const char* channel :
         {"normal.X", "depth.Z", "albedo.R", "id.Y", "cost.Y", "rays.Y", "recursion.Y", "visits.Y", "tests.Y",
          "error.Y", "samples.Y", "eye.R", "shadow.G", "lamp.sun.B", "rest.R"})
        EXPECT_NE(bytes.find(channel), std::string::npos) << channel;
    const auto stats = nlohmann::json::parse(textOf(folder / "stats.json"));
    EXPECT_EQ(stats.at("samples"), 2);
    EXPECT_EQ(stats.at("rays").at("eye"), 64 * 36 * 2);
}

TEST_F(CommandLine, AWrongLayerIsRefusedInOneLine) {
    expectOneLine(render("homage", "a.png", {"--layer", "kolor"}), 2);
    expectOneLine(render("homage", "a.png", {"--layer", "lamp.7"}), 2);
    expectOneLine(render("homage", "a.png", {"--layer", "all"}), 2);
    expectOneLine(render("homage", "a.png", {"--layer", "rays", "--error", "0.01"}), 2);
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST_F(CommandLine, StatisticsHaveTheKeysOfTheContract) {
    ASSERT_EQ(render("homage", "a.png", {"--stats", "stats.json", "--threads", "1"}).code, 0);
    const auto stats = nlohmann::json::parse(textOf(folder / "stats.json"));
    EXPECT_EQ(stats.at("scene"), "homage");
    EXPECT_EQ(stats.at("width"), 64);
    EXPECT_EQ(stats.at("height"), 36);
    EXPECT_EQ(stats.at("samples"), 2);
    EXPECT_EQ(stats.at("threads"), 1);
    EXPECT_EQ(stats.at("method"), "whitted");
    for (const char* key : {"load", "build", "first_image", "render"})
        EXPECT_GE(stats.at("seconds").at(key).get<double>(), 0) << key;
    EXPECT_EQ(stats.at("rays").at("eye"), 64 * 36 * 2);
    for (const char* key : {"shadow", "reflection", "refraction"})
        EXPECT_GT(stats.at("rays").at(key), 0) << key;
    EXPECT_EQ(stats.at("rays").at("diffuse"), 0);
    EXPECT_GT(stats.at("mrays_per_second"), 0);
    for (const char* key : {"kind", "primitives", "nodes", "bytes"})
        EXPECT_TRUE(stats.at("accelerator").contains(key));
    EXPECT_EQ(stats.at("invalid_samples"), 0);
    EXPECT_GT(stats.at("peak_rss_bytes"), 1 << 20);
}

TEST_F(CommandLine, AWrongRequestEndsWithCodeTwoAndOneLine) {
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--frobnicate"},
                                                    {"--width", "0"},
                                                    {"--width", "-5"},
                                                    {"--width", "nan"},
                                                    {"--height", "1000000"},
                                                    {"--fov", "nan"},
                                                    {"--fov", "0"},
                                                    {"--max-depth", "65"},
                                                    {"--max-depth", "2.5"},
                                                    {"--cutoff", "inf"},
                                                    {"--exposure", "1e999"},
                                                    {"--samples", "0"},
                                                    {"--method", "magic"},
                                                    {"--tonemap", "filmic"},
                                                    {"--threads", "-1"},
                                                    {"--camera", "nobody"},
                                                    {"--aspect", "0"},
                                                    {"--first-pass", "-1"},
                                                    {"--seed", "x"},
                                                    {"--accel", "kd"},
                                                    {"--samples"}}) {
        std::vector<std::string> all = {"render", "homage", "-o", "a.png"};
        all.insert(all.end(), options.begin(), options.end());
        SCOPED_TRACE(options[0]);
        expectOneLine(run(all), 2);
        EXPECT_FALSE(fs::exists(folder / "a.png"));
    }
    expectOneLine(run({"render", "homage"}), 2);
    expectOneLine(run({"render", "-o", "a.png"}), 2);
    expectOneLine(run({"render", "homage", "-o", "a.gif"}), 2);
    expectOneLine(run({"render", "homage", "-o", "picture"}), 2);
    expectOneLine(run({"snapshot", "homage", "-o", "a.exr"}), 2);
    expectOneLine(run({"snapshot", "homage", "-o", "a.png", "--size", "12"}), 2);
}

TEST_F(CommandLine, ASceneThatCannotBeReadEndsWithCodeTwoAndOneLine) {
    writeText(folder / "no.gltf", "this is no JSON\nin two lines");
    writeText(folder / "deep.gltf", std::string(100000, '['));
    writeText(folder / "short.glb", "glTF\x02");
    writeText(folder / "empty.gltf", "");
    writeText(folder / "no.png", "\x89PNG\r\n\x1a\n and then nothing");
    fs::create_directory(folder / "folder.gltf");
    for (const char* scene : {"no such scene", "missing.gltf", "no.gltf", "deep.gltf", "short.glb",
                              "empty.gltf", "no.png", "folder.gltf", "/dev/null", ".", "two\nlines"})
        for (const char* command : {"render", "snapshot"}) {
            SCOPED_TRACE(scene);
            expectOneLine(run({command, scene, "-o", "a.png"}), 2);
            EXPECT_FALSE(fs::exists(folder / "a.png"));
        }
}

TEST_F(CommandLine, WhatCannotBeWrittenEndsWithCodeOneAndOneLine) {
    expectOneLine(render("homage", "no/such/folder/a.png"), 1);
    expectOneLine(run({"snapshot", "homage", "-o", "no/a.png"}), 1);
    fs::create_directory(folder / "taken.png");
    expectOneLine(render("homage", "taken.png"), 1);
}

TEST_F(CommandLine, WithoutADisplayTheViewerNamesTheHeadlessWay) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{}, {"homage"}, {"view", "homage"}}) {
        const Said said = run(words);
        expectOneLine(said, 1);
        EXPECT_NE(said.err.find("`eyeray snapshot`"), std::string::npos) << said.err;
    }
}

TEST_F(CommandLine, QuietRendersInSilence) {
    const Said said = render("homage", "a.png", {"--quiet"});
    EXPECT_EQ(said.code, 0);
    EXPECT_EQ(said.out + said.err, "");
}

TEST_F(CommandLine, ANegativeValueIsAValue) {
    EXPECT_EQ(render("homage", "a.png", {"--exposure", "-2"}).code, 0);
    EXPECT_NE(commandsIn("a.png").find("exposure=-2"), std::string::npos) << commandsIn("a.png");
}

TEST_F(CommandLine, BitsAreTheSameOnAnyNumberOfThreads) {
    ASSERT_EQ(render("homage", "one.pfm", {"--threads", "1", "--samples", "4"}).code, 0);
    ASSERT_EQ(render("homage", "two.pfm", {"--threads", "2", "--samples", "4"}).code, 0);
    EXPECT_EQ(textOf(folder / "one.pfm"), textOf(folder / "two.pfm"));
}

TEST_F(CommandLine, LaterSamplesAreOtherSamples) {
    ASSERT_EQ(render("homage", "first.pfm", {"--samples", "1"}).code, 0);
    ASSERT_EQ(render("homage", "zero.pfm", {"--samples", "1", "--first-pass", "0"}).code, 0);
    ASSERT_EQ(render("homage", "later.pfm", {"--samples", "1", "--first-pass", "7"}).code, 0);
    EXPECT_EQ(textOf(folder / "first.pfm"), textOf(folder / "zero.pfm"));
    EXPECT_NE(textOf(folder / "first.pfm"), textOf(folder / "later.pfm"));
}

TEST_F(CommandLine, APictureReturnsToTheStateThatItWasMadeIn) {
    ASSERT_EQ(render("homage", "a.png",
                     {"--camera", "from above", "--fov", "33.3", "--max-depth", "2", "--no-reflections",
                      "--exposure", "0.7", "--tonemap", "aces"})
                  .code,
              0);
    ASSERT_EQ(render("a.png", "b.png").code, 0);
    EXPECT_EQ(picture("a.png"), picture("b.png"));
    EXPECT_EQ(commandsIn("a.png"), commandsIn("b.png"));
    ASSERT_EQ(render("homage", "plain.png").code, 0);
    EXPECT_NE(picture("a.png"), picture("plain.png"));
}

TEST_F(CommandLine, APictureFindsItsSceneFromAnyFolderAndNamesNoAbsolutePath) {
    fs::create_directories(folder / "scenes");
    fs::create_directories(folder / "pictures");
    const auto scenes = builtinScenes();
    const auto homage =
        std::find_if(scenes.begin(), scenes.end(), [](const auto& s) { return s.name == "homage"; });
    ASSERT_NE(homage, scenes.end());
    fs::copy_file(homage->path, folder / "scenes/mine.gltf");
    for (const std::string& scene :
         {std::string("scenes/mine.gltf"), (folder / "scenes/mine.gltf").string()}) {
        ASSERT_EQ(render(scene, "pictures/a.png", {"--max-depth", "1"}).code, 0);
        const auto text = readPngText(readFile(folder / "pictures/a.png", 1U << 26U), "a.png");
        EXPECT_EQ(text.at("eyeray.scene"), "../scenes/mine.gltf");
        EXPECT_EQ(textOf(folder / "pictures/a.png").find(folder.path().string()), std::string::npos);
        ASSERT_EQ(render("pictures/a.png", "b.png").code, 0);
        EXPECT_EQ(picture("pictures/a.png"), picture("b.png"));
    }
    fs::remove(folder / "scenes/mine.gltf");
    expectOneLine(render("pictures/a.png", "c.png"), 2);
}

TEST_F(CommandLine, APictureOfAForeignSceneKeepsTheExposureThatItWasGiven) {
    writeText(folder / "foreign.gltf",
              R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"extras": {"eyeray": {"shape": 0}}}], "extensionsUsed": ["KHR_implicit_shapes"],
      "extensions": {"KHR_implicit_shapes": {"shapes": [{"type": "sphere", "sphere": {"radius": 1}}]}}})");
    ASSERT_EQ(render("foreign.gltf", "metered.png").code, 0);
    ASSERT_EQ(render("foreign.gltf", "given.png", {"--exposure", "-1.5"}).code, 0);
    ASSERT_EQ(render("given.png", "again.png").code, 0);
    EXPECT_NE(picture("metered.png"), picture("given.png"));
    EXPECT_EQ(picture("given.png"), picture("again.png"));
}

TEST_F(CommandLine, AnInterruptLeavesAWholePictureOrNone) {
    for (const char* samples : {"1000000", "3"}) {
        Process process = start({"render", "homage", "-o", "a.png", "--width", "320", "--samples", samples});
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        process.interrupt();
        process.wait();
        if (fs::exists(folder / "a.png")) {
            EXPECT_EQ(picture("a.png").width(), 320);
        }
        for (const auto& entry : fs::directory_iterator(folder.path()))
            EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
        fs::remove(folder / "a.png");
    }
}

TEST_F(CommandLine, ASnapshotShowsTheWindowAfterItsCommands) {
    writeText(folder / "play", "# turns it\nset max-depth=0\norbit yaw=60\nwait samples=1\npick x=200 y=150\n"
                               "theme name=light\nundo\n");
    const auto snapshot = [&](const std::string& file, const std::vector<std::string>& more) {
        std::vector<std::string> all = {"snapshot", "homage",  "-o",        file,
                                        "--size",   "800x480", "--samples", "1"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    ASSERT_EQ(snapshot("plain.png", {}).code, 0);
    const Said played = snapshot("played.png", {"--play", "play"});
    ASSERT_EQ(played.code, 0) << played.err;
    const ByteImage before = picture("plain.png"), after = picture("played.png");
    EXPECT_EQ(before.width(), 800);
    EXPECT_EQ(before.height(), 480);
    EXPECT_GT(countDifferingPixels(before, after), before.values().size() / 2);
    EXPECT_NE(commandsIn("played.png").find("max-depth=0"), std::string::npos);
    EXPECT_EQ(commandsIn("played.png").find("camera"), std::string::npos) << "the orbit is undone";

    for (const char* line : {"set max-depth=99\n", "jump\n", "open scene=missing.gltf\n", "set oops\n"}) {
        writeText(folder / "play", line);
        SCOPED_TRACE(line);
        expectOneLine(snapshot("wrong.png", {"--play", "play"}), 2);
        EXPECT_FALSE(fs::exists(folder / "wrong.png"));
    }
    expectOneLine(snapshot("wrong.png", {"--play", "missing"}), 2);
}

}
}
