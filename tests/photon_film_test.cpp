// labels: unit threads
// Photons that enter the eye: how many, and the picture that they make.

#include <gtest/gtest.h>

#include "core/study/photon_film.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

class Photons {
public:
    Photons(const Scene& scene, double radius, int width = 1, int height = 1)
        : world(buildWorld(std::make_shared<const Scene>(scene), {})),
          walk(world, scene.cameras.front(),
               lensOf(scene.cameras.front(), world->origin, static_cast<double>(width) / height, radius)),
          film(width, height) {}

    void add(int count, int threads = 2) {
        ThreadPool pool(threads);
        ASSERT_TRUE(film.add(walk, count, pool, {}));
    }

    std::shared_ptr<const World> world;
    PhotonWalk walk;
    PhotonFilm film;
};

Scene lampBefore(double distance) {
    Scene scene = underSky(Color(0));
    scene.lights.push_back(lampAt({0, 0, -distance}));
    look(scene, {0, 0, 0}, {0, 0, -1});
    return scene;
}

TEST(PhotonFilm, TheFractionThatReachesADiscIsItsSolidAngle) {
    constexpr int kPhotons = 400000;
    struct Case {
        double radius, distance;
    };
    for (const auto& [radius, distance] : {Case{0.1, 1}, Case{0.05, 0.4}, Case{0.5, 1}, Case{0.3, 3}}) {
        Photons photons(lampBefore(distance), radius);
        photons.add(kPhotons);
        const double exact = (1 - distance / std::hypot(distance, radius)) / 2;
        const double noise = std::sqrt(exact / kPhotons);
        EXPECT_NEAR(photons.film.tally().fraction(), exact, 4 * noise) << radius << " " << distance;
        if (radius <= 0.1 * distance) {
            EXPECT_NEAR(photons.film.tally().fraction(), radius * radius / (4 * distance * distance),
                        4 * noise + 0.01 * exact);
        }
    }
}

TEST(PhotonFilm, TheFractionGrowsWithTheAreaOfTheLens) {
    Photons small(lampBefore(1), 0.05), large(lampBefore(1), 0.1);
    small.add(400000);
    large.add(400000);
    EXPECT_NEAR(large.film.tally().fraction() / small.film.tally().fraction(), 4, 0.6);
}

TEST(PhotonFilm, TheLensTakesNothingFromBehind) {
    Photons photons(lampBefore(-1), 0.5);
    photons.add(20000);
    EXPECT_EQ(photons.film.tally().reached, 0U);
    EXPECT_EQ(photons.film.tally().escaped, 20000U);
}

TEST(PhotonFilm, WhatIsInTheWayKeepsPhotonsFromTheLens) {
    Scene scene = lampBefore(2);
    add(scene, Sphere{0.5F}, matte(Color(0)), at({0, 0, -1}));
    Photons photons(scene, 0.2);
    photons.add(20000);
    EXPECT_EQ(photons.film.tally().reached, 0U);
    EXPECT_GT(photons.film.tally().absorbed, 0U);
}

/// A dull wall before the eye, and a lamp beside it, which the lens does not see.
Scene wall() {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, matte(Color(0.6F, 0.4F, 0.2F)),
        at({0, 0, -3}) * glm::rotate(DMat4(1), kPiD / 2, DVec3(1, 0, 0)));
    scene.lights.push_back(lampAt({0.5, 0.5, 0.1}, PointLamp{}, 4));
    look(scene, {0, 0, 0}, {0, 0, -3}, 50);
    return scene;
}

TEST(PhotonFilm, ItsPictureHasTheScaleOfTheTracedOne) {
    constexpr int kSide = 4;
    Photons photons(wall(), 1.5, kSide, kSide); // sharp for all that: the wall is in focus
    photons.add(1 << 21);
    const ColorImage seen = photons.film.radiance();
    const Tracing traced(wall(), casting(), 16 * kSide, 16 * kSide);
    const std::vector<Color> fine = traced.radiance();
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            DVec3 mean(0);
            for (int i = 0; i < 256; ++i) {
                const int row = 16 * y + i / 16, column = 16 * x + i % 16;
                mean +=
                    DVec3(
                        fine[static_cast<std::size_t>(row) * 16 * kSide + static_cast<std::size_t>(column)]) /
                    256.0;
            }
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(static_cast<double>(seen.at(x, y)[c]) / mean[c], 1, 0.08) << x << " " << y;
        }
    EXPECT_LE(photons.film.tally().onPicture, photons.film.tally().reached);
}

TEST(PhotonFilm, AllThatIsEmittedIsAbsorbedOrEscapesOrReachesTheLens) {
    Photons photons(wall(), 0.4);
    photons.add(50000);
    const PhotonTally& tally = photons.film.tally();
    EXPECT_EQ(tally.emitted, 50000U);
    EXPECT_EQ(tally.absorbed + tally.escaped + tally.reached, tally.emitted);
    const DVec3 sum = tally.powerAbsorbed + tally.powerEscaped + tally.powerReached;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / tally.powerEmitted[c], 1, 1e-4);
    EXPECT_GT(tally.reached, 50U);
    EXPECT_GT(tally.bounces, 10000U);
}

TEST(PhotonFilm, HasTheSameBitsOnAnyNumberOfThreads) {
    Photons one(wall(), 0.4, 8, 8), three(wall(), 0.4, 8, 8);
    for (const int round : {5000, 1, 3000}) {
        one.add(round, 1);
        three.add(round, 3);
    }
    EXPECT_EQ(one.film.radiance(), three.film.radiance());
    EXPECT_EQ(one.film.tally().powerAbsorbed, three.film.tally().powerAbsorbed);
    ASSERT_EQ(one.film.latest().size(), three.film.latest().size());
    EXPECT_EQ(one.film.latest().size(), PhotonFilm::kLatest);
    EXPECT_EQ(one.film.latestSeen().size(), three.film.latestSeen().size());
}

TEST(PhotonFilm, AStopLeavesItAsItWas) {
    Photons photons(wall(), 0.4);
    photons.add(1000);
    const std::stop_source stop;
    stop.request_stop();
    ThreadPool pool(2);
    EXPECT_FALSE(photons.film.add(photons.walk, 1000000, pool, stop.get_token()));
    EXPECT_EQ(photons.film.tally().emitted, 1000U);
}

}
}
