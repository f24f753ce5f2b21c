// labels: unit
// The coarse picture that is played pixel by pixel: where its cells lie, and the steps of its player.

#include <gtest/gtest.h>

#include "app/viewer/grid_player.h"

namespace eyeray {
namespace {

using namespace std::chrono_literals;

TEST(PixelGrid, HasSixteenByTwelveCellsOverAPictureOfFourToThree) {
    const PixelGrid grid = gridOver(640, 480);
    EXPECT_EQ(grid.columns, 16);
    EXPECT_EQ(grid.rows, 12);
    EXPECT_EQ(gridOver(1280, 720).rows, 9);
    EXPECT_EQ(gridOver(480, 640).columns, 12);
    EXPECT_EQ(gridOver(480, 640).rows, 16);
}

TEST(PixelGrid, EveryMiddleLiesInItsOwnCellAlsoOfTinyPictures) {
    for (const auto& [width, height] : {std::pair{640, 480}, {33, 17}, {20, 7}, {1, 1}, {3, 1}, {999, 31}}) {
        const PixelGrid grid = gridOver(width, height);
        for (int cell = 0; cell < grid.cells(); ++cell) {
            EXPECT_EQ(grid.cellAt(grid.middleX(cell), grid.middleY(cell)), cell) << width << " " << height;
            EXPECT_LT(grid.middleX(cell), width);
            EXPECT_LT(grid.middleY(cell), height);
        }
        EXPECT_EQ(grid.cellAt(width - 1, height - 1), grid.cells() - 1);
    }
}

/// A picture whose pixel (x, y) has the radiance (x, y, 1) and, in its right half, hits something.
class Played : public testing::Test {
protected:
    std::optional<Retrace> trace(int x, int y) {
        if (!there) return std::nullopt;
        Retrace sample;
        sample.radiance = Color(x, y, 1);
        sample.rays = {{.end = 2 * x >= grid.width ? RayEnd::Hit : RayEnd::Background}};
        return sample;
    }
    void go(PlayTo to) { player.go(to, byHand); }

    PixelGrid grid = gridOver(64, 48);
    GridPlayer player;
    bool there = true;
    GridPlayer::Trace byHand = [this](int x, int y) { return trace(x, y); };
};

TEST_F(Played, FillsRowByRowAndEmptiesAgainOnTheWayBack) {
    player.begin(grid);
    EXPECT_FALSE(player.current());
    for (int cell = 0; cell < 20; ++cell) {
        go(PlayTo::Next);
        ASSERT_EQ(player.current(), cell);
        const Color expected(grid.middleX(cell), grid.middleY(cell), 1);
        EXPECT_EQ(player.traced().back().radiance, expected);
    }
    EXPECT_EQ(player.rays(), 20U) << "one eye ray for each pixel";
    for (int cell = 18; cell >= 0; --cell) {
        go(PlayTo::Back);
        EXPECT_EQ(player.current(), cell);
        EXPECT_EQ(player.traced().size(), static_cast<std::size_t>(cell) + 1);
    }
    go(PlayTo::Back);
    EXPECT_FALSE(player.current());
    go(PlayTo::Back);
    EXPECT_FALSE(player.current());
    go(PlayTo::End);
    EXPECT_EQ(player.traced().size(), 192U);
    go(PlayTo::Next);
    EXPECT_EQ(player.current(), 191);
    go(PlayTo::Start);
    EXPECT_TRUE(player.traced().empty());
}

TEST_F(Played, GoesToTheNextPixelThatHitsSomething) {
    player.begin(grid);
    go(PlayTo::Hit);
    EXPECT_EQ(player.current(), 8);
    go(PlayTo::Hit);
    EXPECT_EQ(player.current(), 9);
    player.goTo(16, byHand);
    go(PlayTo::Hit);
    EXPECT_EQ(player.current(), 24);
    go(PlayTo::Light);
    EXPECT_EQ(player.current(), 191) << "no ray goes to a lamp";
}

TEST_F(Played, RunsAtItsSpeedToTheEndAndStops) {
    player.begin(grid);
    GridPlayer::Clock::time_point now{};
    player.run(true, now);
    EXPECT_FALSE(player.update(byHand, now + 10ms));
    EXPECT_TRUE(player.update(byHand, now += 200ms));
    EXPECT_EQ(player.current(), 0);
    player.setSpeed(8); // 64 in a second
    EXPECT_TRUE(player.update(byHand, now += 50ms));
    EXPECT_EQ(player.current(), 3);
    for (int frame = 0; frame < 100 && player.running(); ++frame) player.update(byHand, now += 50ms);
    EXPECT_FALSE(player.running());
    EXPECT_EQ(player.current(), 191);
    player.run(true, now);
    EXPECT_FALSE(player.current()) << "it begins anew";
}

TEST_F(Played, WaitsForThePictureAndCatchesUp) {
    there = false;
    player.begin(grid);
    player.goTo(5, byHand);
    go(PlayTo::Next);
    EXPECT_EQ(player.current(), 5);
    EXPECT_TRUE(player.traced().empty());
    EXPECT_FALSE(player.update(byHand));
    there = true;
    EXPECT_TRUE(player.update(byHand));
    EXPECT_EQ(player.traced().size(), 6U);
    player.retrace(gridOver(64, 24), byHand);
    EXPECT_EQ(player.current(), 5) << "another picture, as far as before";
    EXPECT_EQ(player.grid().rows, 6);
    player.end();
    EXPECT_FALSE(player.current());
}

}
}
