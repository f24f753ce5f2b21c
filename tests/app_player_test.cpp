// labels: unit
// The playing of a sample by itself, with a clock of the test's own.

#include <gtest/gtest.h>

#include "app/viewer/player.h"

namespace eyeray {
namespace {

using namespace std::chrono_literals;

SampleRecord threeRays() {
    SampleRecord record;
    record.rays.resize(3);
    return record;
}

TEST(Player, ShowsAllRaysUntilItBegins) {
    const SampleRecord record = threeRays();
    Player player;
    EXPECT_EQ(player.shown(record), 3);
    EXPECT_FALSE(player.begun());
    player.go(record, PlayTo::Next);
    EXPECT_EQ(player.shown(record), 1) << "the first step shows the eye ray";
    player.go(record, PlayTo::Next);
    EXPECT_EQ(player.shown(record), 2);
    player.reset();
    EXPECT_EQ(player.shown(record), 3);
}

TEST(Player, RunsFromTheStartToTheEndAndStops) {
    const SampleRecord record = threeRays();
    Player player;
    Player::Clock::time_point now{};
    player.run(record, true, now);
    EXPECT_EQ(player.shown(record), 1);
    EXPECT_FALSE(player.update(record, now + 10ms)) << "it leaves time to look";
    for (const int shown : {2, 3}) {
        now += 2s;
        EXPECT_TRUE(player.update(record, now));
        EXPECT_EQ(player.shown(record), shown);
    }
    EXPECT_FALSE(player.running());
    EXPECT_FALSE(player.update(record, now + 2s));
}

TEST(Player, ShowsNoMoreThanAnotherSampleHas) {
    Player player;
    player.go(threeRays(), PlayTo::End);
    SampleRecord one;
    one.rays.resize(1);
    EXPECT_EQ(player.shown(one), 1);
    EXPECT_EQ(player.shown(SampleRecord{}), 0);
}

}
}
