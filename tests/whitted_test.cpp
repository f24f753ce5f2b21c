// labels: unit
// Recursive ray tracing: energy, depth, switches and cut-offs.

#include <gtest/gtest.h>

#include <thread>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr auto kReflection = RayKind::Reflection;
constexpr auto kRefraction = RayKind::Refraction;

/// The eye between two parallel glowing mirrors.
Scene facingMirrors(float rho) {
    Scene scene = underSky(Color(0));
    TaughtMaterial material = mirror(Color(rho));
    material.emission = Color(1);
    for (const double z : {-2.0, 2.0}) add(scene, Box{{20, 20, 1}}, material, at({0, 0, z}));
    return scene;
}

/// Mirrors, glass, water with a bubble, lamps and a floor: all kinds of rays, over a sky.
Scene stillLife() {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    scene.environment.nadir = Color(0.2F);
    scene.ambient = Color(0.1F);
    add(scene, Plane{20, 20, true}, matte({0.7F, 0.6F, 0.5F}), at({0, -1, -5}));
    add(scene, Sphere{0.8F}, glass(1.5F, {0.95F, 0.9F, 0.95F}, {0.2F, 0.1F, 0}), at({-1, -0.2, -4}));
    add(scene, Sphere{0.8F}, mirror({0.9F, 0.8F, 0.7F}), at({1, -0.2, -5}));
    add(scene, Box{{1, 1, 1}}, glass(1.33F, Color(0.9F)), at({0.2, -0.45, -3}));
    add(scene, Sphere{0.3F}, glass(1), at({0.2, -0.45, -3}));
    add(scene, cases::closedMesh(10, 20, 0.5), matte({0.2F, 0.7F, 0.3F}), at({0, 0.8, -5}));
    scene.lights = {taughtLampAt({3, 4, 0}, Color(0.6F)), lampAt({-2, 3, -3}, SphereLamp{0.3}, 20)};
    return scene;
}

TEST(Whitted, FacingMirrorsAreAGeometricSeries) {
    for (const float rho : {0.5F, 0.8F, 0.9F})
        for (const int depth : {0, 1, 5, 10, 50}) {
            const Tracing tracing(facingMirrors(rho), toDepth(depth));
            const double exact = (1 - std::pow(rho, depth + 1)) / (1 - rho);
            EXPECT_NEAR(tracing.pixel().r, exact, 2e-6 * exact) << rho << " " << depth;
            const RayCounts counts = tracing.tile().counts;
            EXPECT_EQ(counts[kReflection], static_cast<std::uint64_t>(depth));
            EXPECT_EQ(counts.deepest, depth);
        }
}

TEST(Whitted, CutoffDropsTheTailOfTheSeriesAndNoMore) {
    for (const float rho : {0.5F, 0.8F, 0.9F}) {
        TraceSettings settings = toDepth(kMaxDepth);
        settings.cutoff = 1.0F / 255;
        double exact = 0;
        for (double weight = 1; weight >= settings.cutoff; weight *= rho) exact += weight;
        EXPECT_NEAR(Tracing(facingMirrors(rho), settings).pixel().r, exact, 1e-5 * exact) << rho;
        EXPECT_LT(1 / (1 - rho) - exact, settings.cutoff / (1 - rho)) << "the bound";
    }
}

TEST(Whitted, DepthChangesOnlyPixelsWhoseTreeIsThatDeep) {
    constexpr int kWidth = 48, kHeight = 36;
    int shallow = 0, changed = 0;
    for (const int depth : {1, 2, 4, 7}) {
        const Tracing less(stillLife(), toDepth(depth - 1), kWidth, kHeight);
        const Tracing more(stillLife(), toDepth(depth), kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Retrace deep = more.retrace(x, y);
                int deepest = 0;
                for (const RayRecord& ray : deep.rays) deepest = std::max(deepest, ray.depth);
                EXPECT_LE(deepest, depth);
                if (deepest < depth) {
                    EXPECT_EQ(deep.radiance, less.pixel(x, y));
                    ++shallow;
                } else {
                    changed += deep.radiance != less.pixel(x, y) ? 1 : 0;
                }
            }
    }
    EXPECT_GT(shallow, 100);
    EXPECT_GT(changed, 100);
}

TEST(Whitted, GlassBallVanishesInAConstantSky) {
    cases::Random random(1);
    for (const float ior : {1.000277F, 1.33F, 1.5F, 2.42F}) {
        Scene scene = underSky(Color(1));
        add(scene, Sphere{1}, glass(ior));
        for (int i = 0; i < 100; ++i) {
            const DVec3 axis = random.direction(), across = glm::cross(axis, random.direction());
            const DVec3 target = random.uniform(0, 0.99) * glm::normalize(across);
            look(scene, target + 3.0 * axis, target);
            EXPECT_TRUE(isNear(Tracing(scene, toDepth(30)).pixel(), Color(1), 1e-3F)) << ior;
        }
    }
}

