// labels: unit
// What the benchmarks measure with: rays of each kind, their tracing, and the figures of a series.

#include <gtest/gtest.h>

#include "core/study/ray_bench.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kSide = 64;

Scene balls() {
    Scene scene = underSky(Color(0));
    cases::Random random(1);
    for (int i = 0; i < 50; ++i)
        add(scene, Sphere{0.4F}, matte(Color(1)), at(DVec3(0, 0, -8) + random.inCube(2)));
    add(scene, Plane{}, matte(Color(1)), at({0, -3, 0}));
    scene.lights = {lampAt({3, 5, -4})};
    return scene;
}

std::shared_ptr<const World> worldOf(const Scene& scene, AccelKind kind) {
    return buildWorld(std::make_shared<const Scene>(scene), {kind});
}

TEST(RaySets, HoldTheEyeRaysOfThePictureAndOneOfEachOtherKindForEachHit) {
    const Scene scene = balls();
    const auto world = worldOf(scene, AccelKind::Bvh8);
    const auto sets = raySets(*world, scene.cameras.front(), kSide);
    ASSERT_EQ(sets.size(), 4U);
    const std::size_t hits = [&] {
        ThreadPool pool(1);
        return trace(*world->accel, sets[0], pool).hits;
    }();
    EXPECT_EQ(sets[0].rays.size(), 4096U);
    EXPECT_GT(hits, 1000U);
    for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_EQ(sets[i].rays.size(), hits);
    const EyeRays eyeRays(scene.cameras.front(), world->origin, kSide, kSide);
    EXPECT_EQ(sets[0].rays[0].direction, eyeRays.through(0, 0, Vec2(0.5F)).direction);
    EXPECT_EQ(sets[0].rays[5].direction, eyeRays.through(1, 1, Vec2(0.5F)).direction) << "in squares of 4";
    EXPECT_EQ(sets[0].rays[16].direction, eyeRays.through(4, 0, Vec2(0.5F)).direction);
    EXPECT_EQ(sets[0].rays[64].direction, eyeRays.through(8, 0, Vec2(0.5F)).direction) << "and blocks of 8";
    EXPECT_EQ(sets[0].rays.back().direction, eyeRays.through(63, 63, Vec2(0.5F)).direction);
    for (const RaySet& set : sets)
        for (const Ray& ray : set.rays) ASSERT_NEAR(glm::length(ray.direction), 1, 1e-5);
}

TEST(RaySets, ShadowRaysEndAtTheLamp) {
    const Scene scene = balls();
    const auto world = worldOf(scene, AccelKind::Bvh8);
    const auto sets = raySets(*world, scene.cameras.front(), kSide);
    EXPECT_TRUE(sets[1].anyHit);
    for (const Ray& ray : sets[1].rays)
        ASSERT_LT(glm::distance(ray.at(ray.tMax), world->lights[0].position), 1e-4F);
}

TEST(RaySets, AreHitAlikeByEveryIndexOnAnyNumberOfThreads) {
    const Scene scene = balls();
    const auto brute = worldOf(scene, AccelKind::Brute);
    ThreadPool one(1), three(3);
    for (const RaySet& set : raySets(*brute, scene.cameras.front(), kSide)) {
        const std::size_t hits = trace(*brute->accel, set, one).hits;
        for (const AccelKind kind : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8})
            for (ThreadPool* pool : {&one, &three})
                EXPECT_EQ(trace(*worldOf(scene, kind)->accel, set, *pool).hits, hits) << name(set.kind);
    }
}

TEST(RaySets, MeetEveryPrimitiveByBruteForceAndFewByATree) {
    const Scene scene = balls();
    const auto brute = worldOf(scene, AccelKind::Brute), tree = worldOf(scene, AccelKind::Bvh8);
    const RaySet eye = raySets(*brute, scene.cameras.front(), kSide).front();
    const TraversalCounts all = countTraversal(*brute->accel, eye), few = countTraversal(*tree->accel, eye);
    EXPECT_EQ(all.primitives, 51 * eye.rays.size());
    EXPECT_EQ(all.nodes, 0U);
    EXPECT_LT(few.primitives, all.primitives / 5);
    EXPECT_GT(few.nodes, 0U);
}

TEST(RaySets, OfASceneWithoutLampOrHitAreThereToo) {
    Scene scene = underSky(Color(0));
    EXPECT_EQ(raySets(*worldOf(scene, AccelKind::Brute), scene.cameras.front(), 8)[3].rays.size(), 0U);
    add(scene, Sphere{1}, matte(Color(1)), at({0, 0, -3}));
    EXPECT_GT(raySets(*worldOf(scene, AccelKind::Brute), scene.cameras.front(), 8)[1].rays.size(), 0U);
}

TEST(Thinned, TakesWholeBlocksEvenlySpreadAndAtLeastOne) {
    std::vector<Ray> rays(1000); // 15 blocks of 64, and 40
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].tMin = static_cast<float>(i);
    EXPECT_EQ(thinned(rays, 5000).size(), 1000U);
    EXPECT_EQ(thinned(rays, 0).size(), 64U);
    std::vector<Ray> picture(std::size_t{64} * 1024); // 32 blocks in each of 32 rows
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i].tMin = static_cast<float>(i);
    const auto some = thinned(picture, std::size_t{64} * 32);
    ASSERT_EQ(some.size(), 64U * 32U);
    double column = 0;
    for (std::size_t block = 0; block < 32; ++block) {
        const auto first = static_cast<std::size_t>(some[block * 64].tMin);
        EXPECT_EQ(first % 64, 0U);
        EXPECT_EQ(first / 64 / 32, block) << "one from each row";
        EXPECT_EQ(some[block * 64 + 63].tMin, static_cast<float>(first + 63));
        column += static_cast<double>(first / 64 % 32) / 32;
    }
    EXPECT_NEAR(column, 15.5, 6) << "from any column";
}

TEST(Series, HasItsMedianAndHalfItsInterquartileRange) {
    const Series series = seriesOf({9, 1, 3, 7, 5, 11, 13});
    EXPECT_EQ(series.median, 7);
    EXPECT_EQ(series.spread, 4) << "from 3 to 11";
    EXPECT_EQ(seriesOf({4}).median, 4);
    EXPECT_EQ(seriesOf({4}).spread, 0);
    const std::vector<double> values = {1, 2, 3, 4};
    EXPECT_EQ(percentile(values, 0.5), 2);
    EXPECT_EQ(percentile(values, 0.95), 4);
    EXPECT_EQ(percentile(values, 0), 1);
}

}
}
