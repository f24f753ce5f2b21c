// labels: unit
// What path tracing and distributed ray tracing have in common: closed forms, each other, Whitted's method,
// and samples that are told to the bit.

#include <gtest/gtest.h>

#include "core/render/render_session.h"
#include "core/study/ledger.h"
#include "tests/random_methods.h"

namespace eyeray {
namespace {

using namespace scenes;

TEST(PhysicalMethods, SeeConvexBodiesInAWhiteSkyAsTheirAlbedo) {
    for (const Method method : kPhysical) {
        for (const float albedo : {0.5F, 1.0F}) {
            Scene scene = underSky(Color(1));
            look(scene, {0, 0, 0}, {0.1, 0.2, -1}, 1);
            add(scene, Sphere{1}, matte(Color(albedo)), at({0, 0, -3}));
            expectMean(estimate(Tracing(scene, by(method)), 8000), albedo, 1e-4);
        }
        GltfMaterial chalk;
        chalk.metallic = 0;
        chalk.roughness = 0.4F;
        Scene coated = underSky(Color(1));
        look(coated, {0, 0, 0}, {0.1, 0.2, -1}, 1);
        add(coated, Sphere{1}, chalk, at({0.5, 0, -3}));
        const Estimate e = estimate(Tracing(coated, by(method)), 4000);
        EXPECT_LE(e.mean.x, 1.0005 + 3.5 * e.error);
        EXPECT_GE(e.mean.x, 0.985 - 3.5 * e.error);
    }
}

TEST(PhysicalMethods, SeeNoGlassBallInAWhiteSky) {
    for (const Method method : kPhysical) {
        Scene scene = underSky(Color(1));
        add(scene, Sphere{1}, glass(1.5F), at({0.4, 0.2, -3}));
        const TraceSettings settings = by(method, 40);
        EXPECT_NEAR(estimate(Tracing(scene, settings), 200).mean.x, 1, 2e-3);
    }
}

TEST(PhysicalMethods, ReadTheRadianceOfALampThatTheyLookAt) {
    for (const Method method : kPhysical) {
        Scene scene = underSky(Color(0));
        scene.lights = {lampAt({0, 0, -3}, SphereLamp{0.5}, 7)};
        add(scene, Sphere{0.1F}, matte(Color(1)), at({3, 0, -3}));
        EXPECT_NEAR(Tracing(scene, by(method)).pixel().r, 7, 1e-5F);
    }
}

TEST(PhysicalMethods, LightAFloorByAPointLampAsTheClosedForm) {
    for (const Method method : kPhysical) {
        Scene scene = floorBelow(0.5F);
        scene.lights = {lampAt({0, 2, 0}, PointLamp{}, 10)};
        EXPECT_NEAR(Tracing(scene, by(method)).pixel().r, 0.397887358, 1e-5F);
        scene.lights = {lampAt({3, 2, 0}, PointLamp{}, 10)};
        EXPECT_NEAR(Tracing(scene, by(method)).pixel().r, 0.067910214, 1e-5F);
        scene.lights = {taughtLampAt({0, 9, 0})};
        EXPECT_NEAR(Tracing(scene, by(method)).pixel().r, 0.5, 1e-5F) << "kd, as in the lectures";
    }
}

TEST(PhysicalMethods, LightAFloorByLampsWithAnExtentAsTheClosedForm) {
    struct LampCase {
        Light lamp;
        double irradiance;
    };
    Light ceiling = lampAt({0, 1, 0}, RectangleLamp{1, 1});
    ceiling.transform = ceiling.transform * facing({0, -1, 0});
    // Of a disc of radius R above: π R²/(R² + h²), also where it is near.
    const auto disc = [](double radius, double height) {
        Light lamp = lampAt({0, height, 0}, DiscLamp{radius});
        lamp.transform = lamp.transform * facing({0, -1, 0});
        return LampCase{lamp, kPiD * radius * radius / (radius * radius + height * height)};
    };
    for (const Method method : kPhysical)
        for (const auto& [lamp, irradiance] :
             {LampCase{ceiling, 0.752274688}, LampCase{lampAt({0, 2, 0}, SphereLamp{1}), 0.785398163},
              LampCase{lampAt({2, 0, 0}, SphereLamp{1}), 0.090586074},
              LampCase{lampAt({0, 5, 0}, SphereLamp{0.5}), 0.031415927}, disc(0.5, 3), disc(1, 1),
              disc(2, 0.2)}) {
            Scene scene = floorBelow(0.5F);
            scene.cameras.front().eye.y = 0.05; // below the lamps
            scene.lights = {lamp};
            expectMean(estimate(Tracing(scene, by(method)), 8000), 0.5 * irradiance / kPiD, 1e-5);
        }
}

/// Mirrors, point lamps and a matte floor.
Scene hallOfMirrors() {
    Scene scene = underSky(Color(0));
    add(scene, Plane{30, 30, true}, matte({0.7F, 0.6F, 0.5F}), at({0, -1, -5}));
    add(scene, Sphere{0.8F}, mirror({0.9F, 0.8F, 0.7F}), at({1, -0.2, -5}));
    add(scene, Sphere{0.6F}, mirror(Color(1)), at({-1, -0.4, -4}));
    TaughtMaterial tiles = matte({0.2F, 0.4F, 0.3F});
    tiles.reflectivity = Color(0.5F);
    add(scene, Box{{8, 4, 0.2F}}, tiles, at({0, 1, -9}));
    scene.lights = {taughtLampAt({3, 4, 0}, Color(0.6F)), lampAt({-2, 3, -3}, PointLamp{}, 20)};
    return scene;
}

TEST(PhysicalMethods, AreWhittedsMethodForMirrorsAndPointLamps) {
    for (const int depth : {0, 2, 6}) {
        const Tracing whitted(hallOfMirrors(), by(Method::Whitted, depth), 48, 32);
        const auto truth = whitted.radiance();
        const auto distributed = Tracing(hallOfMirrors(), by(Method::Distributed, depth), 48, 32).radiance();
        for (std::size_t i = 0; i < truth.size(); ++i)
            ASSERT_TRUE(isNear(truth[i], distributed[i], 2e-5F * (1 + maxComponent(truth[i])))) << i;

        // Path tracing draws between mirror and body where a surface has both; its mean over them is the
        // same.
        TraceSettings settings = by(Method::Path, depth);
        settings.diffuse = false;
        Scene scene = hallOfMirrors();
        scene.objects.pop_back();
        const auto pure = Tracing(scene, by(Method::Whitted, depth), 48, 32).radiance();
        const auto path = Tracing(scene, settings, 48, 32).radiance();
        for (std::size_t i = 0; i < pure.size(); ++i)
            ASSERT_TRUE(isNear(pure[i], path[i], 2e-5F * (1 + maxComponent(pure[i])))) << i;
    }
}

TEST(PhysicalMethods, RetracedSampleHasTheBitsOfTheTileAndOfItsLedger) {
    for (const Method method : kPhysical) {
        const Tracing tracing(showroom(), by(method, 6), 24, 18);
        for (int pass = 0; pass < 6; ++pass) {
            const auto radiance = tracing.radiance(pass);
            for (int y = 0; y < 18; ++y)
                for (int x = 0; x < 24; ++x) {
                    const Retrace retrace = tracing.retrace(x, y, pass);
                    ASSERT_EQ(retrace.radiance, radiance[static_cast<std::size_t>(y * 24 + x)]);
                    ASSERT_EQ(evaluate(ledgerOf(retrace)), retrace.radiance) << x << " " << y << " " << pass;
                }
        }
    }
}

TEST(PhysicalMethods, SampleIsTheFlatSumOfItsTermsTimesTheirWeights) {
    for (const Method method : kPhysical) {
        const Tracing tracing(showroom(), by(method, 6), 24, 18);
        for (int x = 0; x < 24; ++x) {
            const Retrace retrace = tracing.retrace(x, 11, 3);
            Color sum(0);
            for (const RayRecord& ray : retrace.rays)
                if (ray.kind != RayKind::Shadow)
                    sum += ray.weight * ray.transmitted *
                           (ray.end == RayEnd::Hit ? ray.hit.emission : ray.background);
            for (const LampTerm& lamp : retrace.lamps) {
                const RayRecord& ray = retrace.rays[static_cast<std::size_t>(lamp.ray)];
                sum += ray.weight * ray.transmitted * lamp.radiance;
            }
            EXPECT_TRUE(isNear(sum, retrace.radiance, 1e-5F * (1 + maxComponent(sum))));
        }
    }
}

TEST(PhysicalMethods, AgreeWhereNoLightGoesBetweenDiffuseSurfaces) {
    TraceSettings path = by(Method::Path, 4);
    path.diffuse = false;
    TraceSettings distributed = by(Method::Distributed, 4);
    distributed.glassShadows = GlassShadows::AllBlock;
    constexpr int kWidth = 8, kHeight = 6, kPasses = 3000;
    const Tracing a(showroom(), path, kWidth, kHeight), b(showroom(), distributed, kWidth, kHeight);
    DVec3 sumA(0), sumB(0);
    for (int pass = 0; pass < kPasses; ++pass) {
        for (const Color& c : a.radiance(pass)) sumA += DVec3(c);
        if (pass < kPasses / 4)
            for (const Color& c : b.radiance(pass)) sumB += 4.0 * DVec3(c);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sumA[c], sumB[c], 0.01 * sumB[c]) << c;
}

TEST(PhysicalMethods, RayKindSwitchedOffContributesNothingAndCountsNone) {
    for (const Method method : kPhysical)
        for (const RayKind kind : {RayKind::Reflection, RayKind::Refraction, RayKind::Diffuse}) {
            TraceSettings settings = by(method, 4);
            if (kind == RayKind::Reflection) settings.reflections = false;
            if (kind == RayKind::Refraction) settings.refractions = false;
            if (kind == RayKind::Diffuse) settings.diffuse = false;
            const RayCounts counts = Tracing(showroom(), settings, 24, 18).tile(1).counts;
            EXPECT_EQ(counts[kind], 0U);
            EXPECT_LE(counts.deepest, 4);
            EXPECT_EQ(counts.invalidSamples, 0U);
        }
    const RayCounts counts = Tracing(showroom(), by(Method::Path, 4), 24, 18).tile(1).counts;
    for (const RayKind kind : {RayKind::Reflection, RayKind::Refraction, RayKind::Diffuse})
        EXPECT_GT(counts[kind], 0U);
}

ColorImage renderedBy(int threads, Method method) {
    RenderSettings settings;
    settings.width = 70;
    settings.height = 50;
    settings.trace = by(method, 4);
    settings.stop = {.samples = 3};
    RenderSession session(threads);
    const auto scene = std::make_shared<const Scene>(showroom());
    session.start(buildWorld(scene, {}), scene->cameras.front(), settings);
    while (session.wait(std::chrono::seconds(1)).active()) {
    }
    return session.image();
}

TEST(PhysicalMethods, HaveTheSameBitsOnAnyNumberOfThreads) {
    for (const Method method : kPhysical) EXPECT_EQ(renderedBy(1, method), renderedBy(8, method));
}

TEST(Distributed, PenumbraOfAStripHasTheVisibleShareOfTheLamp) {
    // A half plane at half the lamp's height, above the middle of what is seen: half of the lamp is hidden.
    Scene scene = floorBelow(1);
    scene.cameras.front().eye.y = 0.05;
    Light lamp = lampAt({0, 2, 0}, RectangleLamp{1, 1});
    lamp.transform = lamp.transform * facing({0, -1, 0});
    scene.lights = {lamp};
    const double whole = estimate(Tracing(scene, by(Method::Distributed)), 2000).mean.x;
    add(scene, Box{{10, 0.01F, 10}}, matte(Color(0)), at({5, 1, 0}));
    expectMean(estimate(Tracing(scene, by(Method::Distributed)), 4000), whole / 2, 2e-3 * whole);
}

}
}
