// labels: unit
// Path tracing and distributed ray tracing against closed forms, against each other, against Whitted's method
// and against a path tracer that knows no lamps.

#include <gtest/gtest.h>

#include <random>

#include "core/render/render_session.h"
#include "core/study/ledger.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TraceSettings by(Method method, int depth = 5) {
    TraceSettings settings = toDepth(depth);
    settings.method = method;
    return settings;
}
constexpr std::array kPhysical = {Method::Distributed, Method::Path};

/// Mean of the first pixel over passes, with the standard error of its red.
struct Estimate {
    DVec3 mean{0};
    double error = 0;
};
Estimate estimate(const Tracing& tracing, int passes) {
    DVec3 sum(0);
    double squares = 0;
    for (int pass = 0; pass < passes; ++pass) {
        const DVec3 c(tracing.tile(pass).radiance.front());
        sum += c;
        squares += c.x * c.x;
    }
    const DVec3 mean = sum / static_cast<double>(passes);
    return {mean, std::sqrt(std::max(0.0, squares / passes - mean.x * mean.x) / passes)};
}

void expectMean(const Estimate& e, double truth, double tolerance, const std::string& what = {}) {
    EXPECT_NEAR(e.mean.x, truth, 3.5 * e.error + tolerance) << what << " ± " << e.error;
    EXPECT_LT(e.error, 0.02 * truth + tolerance) << what << ": too noisy to tell";
}

/// A large floor of the albedo seen from straight above.
Scene floorBelow(float albedo, const Color& sky = Color(0)) {
    Scene scene = underSky(sky);
    add(scene, Plane{}, matte(Color(albedo)));
    look(scene, {0, 0.5, 0}, {0, 0, 0}, 0.01);
    return scene;
}

TEST(Path, InAGlowingBoxIsAGeometricSeries) {
    for (const float rho : {0.5F, 0.8F})
        for (const int depth : {0, 1, 5, 20}) {
            Scene scene = underSky(Color(0));
            TaughtMaterial wall = matte(Color(rho));
            wall.emission = Color(1);
            add(scene, Box{{2, 3, 4}}, wall);
            const double exact = (1 - std::pow(rho, depth + 2)) / (1 - rho);
            expectMean(estimate(Tracing(scene, by(Method::Path, depth)), 2000), exact, 1e-5);
        }
}

TEST(Path, RouletteKeepsTheMeanOfLongPaths) {
    Scene scene = underSky(Color(0));
    TaughtMaterial wall = matte(Color(0.9F));
    wall.emission = Color(1);
    add(scene, Sphere{1}, wall);
    expectMean(estimate(Tracing(scene, by(Method::Path, kMaxDepth)), 20000), 10, 0.02);
}

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
        TraceSettings settings = by(method, 40);
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
    for (const Method method : kPhysical)
        for (const auto& [lamp, irradiance] :
             {LampCase{ceiling, 0.752274688}, LampCase{lampAt({0, 2, 0}, SphereLamp{1}), 0.785398163},
              LampCase{lampAt({2, 0, 0}, SphereLamp{1}), 0.090586074},
              LampCase{lampAt({0, 5, 0}, SphereLamp{0.5}), 0.031415927}}) {
            Scene scene = floorBelow(0.5F);
            scene.cameras.front().eye.y = 0.05; // below the lamps
            scene.lights = {lamp};
            expectMean(estimate(Tracing(scene, by(method)), 8000), 0.5 * irradiance / kPiD, 1e-5);
        }
}

