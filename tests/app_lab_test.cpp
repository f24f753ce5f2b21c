// labels: ui
// The failure lab as a lecturer uses it, and a student's picture held against the faults.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app_process.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

class Lab : public testing::Test {
protected:
    Screen screen{"lab-sphere", 900, 620};
    TemporaryFolder folder;
};

TEST_F(Lab, OpensWithBothSidesAndCountsWrongPixels) {
    EXPECT_EQ(screen.document().lab, labDemoNamed("lab-sphere"));
    EXPECT_TRUE(screen.document().comparison.on);
    const auto& change = screen.viewer.comparison().change();
    ASSERT_NE(change, nullptr);
    EXPECT_GT(change->wrong, change->pixels / 20);
    EXPECT_LE(change->wrong, change->changed);
    EXPECT_GT(change->secondsHere, 0);
    EXPECT_GT(change->secondsThere, 0);
    EXPECT_NO_THROW(screen.rect("lab value"));
}

TEST_F(Lab, SliderMovesByKeysAndBackByUndo) {
    const double start = screen.document().labValue;
    screen.press("]");
    screen.settle();
    EXPECT_GT(screen.document().labValue, start);
    EXPECT_EQ(screen.document().camera.eye.z, screen.document().labValue);
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().labValue, start);
    screen.press("[");
    EXPECT_LT(screen.document().labValue, start);
}

TEST_F(Lab, MarksAreSwitchedByAKeyAndChangeThePictureOnTheLeftAlone) {
    const WidgetRect place = screen.rect("picture");
    const ByteImage marked = screen.picture();
    screen.press("X");
    EXPECT_FALSE(screen.document().comparison.marks);
    const ByteImage bare = screen.picture();
    const int middle = static_cast<int>((place.x0 + place.x1) / 2);
    const int panel = static_cast<int>(place.x1);
    int left = 0, right = 0;
    for (int y = static_cast<int>(place.y0); y < static_cast<int>(place.y1) - 150; ++y)
        for (int x = static_cast<int>(place.x0); x < panel; ++x)
            if (marked.at(x, y) != bare.at(x, y)) ++(x < middle ? left : right);
    EXPECT_GT(left, 1000);
    EXPECT_EQ(right, 0);
}

TEST_F(Lab, PictureRemembersDemonstrationAndSlider) {
    screen.viewer.execute(Command::parse("lab value=20000"));
    screen.settle();
    const std::string file = (folder / "far.png").string();
    screen.viewer.execute({"screenshot", {{"file", file}}});
    const Document again = openScene(file).document;
    EXPECT_EQ(again.lab, labDemoNamed("lab-sphere"));
    EXPECT_EQ(again.labValue, 20000);
    EXPECT_EQ(again.camera, screen.document().camera);
}

TEST(NameThatBug, ComparesWithTheFaultAndPicksTheFirstWrongPixel) {
    const TemporaryFolder folder;
    Screen screen("homage", 700, 500);
    const std::string file = (folder / "student.png").string();
    for (const char* const line : {"set fault=flipped-rows", "wait"})
        screen.gui.execute(Command::parse(line));
    screen.settle();
    screen.viewer.execute({"screenshot", {{"file", file}}});
    screen.gui.execute(Command::parse("set fault=none"));
    screen.settle();
    screen.gui.execute({"name-bug", {{"file", file}}});
    screen.settle();
    const auto& report = screen.viewer.naming().report();
    ASSERT_TRUE(report);
    EXPECT_EQ(report->bug.ranked.front().faults, FaultSet(Fault::FlippedRows));
    EXPECT_EQ(screen.document().comparison.with, "fault=flipped-rows");
    ASSERT_TRUE(screen.document().pixel);
    EXPECT_EQ(screen.document().pixel->y, report->bug.firstWrong->y);

    EXPECT_FALSE(screen.gui.execute(Command::parse("name-bug file=/no/such/picture.png")));
    EXPECT_FALSE(screen.viewer.notices().empty());
}

TEST(FaultsOnTheCommandLine, AreNamedListedAndTold) {
    TemporaryFolder folder;
    const auto run = [&](const std::vector<std::string>& arguments) {
        Process process(EYERAY_BINARY_DIR "/eyeray", arguments, folder.path(),
                        {"HOME=" + folder.path().string(), "DISPLAY="});
        const int code = process.wait();
        return std::pair(code, process.out() + process.err());
    };
    const auto [code, said] = run({"render", "homage", "-o", "student.png", "--width", "96", "--samples", "1",
                                   "--fault", "reflection-sign,no-gamma"});
    ASSERT_EQ(code, 0) << said;
    EXPECT_EQ(openScene((folder / "student.png").string()).document.render.trace.faults,
              faultsNamed("reflection-sign,no-gamma"));
    EXPECT_EQ(run({"render", "homage", "-o", "x.png", "--fault", "typo"}).first, 2);
    EXPECT_NE(run({"scenes"}).second.find("lab-terminator"), std::string::npos);

    ASSERT_EQ(
        run({"render", "homage", "-o", "dark.png", "--width", "96", "--samples", "1", "--fault", "no-gamma"})
            .first,
        0);
    const auto named = run({"name-bug", "homage", "dark.png", "--json"});
    ASSERT_EQ(named.first, 0) << named.second;
    const auto json = nlohmann::json::parse(named.second);
    EXPECT_EQ(json.at("ranked").at(0).at("fault"), "no-gamma");
    EXPECT_EQ(json.at("ranked").size(), static_cast<std::size_t>(kFaults) + 1);
}

}
}
