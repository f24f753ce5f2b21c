// labels: ui
// The index over the scene in the view of the rays in space: levels, and the boxes of the selected ray.

#include <gtest/gtest.h>

#include "core/study/ray_traversal.h"
#include "core/study/wording.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

/// The knot, explained, with a pixel of it picked.
class IndexScreen : public Screen {
public:
    IndexScreen() : Screen("knot", 1100, 760) {
        execute("explain on=on");
        settle();
        const PictureSize size = viewer.pictureSize();
        execute(fmt::format("pick x={} y={}", size.width / 2, size.height / 2 + size.height / 8));
    }

    void execute(const std::string& command) {
        if (!gui.execute(Command::parse(command))) throw std::runtime_error(command);
        settle();
    }
    /// What the view writes that begins so, or nothing.
    std::string said(const std::string& begin) {
        const TemporaryFolder folder;
        const auto file = folder / "rays.svg";
        execute(fmt::format("rayview-screenshot file={}", file.string()));
        const std::string svg = textOf(file);
        const auto at = svg.find(">" + begin);
        return at == std::string::npos ? "" : svg.substr(at + 1, svg.find('<', at) - at - 1);
    }
    std::size_t paths() { return gui.rayPane().view().sketch().paths.size(); }
    std::string traversal(int ray) const {
        return traversalText(
            traversalOf(*viewer.shownWorld(), document().render.trace, viewer.picked()->trace, ray),
            *viewer.shownWorld());
    }
};

TEST(IndexView, SaysAndDrawsWhatTheSelectedRayIsTestedAgainst) {
    IndexScreen screen;
    const std::size_t without = screen.paths();
    EXPECT_EQ(screen.said("bvh8: "), "");
    screen.execute("rayview boxes=ray");
    EXPECT_GT(screen.paths(), without + 12) << "the edges of boxes";
    EXPECT_EQ(screen.said("bvh8: "), screen.traversal(0));
    screen.execute("select-ray index=1");
    EXPECT_EQ(screen.said("bvh8: "), screen.traversal(1));
    screen.execute("select-ray index=0");
    screen.execute("rayview boxes=none");
    EXPECT_EQ(screen.paths(), without);
}

TEST(IndexView, TheSliderGoesThroughTheLevels) {
    IndexScreen screen;
    screen.execute("rayview boxes=level level=0");
    const std::size_t few = screen.paths();
    const WidgetRect slider = screen.rect("box level");
    const float y = (slider.y0 + slider.y1) / 2;
    screen.drag(0, {slider.x0 + 6, y}, {slider.x1 - 2, y});
    screen.settle();
    const World& world = *screen.viewer.shownWorld();
    const int deepest = levelsOf(world) - 1;
    const std::size_t last = boxesOfLevel(world, deepest).boxes.size();
    EXPECT_LT(last, kMostIndexBoxes);
    EXPECT_GT(screen.paths(), few + 6 * last);
    EXPECT_EQ(screen.said("level "), fmt::format("level {0} of {0}: {1} boxes", deepest, countText(last)));
}

TEST(IndexView, OfALevelWithVeryManyBoxesTheLargestAreDrawn) {
    IndexScreen screen;
    screen.execute("rayview boxes=level level=0");
    const std::size_t few = screen.paths();
    const World& world = *screen.viewer.shownWorld();
    const int deepest = levelsOf(world) - 1;
    int level = 0;
    while (level < deepest && boxesOfLevel(world, level).leftOut == 0) ++level;
    screen.execute(fmt::format("rayview level={}", level));
    const IndexPicture shown = boxesOfLevel(world, level);
    EXPECT_EQ(shown.boxes.size(), kMostIndexBoxes);
    EXPECT_GT(screen.paths(), few + 6 * kMostIndexBoxes);
    EXPECT_EQ(screen.said("level "),
              fmt::format("level {} of {}: {} boxes, the {} largest drawn", level, deepest,
                          countText(shown.boxes.size() + shown.leftOut), kMostIndexBoxes));
}

TEST(IndexView, IsChosenInTheListAndFollowsTheAccelerator) {
    IndexScreen screen;
    screen.click("shown boxes");
    screen.settle();
    screen.click("shown boxes=ray");
    screen.settle();
    EXPECT_NE(screen.said("bvh8: "), "");
    screen.execute("set accel=bvh2");
    EXPECT_EQ(screen.said("bvh2: "), screen.traversal(0));
    EXPECT_EQ(screen.said("bvh8: "), "");
}

TEST(IndexView, WithoutAnIndexSaysSo) {
    Screen screen("homage", 1100, 760);
    for (const char* command : {"explain on=on", "set accel=brute", "rayview boxes=level"})
        ASSERT_TRUE(screen.gui.execute(Command::parse(command)));
    screen.settle();
    EXPECT_EQ(levelsOf(*screen.viewer.shownWorld()), 0);
    EXPECT_EQ(screen.gui.widgets().count("box level"), 0U);
}

TEST(IndexView, OpensWhenBoxesAreAskedFor) {
    IndexScreen screen;
    screen.execute("explain on=off");
    screen.execute("rayview boxes=none");
    EXPECT_FALSE(screen.gui.preferences().explain);
    screen.execute("rayview boxes=ray");
    EXPECT_TRUE(screen.gui.preferences().explain);
}

TEST(IndexView, RefusesWhatItDoesNotKnow) {
    IndexScreen screen;
    EXPECT_FALSE(screen.gui.execute(Command::parse("rayview boxes=all")));
    EXPECT_FALSE(screen.gui.execute(Command::parse("rayview level=-1")));
}

}
}