TEST(Path, InASphereWithALampIsTheIntegratingSphere) {
    for (const float rho : {0.5F, 0.8F}) {
        Scene scene = underSky(Color(0));
        add(scene, Sphere{1}, matte(Color(rho)));
        scene.lights = {lampAt({0, 0, 0})};
        const double indirect = rho * rho / (1 - rho) / kPiD; // Φ = 4π: ρ²/(1 − ρ) Φ/(4π²)
        expectMean(estimate(Tracing(scene, by(Method::Path, 60)), 20000), rho / kPiD + indirect, 1e-3);
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

/// A box with a lamp in its ceiling, a red wall and two blocks, one of them a rough metal.
Scene cornell(const Color& sky = Color(0)) {
    Scene scene = underSky(sky);
    const auto wall = [&](const DVec3& size, const DVec3& center, const Color& color) {
        add(scene, Box{Vec3(size)}, matte(color), at(center));
    };
    wall({2, 0.1, 2}, {0, -1.05, 0}, Color(0.7F));
    wall({2, 0.1, 2}, {0, 1.05, 0}, Color(0.7F));
    wall({0.1, 2, 2}, {-1.05, 0, 0}, {0.7F, 0.1F, 0.1F});
    wall({0.1, 2, 2}, {1.05, 0, 0}, {0.1F, 0.6F, 0.1F});
    wall({2, 2, 0.1}, {0, 0, -1.05}, Color(0.7F));
    wall({0.6, 0.6, 0.6}, {0.4, -0.7, 0.2}, Color(0.8F));
    wall({0.5, 1.2, 0.5}, {-0.4, -0.4, -0.4}, {0.3F, 0.3F, 0.7F});
    Light lamp = lampAt({0, 0.99, 0}, RectangleLamp{0.8, 0.8}, 5);
    lamp.transform = lamp.transform * facing({0, -1, 0});
    scene.lights = {lamp};
    look(scene, {0, 0, 3.6}, {0, 0, 0}, 38);
    return scene;
}

/// Path tracing that knows no lamps: cosine-weighed directions until something glows.
Color blindPath(const World& world, Ray ray, int maxDepth, std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0, 1);
    return std::visit(
        [&](const auto& geometry) {
            Color throughput(1), sum(0);
            for (int depth = 0; depth <= maxDepth + 1; ++depth) {
                const auto hit = closestHit(geometry, ray);
                if (!hit) return sum + throughput * world.scene->environment.radiance(ray.direction);
                const Surface& surface = world.materials[world.objects[hit->instance].material].surface;
                sum += throughput * surface.emission;
                throughput *= surface.diffuse;
                const SurfacePoint p = surfaceAt(geometry, ray, *hit);
                const Vec3 n =
                    glm::dot(p.geometricNormal, ray.direction) < 0 ? p.geometricNormal : -p.geometricNormal;
                const float z = 2 * uniform(random) - 1, turn = 2 * kPi * uniform(random);
                const float r = std::sqrt(1 - z * z);
                const Vec3 w = glm::normalize(n + 0.9999F * Vec3(r * std::cos(turn), r * std::sin(turn), z));
                ray = {spawnOrigin(p, w), w};
            }
            return sum;
        },
        *world.accel);
}

TEST(Path, AgreesWithAPathTracerThatKnowsNoLamps) {
    constexpr int kSide = 6, kPasses = 800, kBlindPasses = 12000, kDepth = 4;
    const Scene scene = cornell(Color(0.2F));
    const Tracing tracing(scene, by(Method::Path, kDepth), kSide, kSide);
    std::vector<DVec3> sums(kSide * kSide, DVec3(0)), squares = sums, blind = sums, blindSquares = sums;
    std::mt19937 random(7);
    for (int pass = 0; pass < kPasses; ++pass) {
        const auto radiance = tracing.radiance(pass);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += DVec3(radiance[i]);
            squares[i] += DVec3(radiance[i] * radiance[i]);
        }
    }
    const FloatEnvironment environment;
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (int k = 0; k < kBlindPasses; ++k) {
            const Ray ray = tracing.context().eyeRays.through(
                static_cast<int>(i) % kSide, static_cast<int>(i) / kSide, {uniform(random), uniform(random)});
            const DVec3 c(blindPath(tracing.world(), ray, kDepth, random));
            blind[i] += c;
            blindSquares[i] += c * c;
        }
    double chi2 = 0;
    DVec3 all(0), allBlind(0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const DVec3 a = sums[i] / static_cast<double>(kPasses),
                    b = blind[i] / static_cast<double>(kBlindPasses);
        const DVec3 va = (squares[i] / static_cast<double>(kPasses) - a * a) / static_cast<double>(kPasses);
        const DVec3 vb =
            (blindSquares[i] / static_cast<double>(kBlindPasses) - b * b) / static_cast<double>(kBlindPasses);
        for (int c = 0; c < 3; ++c) chi2 += (a[c] - b[c]) * (a[c] - b[c]) / (va[c] + vb[c] + 1e-12);
        all += a;
        allBlind += b;
    }
    EXPECT_LT(chi2 / (3 * kSide * kSide), 1.6);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c], allBlind[c], 0.01 * allBlind[c]) << c;
}