TEST(Whitted, GlassBlockVanishesFromInsideToo) {
    cases::Random random(2);
    Scene scene = underSky(Color(1));
    add(scene, Box{{1, 1.2F, 1.3F}}, glass(1.5F));
    for (int i = 0; i < 30; ++i) {
        const DVec3 eye = random.inCube(0.4);
        look(scene, eye, eye + random.direction());
        const Tracing tracing(scene, toDepth(24));
        const Retrace sample = tracing.retrace();
        // Directions beyond the critical angle on all six faces never leave: what is left in the last rays is
        // what is missing.
        double missing = 0;
        for (const RayRecord& ray : sample.rays)
            if (ray.depth == 24 && ray.end == RayEnd::Hit) missing += ray.weight.r;
        EXPECT_NEAR(sample.radiance.r + missing, 1, 1e-5);
    }
}

/// What a slab, seen straight from above, reflects of the zenith (red) and lets through of the nadir (green).
Color slabSeen(double degrees, float ior, float sigmaD) {
    Scene scene = underSky(Color(0));
    scene.environment = {Color(1, 0, 0), Color(0), Color(0, 1, 0)};
    add(scene, Box{{1e4F, 1, 1e4F}}, glass(ior, Color(1), Color(sigmaD)));
    const DVec3 direction(std::sin(radians(degrees)), -std::cos(radians(degrees)), 0);
    look(scene, -3.0 * direction, DVec3(0));
    const double shareOfHorizon = std::sqrt(std::cos(radians(degrees)));
    return Tracing(scene, toDepth(40)).pixel() / static_cast<float>(shareOfHorizon);
}

TEST(Whitted, SlabReflectsAndTransmitsAsTheSumOfAllItsReflections) {
    struct Case {
        double degrees;
        float ior, sigmaD;
        double reflected, transmitted;
    };
    for (const Case& c : {Case{0, 1.5F, 0, 0.076923077, 0.923076923},
                          {0, 1.33F, 0, 0.039329698, 0.960670302},
                          {0, 2.42F, 0, 0.294090193, 0.705909807},
                          {0, 1.5F, 0.5F, 0.053569495, 0.559307869},
                          {30, 1.5F, 0, 1 - 0.920265533, 0.920265533},
                          {60, 1.5F, 0, 1 - 0.836232463, 0.836232463},
                          {80, 1.5F, 0, 1 - 0.441229173, 0.441229173}}) {
        const Color seen = slabSeen(c.degrees, c.ior, c.sigmaD);
        EXPECT_NEAR(seen.r, c.reflected, 1e-5) << c.degrees << "° " << c.ior;
        EXPECT_NEAR(seen.g, c.transmitted, 1e-5) << c.degrees << "° " << c.ior;
    }
}

