// labels: ui
// A coarse picture played pixel by pixel in the window: the picture, the plane in space and the words.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/app_screen.h"

namespace eyeray {
namespace {

class PlayedGrid : public testing::Test {
protected:
    PlayedGrid() { execute("play-grid on=on"); }

    void execute(const std::string& command) {
        if (!screen.gui.execute(Command::parse(command))) throw std::runtime_error(command);
        screen.settle();
    }
    const GridPlayer& player() { return screen.viewer.gridPlayer(); }

    /// What the window shows in a corner of the cell, apart from grid and frame.
    Rgba8 shown(const ByteImage& window, int cell) {
        const PixelGrid& grid = player().grid();
        const WidgetRect r = screen.rect("picture");
        const float x = (static_cast<float>(grid.column(cell)) + 0.3F) / static_cast<float>(grid.columns);
        const float y = (static_cast<float>(grid.row(cell)) + 0.3F) / static_cast<float>(grid.rows);
        return window.at(static_cast<int>(r.x0 + x * (r.x1 - r.x0)),
                         static_cast<int>(r.y0 + y * (r.y1 - r.y0)));
    }
    Rgba8 traced(int cell) {
        const PixelGrid& grid = player().grid();
        const auto sample = screen.viewer.session().retrace(grid.middleX(cell), grid.middleY(cell), 0);
        Rgba8 result;
        display({&sample->radiance, 1}, screen.document().render.display, {&result, 1});
        return result;
    }

    Screen screen{"homage", 1100, 760};
};

TEST_F(PlayedGrid, StartsEmptyAndFillsWithTheColoursOfTheTracedPixels) {
    const ByteImage empty = screen.picture();
    const int cells = player().grid().cells();
    for (int cell = 1; cell < cells; ++cell) ASSERT_EQ(shown(empty, cell), shown(empty, 0));
    for (int i = 0; i < 20; ++i) execute("play to=next");
    execute("play to=back");
    const ByteImage some = screen.picture();
    for (int cell = 0; cell < cells; ++cell)
        ASSERT_EQ(shown(some, cell), cell < 19 ? traced(cell) : shown(empty, 0)) << cell;
    execute("play to=end");
    const ByteImage all = screen.picture();
    for (int cell = 0; cell < cells; ++cell) ASSERT_EQ(shown(all, cell), traced(cell)) << cell;
}

TEST_F(PlayedGrid, ShowsTheRaysOfTheLastPixelInAllViews) {
    execute("play to=next");
    execute("play to=hit");
    const int cell = *player().current();
    const PixelPosition middle{player().grid().middleX(cell), player().grid().middleY(cell)};
    ASSERT_TRUE(screen.viewer.picked());
    EXPECT_EQ(screen.viewer.picked()->pixel, middle);
    const auto& arrows = screen.gui.rayPane().view().arrows();
    ASSERT_EQ(arrows.size(), screen.viewer.picked()->trace.rays.size());
    EXPECT_EQ(arrows[0].to, screen.viewer.picked()->trace.rays[0].hit.position);
    EXPECT_EQ(player().traced().back().rays, arrows.size());
    execute("play to=start");
    EXPECT_TRUE(screen.gui.rayPane().view().arrows().empty());
    EXPECT_FALSE(screen.document().pixel);
}

TEST_F(PlayedGrid, FillsTheImagePlaneInSpaceToo) {
    const auto plane = [&] {
        screen.settle();
        return screen.gui.rayPane().view().readPicture();
    };
    const ByteImage empty = plane();
    execute("play to=end");
    const ByteImage full = plane();
    std::size_t changed = 0;
    for (std::size_t i = 0; i < full.values().size(); ++i)
        changed += full.values()[i] == empty.values()[i] ? 0U : 1U;
    EXPECT_GT(changed, 500U);
    execute("play to=start");
    EXPECT_EQ(plane(), empty);
}

TEST_F(PlayedGrid, PlaysUpToAClickedPlaceAndMovesByWholeCells) {
    const PixelGrid grid = player().grid();
    screen.click(screen.place({grid.middleX(37), grid.middleY(37)}));
    EXPECT_EQ(player().current(), 37);
    screen.press("Right");
    EXPECT_EQ(player().current(), 38);
    screen.press("Down");
    EXPECT_EQ(player().current(), 38 + grid.columns);
    screen.press("Shift+Y");
    EXPECT_FALSE(player().on());
    EXPECT_TRUE(screen.viewer.picked());
}

TEST_F(PlayedGrid, FollowsAnEditAndEndsWithAnotherScene) {
    execute("play to=end");
    const Color before = player().traced()[100].radiance;
    execute("set fov=80");
    const PixelGrid& grid = player().grid();
    ASSERT_EQ(player().traced().size(), static_cast<std::size_t>(grid.cells()));
    EXPECT_NE(player().traced()[100].radiance, before);
    EXPECT_EQ(player().traced()[100].radiance,
              screen.viewer.session().retrace(grid.middleX(100), grid.middleY(100), 0)->radiance);
    screen.gui.execute(Command::parse("open scene=shadows"));
    screen.settle();
    EXPECT_FALSE(player().on());
}

TEST_F(PlayedGrid, HasItsControlsInThePane) {
    for (const char* name : {"play", "play to=next", "play to=back", "play-grid", "play speed"})
        EXPECT_TRUE(screen.gui.widgets().contains(name)) << name;
    screen.click("play to=next");
    EXPECT_EQ(player().current(), 0);
    execute("play speed=10");
    EXPECT_EQ(player().speed(), 10);
    EXPECT_FALSE(screen.viewer.playing());
    screen.click("play");
    EXPECT_TRUE(screen.viewer.playing());
    screen.click("play-grid");
    EXPECT_FALSE(player().on());
}

TEST_F(PlayedGrid, EndsWithTheViewsThatExplainIt) {
    execute("explain on=off");
    EXPECT_FALSE(player().on());
    execute("explain on=on");
    EXPECT_FALSE(player().on()) << "the picture is whole until it is asked for again";
}

}
}