TEST(Path, ErrorFallsAtLeastAsTheRootOfTheSamples) {
    Scene scene = cornell();
    look(scene, {0, 0, 3.6}, {0.1, -1, 0.3},
         1); // no edge in sight, whose samples fall into place by Sobol' alone
    constexpr int kSide = 8;
    for (const Sampler sampler : {Sampler::Independent, Sampler::Stratified, Sampler::Sobol}) {
        TraceSettings settings = by(Method::Path, 3);
        settings.sampler = sampler;
        const Tracing tracing(scene, settings, kSide, kSide);
        // Means of blocks of 16 and of 256 passes, each against the mean of all.
        constexpr int kBlocks = 16, kLong = 256, kShort = 16;
        std::vector<DVec3> total(kSide * kSide, DVec3(0));
        std::vector<std::vector<double>> shortMeans, longMeans;
        std::vector<double> shortSum(total.size(), 0), longSum(total.size(), 0);
        for (int pass = 0; pass < kBlocks * kLong; ++pass) {
            const auto radiance = tracing.radiance(pass);
            for (std::size_t i = 0; i < total.size(); ++i) {
                shortSum[i] += radiance[i].g;
                longSum[i] += radiance[i].g;
            }
            if ((pass + 1) % kShort == 0) {
                for (double& v : shortSum) v /= kShort;
                shortMeans.push_back(std::exchange(shortSum, std::vector<double>(total.size(), 0)));
            }
            if ((pass + 1) % kLong == 0) {
                for (double& v : longSum) v /= kLong;
                longMeans.push_back(std::exchange(longSum, std::vector<double>(total.size(), 0)));
            }
        }
        const auto variance = [&](const std::vector<std::vector<double>>& means) {
            double result = 0;
            for (std::size_t i = 0; i < total.size(); ++i) {
                double sum = 0, squares = 0;
                for (const auto& m : means) {
                    sum += m[i];
                    squares += m[i] * m[i];
                }
                const double n = static_cast<double>(means.size()), mean = sum / n;
                result += (squares / n - mean * mean) * n / (n - 1);
            }
            return result;
        };
        const double slope = 0.5 * std::log(variance(longMeans) / variance(shortMeans)) /
                             std::log(static_cast<double>(kLong) / kShort);
        EXPECT_LT(slope, -0.44) << kSamplerNames[static_cast<std::size_t>(sampler)];
        EXPECT_GT(slope, sampler == Sampler::Independent ? -0.56 : -1.0);
    }
}

TEST(Path, SeesLampsThroughGlassByTheRaysThatFindThem) {
    // A thin pane between floor and lamp: the shadow ray is blocked, the diffuse ray goes through.
    const double irradiance = 0.785398163;
    Scene scene = floorBelow(0.5F);
    scene.cameras.front().eye.y = 0.05;
    add(scene, Plane{60, 60, true}, glass(1), at({0, 0.2, 0})); // of index 1: it only stands in the way
    scene.lights = {lampAt({0, 2, 0}, SphereLamp{1})};
    expectMean(estimate(Tracing(scene, by(Method::Path)), 20000), 0.5 * irradiance / kPiD, 1e-4);

    scene.lights = {lampAt({0, 2, 0}, PointLamp{}, 10)};
    EXPECT_EQ(Tracing(scene, by(Method::Path)).pixel().r, 0) << "no ray finds a point";
    EXPECT_NEAR(Tracing(scene, by(Method::Distributed)).pixel().r, 0.397887358, 1e-5F)
        << "its shadow rays go straight through";
}

/// Everything at once: rough metal and glass, coats, lamps of all kinds, sky.
Scene showroom() {
    Scene scene = cornell({0.1F, 0.2F, 0.4F});
    GltfMaterial metal;
    metal.baseColor = {0.9F, 0.7F, 0.3F};
    metal.roughness = 0.3F;
    GltfMaterial frosted;
    frosted.metallic = 0;
    frosted.roughness = 0.3F;
    frosted.transmission = 1;
    frosted.attenuationColor = {0.5F, 0.9F, 0.9F};
    frosted.attenuationDistance = 0.5F;
    GltfMaterial plastic;
    plastic.baseColor = {0.6F, 0.1F, 0.2F};
    plastic.metallic = 0;
    plastic.roughness = 0.2F;
    add(scene, Sphere{0.3F}, metal, at({-0.5, -0.7, 0.5}));
    add(scene, Sphere{0.25F}, frosted, at({0.4, -0.15, 0.2}));
    add(scene, Sphere{0.2F}, plastic, at({0, -0.8, 0.7}));
    scene.lights.push_back(taughtLampAt({0.5, 0.5, 0.8}, Color(0.2F)));
    scene.lights.push_back(lampAt({-0.7, 0.3, 0.5}, SphereLamp{0.08}, 20));
    return scene;
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