TEST(Whitted, ConstantWeightsReplaceFresnelAtEveryAngle) {
    TraceSettings settings = toDepth(1);
    settings.fresnel = FresnelMode::Constant;
    TaughtMaterial material = glass(1.5F, Color(0.5F));
    material.reflectivity = Color(0.25F);
    Scene scene = underSky(Color(0));
    scene.environment = {Color(1, 0, 0), Color(1, 0, 0), Color(0, 1, 0)};
    add(scene, Sphere{1}, material);
    for (const double degrees : {0.0, 40.0, 80.0}) {
        const DVec3 spot(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
        look(scene, spot + DVec3(0, 0, 3), spot);
        const Retrace sample = Tracing(scene, settings).retrace();
        ASSERT_EQ(sample.rays.size(), 3U);
        EXPECT_EQ(sample.rays[1].weight, Color(0.25F));
        EXPECT_EQ(sample.rays[2].weight, Color(0.5F));
    }
    settings.fresnel = FresnelMode::Exact;
    look(scene, {0, 0, 3}, {0, 0, 0});
    const Retrace exact = Tracing(scene, settings).retrace();
    EXPECT_TRUE(isNear(exact.rays[1].weight, Color(0.75F * 0.04F), 1e-6F)) << "Fresnel divides kr + kt";
    EXPECT_TRUE(isNear(exact.rays[2].weight, Color(0.75F * 0.96F), 1e-6F));
}

TEST(Whitted, MetalTintsItsMirrorImageButNotAtGrazingAngles) {
    GltfMaterial gold;
    gold.baseColor = {1, 0.77F, 0.34F};
    gold.roughness = 0;
    Scene scene = underSky(Color(1));
    add(scene, Plane{}, gold);
    look(scene, {0, 2, 0}, {0, 0, 0});
    EXPECT_TRUE(isNear(Tracing(scene).pixel(), gold.baseColor, 1e-5F));
    look(scene, {1000, 1, 0}, {0, 0, 0});
    EXPECT_TRUE(isNear(Tracing(scene).pixel(), Color(1), 0.01F));

    scene.materials[0].model = mirror(gold.baseColor);
    EXPECT_EQ(Tracing(scene).pixel(), gold.baseColor) << "a taught mirror has one tint at all angles";
}

TEST(Whitted, RayKindSwitchedOffContributesNothingAndChangesNoOtherPixel) {
    constexpr int kWidth = 48, kHeight = 36;
    for (const RayKind kind : {kReflection, kRefraction, RayKind::Shadow}) {
        TraceSettings settings = toDepth(5);
        (kind == kReflection ? settings.reflections
                             : (kind == kRefraction ? settings.refractions : settings.shadows)) = false;
        const Tracing all(stillLife(), toDepth(5), kWidth, kHeight),
            without(stillLife(), settings, kWidth, kHeight);
        EXPECT_GT(all.tile().counts[kind], 0U);
        EXPECT_EQ(without.tile().counts[kind], 0U);
        int same = 0, changed = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Retrace full = all.retrace(x, y);
                const bool has = std::any_of(full.rays.begin(), full.rays.end(),
                                             [&](const RayRecord& r) { return r.kind == kind; });
                if (!has) {
                    EXPECT_EQ(without.pixel(x, y), full.radiance);
                }
                (without.pixel(x, y) == full.radiance ? same : changed) += 1;
            }
        EXPECT_GT(same, 50) << name(kind);
        EXPECT_GT(changed, 50) << name(kind);
    }
}

TEST(Whitted, PictureIsTheSumOfItsKindsOfRays) {
    const auto picture = [](bool reflections, bool refractions) {
        TraceSettings settings = toDepth(1);
        settings.reflections = reflections;
        settings.refractions = refractions;
        return Tracing(stillLife(), settings, 48, 36).radiance();
    };
    const auto all = picture(true, true), mirrored = picture(true, false), through = picture(false, true),
               local = picture(false, false);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_TRUE(isNear(all[i], mirrored[i] + through[i] - local[i], 1e-5F));
}

TEST(Whitted, ThinPaneBendsNothing) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{10, 10, true}, glass(1.5F, Color(0.8F)), glm::rotate(DMat4(1), 0.7, DVec3(1, 0, 0.2)));
    add(scene, Box{{9, 9, 1}}, glowing(Color(2)), at({0, 0, -5}));
    look(scene, {0, 0, 3}, {0, 0, 0});
    const Retrace sample = Tracing(scene).retrace();
    const RayRecord& eye = sample.rays[0];
    const auto beyond = std::find_if(sample.rays.begin(), sample.rays.end(),
                                     [](const RayRecord& r) { return r.kind == kRefraction; });
    ASSERT_NE(beyond, sample.rays.end());
    EXPECT_EQ(beyond->direction, eye.direction);
    EXPECT_EQ(beyond->radiance, Color(2));
}

TEST(Whitted, RetracedSampleHasTheBitsOfTheTile) {
    constexpr int kWidth = 40, kHeight = 30;
    for (const Method method : {Method::Local, Method::Cast, Method::Whitted}) {
        TraceSettings settings;
        settings.method = method;
        const Tracing tracing(stillLife(), settings, kWidth, kHeight);
        for (const int pass : {0, 1, 5}) {
            const TileResult tile = tracing.tile(pass);
            ASSERT_TRUE(tile.complete);
            RayCounts recorded;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const Retrace sample = tracing.retrace(x, y, pass);
                    ASSERT_EQ(sample.radiance, tile.radiance[static_cast<std::size_t>(y * kWidth + x)]);
                    ASSERT_EQ(sample.radiance, sample.rays.front().radiance);
                    for (const RayRecord& ray : sample.rays) {
                        ++recorded[ray.kind];
                        if (ray.kind != RayKind::Shadow)
                            recorded.deepest = std::max(recorded.deepest, ray.depth);
                    }
                }
            EXPECT_EQ(recorded.rays, tile.counts.rays) << "as many rays on record as counted";
            EXPECT_EQ(recorded.deepest, tile.counts.deepest);
            EXPECT_EQ(tile.counts[RayKind::Eye], static_cast<std::uint64_t>(kWidth * kHeight));
            EXPECT_EQ(tile.counts.invalidSamples, 0U);
            EXPECT_EQ(tile.counts.truncatedSamples, 0U);
        }
    }
}

