// labels: unit threads
// Progressive rendering: the same bits on any number of threads, through pauses, stops and storms of
// restarts.

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/sessions.h"

namespace eyeray {
namespace {

using namespace scenes;
using namespace sessions;

/// The mean of samples traced one by one, without a session.
ColorImage meanOfPasses(const Scene& scene, const RenderSettings& settings, int passes) {
    const Tracing tracing(scene, settings.trace, settings.width, settings.height);
    std::vector<DVec3> sums(static_cast<std::size_t>(settings.width) *
                            static_cast<std::size_t>(settings.height));
    for (int pass = 0; pass < passes; ++pass) {
        const auto samples = tracing.radiance(settings.firstPass + pass);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += DVec3(samples[i]);
    }
    ColorImage mean(settings.width, settings.height);
    for (std::size_t i = 0; i < sums.size(); ++i)
        mean.values()[i] = Color(sums[i] / static_cast<double>(passes));
    return mean;
}

TEST(RenderSession, GivesTheSameBitsOnAnyNumberOfThreads) {
    const ColorImage one = rendered(balls(), settingsFor(4), 1);
    EXPECT_EQ(one, rendered(balls(), settingsFor(4), 2));
    EXPECT_EQ(one, rendered(balls(), settingsFor(4), 8));
}

TEST(RenderSession, IsTheMeanOfItsSamplesInOrderOfPasses) {
    for (const int firstPass : {0, 3}) {
        RenderSettings settings = settingsFor(5);
        settings.firstPass = firstPass;
        EXPECT_EQ(rendered(balls(), settings, 2), meanOfPasses(balls(), settings, 5));
    }
}

TEST(RenderSession, RetracesTheSamplesOfThePictureShown) {
    RenderSettings settings = settingsFor(3);
    settings.firstPass = 2;
    RenderSession session(2);
    EXPECT_FALSE(session.retrace(0, 0, 0)) << "no picture yet";
    start(session, balls(), settings);
    finished(session);
    const ColorImage image = session.image();
    for (int y = 0; y < kHeight; y += 7)
        for (int x = 0; x < kWidth; x += 7) {
            DVec3 sum(0);
            for (int pass = 0; pass < 3; ++pass) sum += DVec3(session.retrace(x, y, pass)->radiance);
            EXPECT_EQ(Color(sum / 3.0), image.at(x, y));
        }
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {kWidth, 0}, {0, kHeight}})
        EXPECT_FALSE(session.retrace(x, y, 0));
}

TEST(RenderSession, ReportsWhatItDid) {
    RenderSession session(3);
    EXPECT_EQ(session.status().phase, Phase::Idle);
    EXPECT_TRUE(session.image().empty());
    Picture picture;
    EXPECT_TRUE(session.read(picture).empty());
    session.stop();

    start(session, balls(), settingsFor(4));
    const RenderStatus status = finished(session);
    EXPECT_EQ(status.samples, 4);
    EXPECT_EQ(status.finishedBy, "4 samples");
    EXPECT_EQ(status.passProgress, 1);
    EXPECT_EQ(status.counts[RayKind::Eye], 4U * kWidth * kHeight) << "the coarse picture left out";
    EXPECT_EQ(status.counts.invalidSamples, 0U);
    EXPECT_GT(status.counts[RayKind::Refraction], 0U);
    EXPECT_GT(status.seconds, 0);
    EXPECT_GT(status.mraysPerSecond(), 0);
    EXPECT_GT(status.secondsToCoarse, 0);
    EXPECT_EQ(status.threads, 3);
    EXPECT_FALSE(status.active());
    session.read(picture);
    EXPECT_EQ(picture.radiance, session.image());
}

