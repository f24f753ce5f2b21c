// labels: unit threads
// Progressive rendering that waits for others, and goes on to the same picture.

#include <gtest/gtest.h>

#include "tests/sessions.h"

namespace eyeray {
namespace {

using namespace sessions;

TEST(RenderSession, HeldAtANumberOfSamplesItWaitsThereAndGoesOn) {
    const auto world = worldOf(balls());
    RenderSession session(2);
    session.holdAt(2);
    for (int picture = 0; picture < 2; ++picture) {
        session.start(world, world->scene->cameras.front(), settingsFor(6));
        while (session.status().samples < 2) session.wait(1ms);
        session.wait(50ms);
        EXPECT_EQ(session.status().samples, 2);
        EXPECT_EQ(session.status().phase, Phase::Refining) << "held, but not by a person";
    }
    session.holdAt(4);
    while (session.status().samples < 4) session.wait(1ms);
    session.holdAt(0);
    while (session.wait(100ms).active()) {
    }
    EXPECT_EQ(session.status().samples, 6);
    RenderSession free(1);
    free.start(world, world->scene->cameras.front(), settingsFor(6));
    while (free.wait(100ms).active()) {
    }
    EXPECT_EQ(session.image(), free.image());
    session.holdAt(1);
    session.start(world, world->scene->cameras.front(), settingsFor(6));
    while (session.status().samples < 1) session.wait(1ms);
    session.stop(); // must not wait for the hold
}

TEST(RenderSession, GivesWayAndGoesOnToTheSamePicture) {
    const auto world = worldOf(balls());
    RenderSession session(2);
    session.holdAt(2);
    session.start(world, world->scene->cameras.front(), settingsFor(6));
    while (session.status().samples < 2) session.wait(1ms);
    session.giveWay();
    session.holdAt(0);
    session.wait(50ms);
    EXPECT_EQ(session.status().samples, 2);
    EXPECT_EQ(session.status().phase, Phase::Refining) << "held, but not by a person";
    session.goOn();
    while (session.wait(100ms).active()) {
    }
    EXPECT_EQ(session.image(), rendered(balls(), settingsFor(6), 1));
    session.giveWay();
    session.start(world, world->scene->cameras.front(), settingsFor(2));
    while (session.wait(100ms).active()) {
    }
    EXPECT_EQ(session.status().samples, 2) << "the next picture waits for nobody";
}

}
}
