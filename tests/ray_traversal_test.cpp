// labels: unit
// The work that recorded rays made for the index: against what brute force must do, counted by hand.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/study/layer_film.h"
#include "core/study/ray_traversal.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 32, kHeight = 24;
constexpr std::uint64_t kWalls = 4; // opaque things that are in no ray's way

/// A ball of glass, then walls, then a floor; the camera looks straight down at the floor past the ball, and
/// the lamp's light comes to where it looks through the ball.
Scene glassBeforeLamp() {
    Scene scene = underSky(Color(0.2F));
    add(scene, Sphere{1}, glass(1.5F, Color(0.9F)), at({3, 3, 0}));
    for (std::uint64_t i = 0; i < kWalls; ++i)
        add(scene, Sphere{0.5F}, matte(Color(0.5F)), at({-5 - 2.0 * static_cast<double>(i), 0, 0}));
    add(scene, Plane{}, matte(Color(0.5F)));
    look(scene, {0, 5, 0}, {0, 0, 0});
    scene.cameras.front().up = DVec3(0, 0, -1);
    scene.lights.push_back(lampAt({6, 6, 0}));
    return scene;
}

/// A mesh that mirrors, over a floor, lit by two lamps.
Scene meshes() {
    Scene scene = underSky(Color(0.4F));
    add(scene, cases::closedMesh(20, 30, 1, 0.2), mirror(Color(0.6F)), at({0, 1.2, 0}));
    add(scene, cases::closedMesh(10, 12, 0.5), matte(Color(0.6F)), at({1.5, 0.5, 0.5}));
    add(scene, Plane{}, matte(Color(0.5F)));
    look(scene, {0, 2, 6}, {0, 1, 0});
    scene.lights.push_back(lampAt({3, 6, 3}));
    scene.lights.push_back(lampAt({-3, 5, 2}));
    return scene;
}

int shadowRay(const SampleRecord& record) {
    for (std::size_t i = 0; i < record.rays.size(); ++i)
        if (record.rays[i].kind == RayKind::Shadow) return static_cast<int>(i);
    return -1;
}

TEST(RayTraversal, OfAShadowRayThroughGlassIsEveryQuestionOfItsPolicy) {
    struct Case {
        GlassShadows policy;
        std::uint64_t tests;
    };
    // the endless floor comes first, then the glass; of the glass front, back, and nothing beyond
    constexpr std::uint64_t kAny = 2, kOpaque = kWalls + 1, kGlass = 3;
    for (const Case& c : {Case{GlassShadows::AllBlock, kAny}, Case{GlassShadows::OpaqueOnly, kAny + kOpaque},
                          Case{GlassShadows::Straight, kAny + kOpaque + kGlass}}) {
        TraceSettings settings = toDepth(3);
        settings.glassShadows = c.policy;
        const Tracing tracing(glassBeforeLamp(), settings, 1, 1, AccelKind::Brute);
        const Retrace trace = tracing.retrace();
        const int ray = shadowRay(trace);
        ASSERT_EQ(ray, 1);
        EXPECT_EQ(traversalOf(tracing.world(), settings, trace, ray), (TraversalCounts{0, 0, c.tests}));
        EXPECT_EQ(traversalOf(tracing.world(), settings, trace, 0).primitives, tracing.world().primitives);
    }
}

TEST(RayTraversal, OfAShadowRayOfAPathIsOneQuestion) {
    TraceSettings settings = toDepth(1);
    settings.method = Method::Path;
    const Tracing tracing(glassBeforeLamp(), settings, 1, 1, AccelKind::Brute);
    const Retrace trace = tracing.retrace();
    const auto shadows = std::ranges::find(trace.rays, RayKind::Shadow, &RayRecord::kind);
    ASSERT_NE(shadows, trace.rays.end());
    ASSERT_EQ(shadows->end, RayEnd::Blocked) << "glass blocks it";
    // the floor, which comes first, then the glass
    EXPECT_EQ(traversalOf(tracing.world(), settings, trace, static_cast<int>(shadows - trace.rays.begin())),
              (TraversalCounts{0, 0, 2}));
}