TEST(RenderSession, PausedShowsTheCoarsePictureAndGoesOnWhenResumed) {
    RenderSession session(2);
    session.pause();
    start(session, balls(), settingsFor(2));
    while (session.status().phase != Phase::Paused) std::this_thread::yield();
    EXPECT_EQ(session.status().samples, 0);
    EXPECT_TRUE(session.image().empty()) << "no whole pass yet";
    Picture picture;
    session.read(picture);
    const Tracing tracing(balls(), TraceSettings{}, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            ASSERT_EQ(picture.radiance.at(x, y), tracing.pixel(x / 4 * 4 + 2, y / 4 * 4 + 2));
    session.resume();
    finished(session);
    EXPECT_EQ(session.image(), meanOfPasses(balls(), settingsFor(2), 2));
}

TEST(RenderSession, PausesChangeNoBit) {
    RenderSession session(2);
    start(session, balls(), settingsFor(12));
    cases::Random random(1);
    for (int i = 0; i < 40; ++i) {
        session.pause();
        std::this_thread::sleep_for(std::chrono::microseconds(random.below(1500)));
        session.resume();
        std::this_thread::sleep_for(std::chrono::microseconds(random.below(1500)));
    }
    EXPECT_EQ(finished(session).samples, 12);
    EXPECT_EQ(session.status().counts[RayKind::Eye], 12U * kWidth * kHeight) << "no tile is counted twice";
    EXPECT_EQ(session.image(), meanOfPasses(balls(), settingsFor(12), 12));
}

TEST(RenderSession, StopKeepsThePictureWithItsWholePasses) {
    RenderSession session(2);
    start(session, balls(), settingsFor(1'000'000));
    while (session.status().samples < 2) std::this_thread::yield();
    session.stop();
    const RenderStatus status = session.status();
    EXPECT_EQ(status.phase, Phase::Idle);
    EXPECT_EQ(session.image(), meanOfPasses(balls(), settingsFor(1), status.samples));
    EXPECT_EQ(session.wait(120s).phase, Phase::Idle) << "nothing is waited for";
}

TEST(RenderSession, EndOfTimeKeepsWholePasses) {
    for (const double seconds : {1e-9, 0.05}) {
        RenderSettings settings = settingsFor(1'000'000);
        settings.stop.seconds = seconds;
        RenderSession session(2);
        start(session, balls(), settings);
        const RenderStatus status = finished(session);
        EXPECT_GE(status.samples, 1) << "one pass there is always";
        EXPECT_LT(status.samples, 1'000'000);
        EXPECT_EQ(status.finishedBy.substr(status.finishedBy.size() - 2), " s");
        EXPECT_EQ(session.image(), meanOfPasses(balls(), settings, status.samples));
    }
}

TEST(RenderSession, EndsWhenNoErrorIsLeftToSee) {
    RenderSettings settings = settingsFor(100'000);
    settings.stop.error = kInvisibleError;
    settings.stop.adaptive = false;
    RenderSession session(2);
    start(session, underSky(Color(0.5F)), settings);
    RenderStatus status = finished(session);
    EXPECT_EQ(status.samples, 16);
    EXPECT_EQ(status.estimatedError, 0);
    EXPECT_EQ(status.finishedBy, "no visible error left");

    settings.stop.error = 0.03;
    start(session, balls(), settings);
    status = finished(session);
    EXPECT_GT(status.samples, 16);
    EXPECT_LE(status.estimatedError, 0.03);
    EXPECT_EQ(status.finishedBy, "error below 0.03");
    EXPECT_EQ(session.image(), meanOfPasses(balls(), settings, status.samples));
}

TEST(RenderSession, DropsTheLongestTraceAtOnce) {
    RenderSession session(2);
    for (int i = 0; i < 10; ++i) {
        start(session, endless(), endlessSettings());
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
        const auto before = std::chrono::steady_clock::now();
        session.stop();
        EXPECT_LT(std::chrono::steady_clock::now() - before, 5s) << "it would take hours";
    }
    start(session, endless(), endlessSettings());
    start(session, balls(), settingsFor(1));
    finished(session);
    EXPECT_EQ(session.image(), meanOfPasses(balls(), settingsFor(1), 1));
}

TEST(RenderSession, MayBeDestroyedAtAnyTime) {
    cases::Random random(2);
    for (int i = 0; i < 40; ++i) {
        RenderSession session(2);
        if (i % 4 == 1) session.pause();
        if (i % 4 != 3)
            start(session, i % 2 == 0 ? balls() : endless(), i % 2 == 0 ? settingsFor(9) : endlessSettings());
        std::this_thread::sleep_for(std::chrono::microseconds(random.below(4000)));
    }
}

TEST(RenderSession, ShowsTheOldPictureUntilTheNewOneIsWhole) {
    const std::array skies = {1.0F, 2.0F, 3.0F};
    RenderSession session(2);
    Picture picture;
    start(session, underSky(Color(skies[0])), settingsFor(1, 200, 150));
    finished(session);
    session.read(picture);
    for (std::size_t i = 1; i <= 300; ++i) {
        start(session, underSky(Color(skies[i % 3])), settingsFor(3, 200, 150));
        for (std::size_t reads = 0; reads <= i % 7; ++reads) {
            session.read(picture);
            const float now = std::round(picture.radiance.at(0, 0).g);
            ASSERT_NE(std::find(skies.begin(), skies.end(), now), skies.end());
            for (const Color& c : picture.radiance.values())
                ASSERT_NEAR(c.g, now, 1e-5) << "two pictures in one";
        }
        if (i % 10 != 0) continue;
        finished(session);
        session.read(picture);
        ASSERT_NEAR(picture.radiance.at(0, 0).g, skies[i % 3], 1e-5);
    }
}

TEST(RenderSession, ReadsTellWhichTilesChanged) {
    RenderSession session(2);
    Picture picture, copy;
    start(session, balls(), settingsFor(30));
    while (session.status().samples < 1) std::this_thread::yield();
    session.read(picture);
    copy = picture;
    bool active = true;
    while (active) {
        active = session.status().active();
        for (const Tile& tile : session.read(picture))
            for (int y = tile.y0; y < tile.y1; ++y)
                for (int x = tile.x0; x < tile.x1; ++x) copy.radiance.at(x, y) = picture.radiance.at(x, y);
        ASSERT_EQ(copy.radiance, picture.radiance);
    }
    EXPECT_EQ(picture.radiance, session.image());
}

TEST(RenderSession, TracesTilesFromTheFocusOutward) {
    constexpr int kSide = 256;
    Scene scene = balls();
    scene.ambient = Color(0.5F); // so that no pixel is black
    RenderSettings settings = settingsFor(1, kSide, kSide);
    settings.coarse = false;
    for (const DVec2& focus : {DVec2(128, 128), DVec2(250, 10), DVec2(40, 200)}) {
        RenderSession session(1); // one thread: tiles end in the order in which they start
        if (focus != DVec2(0.5 * kSide)) session.setFocus(focus);
        start(session, scene, settings);
        while (session.status().passProgress == 0) std::this_thread::yield();
        session.pause();
        while (session.status().active()) std::this_thread::yield();
        Picture picture;
        session.read(picture);
        double farthestDone = 0, nearestOpen = kInfinity;
        for (int y = kTileSize / 2; y < kSide; y += kTileSize)
            for (int x = kTileSize / 2; x < kSide; x += kTileSize) {
                const double distance = glm::length(DVec2(x, y) - focus);
                if (isBlack(picture.radiance.at(x, y)))
                    nearestOpen = std::fmin(nearestOpen, distance);
                else
                    farthestDone = std::fmax(farthestDone, distance);
            }
        EXPECT_GT(farthestDone, 0);
        EXPECT_LE(farthestDone, nearestOpen);
    }
}

TEST(RenderSession, FailureIsReportedAndLeavesTheOldPicture) {
    RenderSession session(2);
    start(session, balls(), settingsFor(1));
    finished(session);
    const ColorImage image = session.image();
    start(session, balls(), settingsFor(1, 0, 0));
    const RenderStatus status = session.wait(120s);
    EXPECT_EQ(status.phase, Phase::Failed);
    EXPECT_FALSE(status.failure.empty());
    EXPECT_EQ(session.image(), image);
    start(session, balls(), settingsFor(1));
    finished(session);
}

TEST(RenderSession, GivesEachPictureAwayOnce) {
    RenderSession session(1);
    for (int samples = 1; samples <= 3; ++samples) {
        start(session, balls(), settingsFor(samples));
        finished(session);
        session.stop();
        const ColorImage image = session.image();
        EXPECT_EQ(session.takeImage(), image);
        EXPECT_TRUE(session.image().empty());
    }
}

TEST(RenderSession, SurvivesAStormOfEvents) {
    const std::array scenes = {balls(), underSky(Color(0.5F)), endless()};
    const std::array worlds = {worldOf(scenes[0]), worldOf(scenes[1]), worldOf(scenes[2])};
    const ColorImage expected = rendered(balls(), settingsFor(2), 1);
    for (const int threads : {1, 2, 8}) {
        cases::Random random(static_cast<std::uint32_t>(threads));
        RenderSession session(threads);
        Picture picture;
        const auto startAny = [&] {
            const auto which = static_cast<std::size_t>(random.below(3));
            RenderSettings settings = which == 2 ? endlessSettings() : settingsFor(1 + random.below(3));
            settings.width = random.below(3) == 0 ? 1 + random.below(100) : kWidth;
            settings.coarse = random.below(4) > 0;
            settings.trace.method = static_cast<Method>(random.below(3));
            session.start(worlds[which], scenes[which].cameras.front(), settings);
        };
        for (int event = 0; event < 700; ++event) {
            switch (random.below(10)) {
            case 0:
                session.stop();
                break;
            case 1:
                session.pause();
                break;
            case 2:
                session.resume();
                break;
            case 3:
                session.read(picture);
                break;
            case 4:
                picture.radiance = session.image();
                for (const Color& c : picture.radiance.values()) ASSERT_TRUE(isFinite(c));
                break;
            case 5:
                session.setFocus({random.uniform(-10, 100), random.uniform(-10, 100)});
                break;
            case 6:
                std::this_thread::sleep_for(std::chrono::microseconds(random.below(2000)));
                break;
            default:
                startAny();
            }
            ASSERT_GE(session.status().passProgress, 0);
            ASSERT_LE(session.status().passProgress, 1);
        }
        session.resume();
        start(session, balls(), settingsFor(2));
        finished(session);
        EXPECT_EQ(session.image(), expected) << threads << " threads";
        session.read(picture);
        EXPECT_EQ(picture.radiance, expected);
    }
}

}
}