TEST(Whitted, WeightsAndRadiancesOfTheRecordAddUpToThePixel) {
    constexpr int kWidth = 32, kHeight = 24;
    const Tracing tracing(stillLife(), toDepth(4), kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Retrace sample = tracing.retrace(x, y);
            for (std::size_t i = 1; i < sample.rays.size(); ++i) {
                const RayRecord& ray = sample.rays[i];
                ASSERT_LT(ray.parent, static_cast<int>(i)) << "a parent comes first";
                const RayRecord& parent = sample.rays[static_cast<std::size_t>(ray.parent)];
                EXPECT_EQ(ray.depth, parent.depth + (ray.kind == RayKind::Shadow ? 0 : 1));
                EXPECT_NEAR(glm::length(ray.direction), 1, 1e-5);
                if (ray.kind == RayKind::Shadow) continue;
                for (int c = 0; c < 3; ++c) EXPECT_LE(ray.weight[c], parent.weight[c] * (1 + 1e-6F));
            }
            // Of rays that end in the sky the weight times the radiance reaches the eye.
            Color fromSky(0);
            for (const RayRecord& ray : sample.rays)
                if (ray.end == RayEnd::Background) fromSky += ray.weight * ray.radiance;
            for (int c = 0; c < 3; ++c) EXPECT_LE(fromSky[c], sample.radiance[c] * (1 + 1e-5F));
        }
}

/// A room of mirrors with a glass ball in it: rays double at every bounce and none gets lost.
Scene hallOfMirrors() {
    Scene scene = underSky(Color(1));
    add(scene, Box{{4, 4, 4}}, mirror(Color(1)));
    TaughtMaterial half = glass(1.5F, Color(1));
    half.reflectivity = Color(1);
    add(scene, Sphere{1}, half);
    look(scene, {0.3, 0.2, 1.9}, {0, 0, 0}, 90);
    return scene;
}

TEST(Whitted, TreeOfRaysIsCutAtItsBudgetAndCounted) {
    const Tracing tracing(hallOfMirrors(), toDepth(kMaxDepth), 3, 2);
    const TileResult tile = tracing.tile();
    EXPECT_TRUE(tile.complete);
    EXPECT_EQ(tile.counts.truncatedSamples, 6U);
    EXPECT_EQ(tile.counts.total(), 6U * (kMaxTreeNodes + 1));
    EXPECT_EQ(tile.counts.invalidSamples, 0U);
}

TEST(Whitted, StopEndsATileThatWouldTakeForEver) {
    const auto world = Tracing(hallOfMirrors()).context().world;
    const std::stop_source stop;
    const Tracing tracing(world, toDepth(kMaxDepth), 2000, 2000, stop.get_token());
    TileResult tile;
    std::jthread worker([&] { tile = tracing.tile(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop.request_stop();
    worker.join();
    EXPECT_FALSE(tile.complete);
    EXPECT_LT(tile.radiance.size(), 4'000'000U);
}

TEST(Whitted, InvalidSampleIsBlackAndCounted) {
    Scene scene = underSky(Color(std::numeric_limits<float>::quiet_NaN()));
    add(scene, Sphere{1}, mirror(Color(1)), at({0, 0, -3}));
    const TileResult tile = Tracing(scene, toDepth(2), 4, 4).tile();
    EXPECT_EQ(tile.counts.invalidSamples, 16U);
    for (const Color& c : tile.radiance) EXPECT_EQ(c, Color(0));
}

TEST(Tiles, CoarseOnesTraceTheMiddleOfEachBlock) {
    constexpr int kWidth = 37, kHeight = 21, kStep = 8;
    const Tracing tracing(stillLife(), toDepth(3), kWidth, kHeight);
    const TileResult coarse =
        tracing.integrator().renderTile(tracing.context(), {0, 0, kWidth, kHeight, kStep}, 0);
    std::size_t next = 0;
    for (int y = 0; y < kHeight; y += kStep)
        for (int x = 0; x < kWidth; x += kStep) {
            const int px = std::min(x + kStep / 2, kWidth - 1), py = std::min(y + kStep / 2, kHeight - 1);
            ASSERT_LT(next, coarse.radiance.size());
            EXPECT_EQ(coarse.radiance[next++], tracing.pixel(px, py));
        }
    EXPECT_EQ(next, coarse.radiance.size());
}

}
}