TEST(RayTraversal, WithoutAnIndexEveryRayButABlockedShadowRayIsTestedAgainstAll) {
    const Tracing tracing(meshes(), toDepth(4), kWidth, kHeight, AccelKind::Brute);
    int blocked = 0, others = 0;
    for (int y = 0; y < kHeight; y += 2)
        for (int x = 0; x < kWidth; x += 2) {
            const Retrace trace = tracing.retrace(x, y);
            for (std::size_t i = 0; i < trace.rays.size(); ++i) {
                const auto counts =
                    traversalOf(tracing.world(), tracing.context().settings, trace, static_cast<int>(i));
                const bool stops = trace.rays[i].end == RayEnd::Blocked;
                ++(stops ? blocked : others);
                if (stops)
                    EXPECT_LE(counts.primitives, tracing.world().primitives);
                else
                    EXPECT_EQ(counts, (TraversalCounts{0, 0, tracing.world().primitives}));
            }
        }
    EXPECT_GT(blocked, 10);
    EXPECT_GT(others, 300);
}

TEST(RayTraversal, OfASampleIsTheSumOfItsRaysAndFarLessThanBruteForce) {
    for (const AccelKind kind : {AccelKind::Bvh2, AccelKind::Bvh8}) {
        const Tracing tracing(meshes(), toDepth(4), kWidth, kHeight, kind);
        std::size_t rays = 0;
        TraversalCounts all;
        for (int x = 0; x < kWidth; ++x) {
            const Retrace trace = tracing.retrace(x, kHeight / 2);
            TraversalCounts sum;
            for (std::size_t i = 0; i < trace.rays.size(); ++i)
                sum += traversalOf(tracing.world(), tracing.context().settings, trace, static_cast<int>(i));
            EXPECT_EQ(traversalOf(tracing.world(), tracing.context().settings, trace), sum);
            all += sum;
            rays += trace.rays.size();
        }
        EXPECT_GE(all.boxes, rays);
        EXPECT_LT(10 * all.primitives, rays * tracing.world().primitives);
    }
}

TEST(RayTraversal, LayersOfVisitsAndTestsHoldThoseOfEachPixelsRays) {
    const Tracing tracing(meshes(), toDepth(4), kWidth, kHeight, AccelKind::Bvh8);
    const Scene& scene = *tracing.world().scene;
    LayerFilm film({layerNamed("visits", scene), layerNamed("tests", scene)}, kWidth, kHeight);
    ThreadPool pool(2);
    for (int pass = 0; pass < 2; ++pass)
        ASSERT_TRUE(film.addPass(tracing.context(), tracing.integrator(), pass, pool));
    const ColorImage visits = film.image(0).values, tests = film.image(1).values;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            TraversalCounts sum;
            for (int pass = 0; pass < 2; ++pass)
                sum += traversalOf(tracing.world(), tracing.context().settings, tracing.retrace(x, y, pass));
            EXPECT_EQ(visits.at(x, y).x, static_cast<float>(sum.nodes) / 2);
            EXPECT_EQ(tests.at(x, y).x, static_cast<float>(sum.primitives) / 2);
        }
}

TEST(RayTraversal, WithoutAnIndexTheLayerOfTestsOfCastEyeRaysIsTheNumberOfPrimitives) {
    TraceSettings settings = casting();
    settings.shadows = false;
    const Tracing tracing(meshes(), settings, kWidth, kHeight, AccelKind::Brute);
    const Scene& scene = *tracing.world().scene;
    LayerFilm film({layerNamed("visits", scene), layerNamed("tests", scene)}, kWidth, kHeight);
    ThreadPool pool(1);
    ASSERT_TRUE(film.addPass(tracing.context(), tracing.integrator(), 0, pool));
    const auto n = static_cast<float>(tracing.world().primitives);
    EXPECT_EQ(film.image(0).values, ColorImage(kWidth, kHeight, Color(0)));
    EXPECT_EQ(film.image(1).values, ColorImage(kWidth, kHeight, Color(n)));
}

TEST(RayTraversal, IsToldInALine) {
    const Tracing tree(meshes(), toDepth(1), 1, 1, AccelKind::Bvh8),
        all(meshes(), toDepth(1), 1, 1, AccelKind::Brute);
    EXPECT_EQ(traversalText({2, 9, 1234}, tree.world()),
              "bvh8: 9 boxes in 2 nodes, then 1 234 of 1 357 primitives");
    EXPECT_EQ(traversalText({0, 0, 1357}, all.world()), "no index: 1 357 of 1 357 primitives");
}

}
}
