// labels: unit
// Path tracing against closed forms and against a path tracer that knows no lamps.

#include <random>

#include <gtest/gtest.h>

#include "tests/random_methods.h"

namespace eyeray {
namespace {

using namespace scenes;

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

TEST(Path, InASphereWithALampIsTheIntegratingSphere) {
    for (const float rho : {0.5F, 0.8F}) {
        Scene scene = underSky(Color(0));
        add(scene, Sphere{1}, matte(Color(rho)));
        scene.lights = {lampAt({0, 0, 0})};
        const double indirect = rho * rho / (1 - rho) / kPiD; // Φ = 4π: ρ²/(1 − ρ) Φ/(4π²)
        expectMean(estimate(Tracing(scene, by(Method::Path, 60)), 20000), rho / kPiD + indirect, 1e-3);
    }
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

void expectAgreementWithBlindPaths(const Scene& scene) {
    constexpr int kSide = 6, kPasses = 800, kBlindPasses = 12000, kDepth = 4;
    const Tracing tracing(scene, by(Method::Path, kDepth), kSide, kSide);
    std::vector<DVec3> sums(std::size_t{kSide} * kSide, DVec3(0)), squares = sums, blind = sums,
                                                                   blindSquares = sums;
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
    DVec3 all(0), allBlind(0), variance(0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const DVec3 a = sums[i] / static_cast<double>(kPasses),
                    b = blind[i] / static_cast<double>(kBlindPasses);
        const DVec3 va = (squares[i] / static_cast<double>(kPasses) - a * a) / static_cast<double>(kPasses);
        const DVec3 vb =
            (blindSquares[i] / static_cast<double>(kBlindPasses) - b * b) / static_cast<double>(kBlindPasses);
        for (int c = 0; c < 3; ++c) chi2 += (a[c] - b[c]) * (a[c] - b[c]) / (va[c] + vb[c] + 1e-12);
        all += a;
        allBlind += b;
        variance += va + vb;
    }
    EXPECT_LT(chi2 / (3 * kSide * kSide), 1.6);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c], allBlind[c], 3.5 * std::sqrt(variance[c])) << c;
}

TEST(Path, AgreesWithAPathTracerThatKnowsNoLamps) { expectAgreementWithBlindPaths(cornell(Color(0.2F))); }

/// The box of cornell() without its lamp.
Scene darkCornell() {
    Scene scene = cornell();
    scene.lights.clear();
    return scene;
}

/// A matte triangle mesh that looks down.
TriangleMesh quadLookingDown(float side) {
    TriangleMesh mesh;
    const float half = side / 2;
    mesh.positions = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.doubleSided = false;
    return mesh;
}

TEST(Path, WithGlowingObjectsAgreesWithAPathTracerThatKnowsNoLamps) {
    const DMat4 skewed =
        glm::rotate(at({0.3, 0.2, 0.1}), 0.7, DVec3(1, 2, 0.5)) * glm::scale(DMat4(1), DVec3(0.3, 0.15, 0.2));
    Scene mesh = darkCornell(), shapes = darkCornell(), plane = darkCornell();
    add(mesh, quadLookingDown(0.8F), glowing(Color(4)), at({0, 0.99, 0}));
    add(shapes, Sphere{1}, glowing({3, 2, 1}), skewed);
    add(shapes, Box{{0.4F, 0.2F, 0.3F}}, glowing({1, 4, 2}), at({-0.5, 0.5, -0.3}));
    add(plane, Plane{0.5F, 0.4F, true}, glowing(Color(6)),
        glm::rotate(at({0.1, 0.1, 0}), 1.0, DVec3(1, 0, 1)));
    for (const Scene& scene : {mesh, shapes, plane}) expectAgreementWithBlindPaths(scene);
}

/// Mean and variance of a sample over a picture of the box, of green.
std::pair<double, double> noiseOf(const Scene& scene) {
    constexpr int kSide = 12, kPasses = 400;
    const Tracing tracing(scene, by(Method::Path, 2), kSide, kSide);
    std::vector<double> sums(std::size_t{kSide} * kSide, 0), squares = sums;
    for (int pass = 0; pass < kPasses; ++pass) {
        const auto radiance = tracing.radiance(pass);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += radiance[i].g;
            squares[i] += static_cast<double>(radiance[i].g) * radiance[i].g;
        }
    }
    double mean = 0, variance = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double m = sums[i] / kPasses;
        mean += m / static_cast<double>(sums.size());
        variance += (squares[i] / kPasses - m * m) / static_cast<double>(sums.size());
    }
    return {mean, variance};
}

TEST(Path, BelowAGlowingQuadHasHardlyMoreNoiseThanBelowALamp) {
    Scene lamp = darkCornell(), mesh = darkCornell();
    lamp.lights = {lampAt({0, 0.99, 0}, RectangleLamp{0.8, 0.8}, 5)};
    lamp.lights[0].transform = lamp.lights[0].transform * facing({0, -1, 0});
    add(mesh, quadLookingDown(0.8F), glowing(Color(5)), at({0, 0.99, 0}));
    const auto [ofLamp, noiseOfLamp] = noiseOf(lamp);
    const auto [ofMesh, noiseOfMesh] = noiseOf(mesh);
    EXPECT_NEAR(ofMesh, ofLamp, 0.01 * ofLamp);
    EXPECT_LT(noiseOfMesh, 1.5 * noiseOfLamp);
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
        std::vector<DVec3> total(std::size_t{kSide} * kSide, DVec3(0));
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

}
}
