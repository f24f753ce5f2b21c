// labels: unit image
// Closed forms of light that goes on from surface to surface or comes from far around: form factors, skies,
// walls in the way, bowls and shafts, glass on paint, and how much single samples scatter (stability 2).

#include <gtest/gtest.h>

#include "core/transport/bsdf.h"
#include "tests/random_methods.h"

namespace eyeray {
namespace {

using namespace scenes;

DMat4 turned(double degreesAbout, const DVec3& axis) {
    return glm::rotate(DMat4(1), radians(degreesAbout), axis);
}

/// A disc in the plane y = 0.
TriangleMesh disc(double radius) {
    constexpr std::uint32_t kSegments = 720;
    TriangleMesh mesh;
    mesh.positions = {Vec3(0)};
    for (std::uint32_t i = 0; i < kSegments; ++i) {
        const double angle = 2 * kPiD * i / kSegments;
        mesh.positions.emplace_back(radius * DVec3(std::cos(angle), 0, std::sin(angle)));
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSegments});
    }
    return mesh;
}

/// What the white floor of a black scene gets of a body that glows: the share of the floor's own light that
/// would reach the body. Of the floor with |x| and |z| up to `half`, or of the disc in it; seen from
/// `height`.
Estimate formFactor(Scene scene, double half, double height, bool round) {
    constexpr int kSide = 32, kPasses = 400;
    constexpr double kRadius = 0.5 * kSide; // pixels
    add(scene, Plane{}, matte(Color(1)));
    look(scene, {0, height, 0}, {0, 0, 0}, degrees(2 * std::atan(half / height)));
    const Tracing tracing(scene, by(Method::Path, 0), kSide, kSide);
    double sum = 0, squares = 0;
    for (int pass = 1; pass <= kPasses; ++pass) {
        const std::vector<Color> picture = tracing.radiance(pass);
        double light = 0, pixels = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const std::size_t column = i % kSide, row = i / kSide;
            const double x = static_cast<double>(column) + 0.5 - kRadius,
                         y = static_cast<double>(row) + 0.5 - kRadius;
            if (round && x * x + y * y > kRadius * kRadius) continue;
            light += picture[i].r;
            pixels += 1;
        }
        sum += light / pixels;
        squares += light / pixels * light / pixels;
    }
    const double mean = sum / kPasses;
    return {DVec3(mean), std::sqrt(std::max(0.0, squares / kPasses - mean * mean) / kPasses)};
}

TEST(FormFactors, OfACubeAreTheTabulated) {
    Scene opposite = underSky(Color(0));
    add(opposite, Plane{1, 1, true}, glowing(Color(1)), at({0, 1, 0}));
    expectMean(formFactor(opposite, 0.5, 0.99, false), 0.199824896, 1e-4, "opposite");
    Scene adjacent = underSky(Color(0));
    add(adjacent, Plane{1, 1, true}, glowing(Color(1)), at({0.5, 0.5, 0}) * turned(90, {0, 0, 1}));
    expectMean(formFactor(adjacent, 0.5, 0.99, false), 0.200043776, 1e-4, "adjacent");
}

TEST(FormFactors, OfDiscsAndSpheresOnOneAxisAreTheTabulated) {
    Scene discs = underSky(Color(0));
    add(discs, disc(1), glowing(Color(1)), at({0, 1, 0}));
    expectMean(formFactor(discs, 1, 0.99, true), 0.381966011, 1e-3, "two discs");
    // By reciprocity the disc sees a sphere of half its radius, and of its area, as the sphere sees the disc.
    Scene sphere = underSky(Color(0));
    add(sphere, Sphere{0.5F}, glowing(Color(1)), at({0, 1, 0}));
    expectMean(formFactor(sphere, 1, 0.45, true), 0.146446609, 1e-3, "sphere over a disc");
}

TEST(GlowingTriangle, LightsAPointAsLambertsFormula) {
    Scene scene = floorBelow(1);
    scene.cameras.front().eye.y = 0.05;
    TriangleMesh triangle;
    triangle.positions = {{1, 1, 0}, {0, 2, 1}, {-1, 1, -1}};
    triangle.triangles = {{0, 1, 2}};
    add(scene, triangle, glowing(Color(1)));
    expectMean(estimate(Tracing(scene, by(Method::Path, 0)), 20000), 0.676515055 / kPiD, 1e-4);
}

TEST(GlowingDisc, LightsAPointAsTheClosedForm) {
    for (const auto& [height, irradiance] : {std::pair{1.0, 1.570796327}, {2.0, 0.628318531}}) {
        Scene scene = floorBelow(1);
        scene.cameras.front().eye.y = 0.05;
        add(scene, disc(1), glowing(Color(1)), at({0, height, 0}));
        expectMean(estimate(Tracing(scene, by(Method::Path, 0)), 40000), irradiance / kPiD, 1e-4);
    }
}

TEST(Furnace, OfAnyAlbedoIsItsSeriesUpToTheDepth) {
    for (const float rho : {0.5F, 0.8F, 0.9F, 0.99F})
        for (const int depth : {4, 7, kMaxDepth}) {
            Scene scene = underSky(Color(0));
            TaughtMaterial wall = matte(Color(rho));
            wall.emission = Color(1);
            add(scene, Sphere{1}, wall);
            const double exact = (1 - std::pow(static_cast<double>(rho), depth + 2)) / (1 - rho);
            expectMean(estimate(Tracing(scene, by(Method::Path, depth)), 8000), exact, 1e-4);
        }
}

TEST(LambertFloor, UnderAGradientSkyHasTheIntegral) {
    // Radiance √cos θ from black at the horizon to 1: ∫ √c · 2c dc = 4/5.
    for (const Method method : kPhysical) {
        Scene scene = floorBelow(0.5F);
        scene.environment.zenith = Color(1);
        expectMean(estimate(Tracing(scene, by(method)), 20000), 0.4, 1e-4);
    }
}

TEST(LambertSurface, UnderSkiesByTheAngleHasTheIntegrals) {
    PhysicalSurface surface;
    surface.diffuse = Color(0.5F);
    const Vec3 up(0, 1, 0);
    const Bsdf bsdf(surface, {.wo = up, .normal = up, .geometricNormal = up});
    double fourth = 0, overcast = 0;
    constexpr int kSamples = 1 << 14;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const auto sample = bsdf.sample(RayKind::Diffuse, sobol2({.pass = i}, 1, SamplePurpose::Direction));
        ASSERT_TRUE(sample);
        const double cosine = sample->wi.y, weight = sample->weight.x / kSamples;
        fourth += weight * std::pow(cosine, 4);
        overcast += weight * (1 + cosine) / 2;
    }
    EXPECT_NEAR(fourth, 0.166666667, 0.005 * 0.166666667);
    EXPECT_NEAR(overcast, 0.416666667, 0.003 * 0.416666667);
}

/// A tube around the y axis from y = 0 up to `height`.
TriangleMesh tube(double radius, double height) {
    constexpr std::uint32_t kSegments = 512;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < kSegments; ++i)
        for (const double y : {0.0, height}) {
            const double angle = 2 * kPiD * i / kSegments;
            mesh.positions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
        }
    for (std::uint32_t i = 0; i < kSegments; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSegments);
        mesh.triangles.push_back({a, b, a + 1});
        mesh.triangles.push_back({b, b + 1, a + 1});
    }
    return mesh;
}

TEST(AmbientOcclusion, BesideWallsAndInATubeIsTheHiddenShareOfTheSky) {
    for (const Method method : kPhysical) {
        const Scene open = floorBelow(0.5F, Color(1));
        const auto seen = [&](const Scene& scene) { return estimate(Tracing(scene, by(method)), 40000); };
        Scene wall = open; // as high as it is far
        add(wall, Plane{2000, 2, true}, matte(Color(0)), at({0, 0, -1}) * turned(90, {1, 0, 0}));
        expectMean(seen(wall), 0.5 * (1 - 0.146446609), 1e-4, "wall");
        Scene endless = open;
        add(endless, Plane{1e6F, 1e6F, true}, matte(Color(0)), at({0, 0, -1}) * turned(90, {1, 0, 0}));
        expectMean(seen(endless), 0.25, 1e-4, "endless wall");
        Scene well = open;
        add(well, tube(1, 1), matte(Color(0)));
        expectMean(seen(well), 0.25, 1e-4, "tube as deep as wide");
    }
}

TEST(Penumbra, OfARoundLampHasTheVisibleSharesOfItsDisc) {
    // Radius ½, 4 m up; an edge above x = 0 at half the height. A ball so far away looks like a disc.
    for (const Method method : kPhysical)
        for (const auto& [x, share] : {std::pair{-0.25, 0.804498891}, {0.0, 0.5}, {0.25, 0.195501109}}) {
            Scene scene = floorBelow(1);
            look(scene, {x, 0.05, 0}, {x, 0, 0}, 0.01);
            scene.lights = {lampAt({0, 4, 0}, SphereLamp{0.5}, 100)};
            const double whole = estimate(Tracing(scene, by(method)), 4000).mean.x;
            add(scene, Box{{10, 1e-3F, 10}}, matte(Color(0)), at({5, 2, 0}));
            expectMean(estimate(Tracing(scene, by(method)), 40000), share * whole, 3e-3 * whole);
        }
}

/// The lower half of a sphere of radius 1, open above.
TriangleMesh bowl() {
    constexpr std::uint32_t kRows = 128, kColumns = 256;
    TriangleMesh mesh;
    for (std::uint32_t row = 0; row <= kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const double theta = kPiD / 2 * row / kRows, phi = 2 * kPiD * column / kColumns;
            mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), -std::cos(theta),
                                        std::sin(theta) * std::sin(phi));
        }
    for (std::uint32_t row = 0; row < kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t a = row * kColumns + column, b = row * kColumns + (column + 1) % kColumns;
            mesh.triangles.push_back({a, b, a + kColumns});
            mesh.triangles.push_back({b, b + kColumns, a + kColumns});
        }
    return mesh;
}

TEST(Bowl, UnderAWhiteSkyIsAsBrightEverywhere) {
    Scene scene = underSky(Color(1));
    add(scene, bowl(), matte(Color(0.5F)));
    for (const DVec3& target : {DVec3(0.1, -1, 0.05), DVec3(0.7, -0.7, 0.1), DVec3(-0.2, -0.3, 0.9)}) {
        look(scene, {0.05, 0.1, 0.02}, target, 0.01);
        expectMean(estimate(Tracing(scene, by(Method::Path, 40)), 10000), 1.0 / 3, 2e-4);
    }
}

TEST(Shaft, OfPerfectMirrorsIsAsBrightAsEndlessPlates) {
    Scene scene = underSky(Color(0));
    for (int side = 0; side < 4; ++side)
        add(scene, Plane{1, 3, true}, mirror(Color(1)),
            turned(90 * side, {0, 1, 0}) * at({0, 0, -0.5}) * turned(90, {1, 0, 0}));
    TaughtMaterial floor = matte(Color(0.5F));
    floor.emission = Color(1);
    add(scene, Plane{2, 2, true}, floor, at({0, -1, 0}));
    add(scene, Plane{2, 2, true}, matte(Color(0.5F)), at({0, 1, 0}));
    const auto seen = [&](double up) {
        look(scene, {0.1, 0, 0.05}, {0.12, up, 0.08}, 0.01);
        return estimate(Tracing(scene, by(Method::Path, kMaxDepth)), 10000);
    };
    expectMean(seen(-1), 4.0 / 3, 2e-3, "floor");
    expectMean(seen(1), 2.0 / 3, 2e-3, "ceiling");
}

TEST(GlassOnPaint, ReflectsWhatAllPassagesTogetherLeave) {
    // Glass lies on a floor of albedo 1/2 under a white sky. With the mean reflectances of its surface from
    // outside and inside, all that comes out again is 0.352958859 of what came in.
    constexpr double kOutside = 0.091777959, kInside = 0.596345760, kAlbedo = 0.5, kEta = 1.5;
    const double body = kAlbedo * (1 - kOutside) / (1 - kAlbedo * kInside) / (kEta * kEta);
    EXPECT_NEAR(kOutside + (1 - kOutside) * body, 0.352958859, 1e-8);
    Scene scene = underSky(Color(1));
    add(scene, Box{{4000, 1, 4000}}, glass(1.5F), at({0, 0.5, 0}));
    add(scene, Plane{3900, 3900, true}, matte(Color(0.5F)), at({0, 1e-3, 0}));
    for (const auto& [angle, reflectance] :
         {std::pair{0.0, 0.04}, {60.0, 0.089186713}, {80.0, 0.387704355}}) {
        const double lean = radians(angle);
        look(scene, {0, 2, 0}, {std::tan(lean), 1, 0}, 0.01);
        expectMean(estimate(Tracing(scene, by(Method::Path, 48)), 20000),
                   reflectance + (1 - reflectance) * body, 1e-3);
    }
}

TEST(Noise, OfASphereLampByItsConeIsThatOfTheCosine) {
    // One sample's standard deviation over its mean, of a sphere of radius 1 whose centre is 2 above.
    Scene scene = floorBelow(0.5F);
    scene.lights = {lampAt({0, 2, 0}, SphereLamp{1})};
    TraceSettings settings = by(Method::Distributed);
    settings.sampler = Sampler::Independent;
    constexpr int kSamples = 20000;
    const Estimate e = estimate(Tracing(scene, settings), kSamples);
    EXPECT_NEAR(e.error * std::sqrt(kSamples) / e.mean.x, 0.041451884, 0.03 * 0.041451884);
}

TEST(Noise, OfAHalfHiddenLampIsHalfItsLightOverTheRootOfTheSamples) {
    // An edge hides one half of a square lamp: each sample sees all of its light or nothing.
    Scene scene = floorBelow(1);
    scene.cameras.front().eye.y = 0.05;
    Light lamp = lampAt({0, 40, 0}, RectangleLamp{1, 1}, 1e3);
    lamp.transform = lamp.transform * facing({0, -1, 0});
    scene.lights = {lamp};
    TraceSettings settings = by(Method::Distributed);
    settings.sampler = Sampler::Independent;
    const double whole = Tracing(scene, settings).pixel().r;
    add(scene, Box{{10, 0.01F, 10}}, matte(Color(0)), at({5, 20, 0}));
    const Tracing tracing(scene, settings);
    constexpr int kTrials = 1000;
    for (const int samples : {1, 4, 16, 64}) {
        double sum = 0, squares = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            double mean = 0;
            for (int i = 0; i < samples; ++i)
                mean += tracing.tile(1 + trial * samples + i).radiance.front().r;
            mean /= samples * whole;
            sum += mean;
            squares += mean * mean;
        }
        const double mean = sum / kTrials, deviation = std::sqrt(squares / kTrials - mean * mean);
        EXPECT_NEAR(mean, 0.5, 4 * 0.5 / std::sqrt(samples * kTrials)) << samples;
        EXPECT_NEAR(deviation * std::sqrt(samples), 0.5, 0.1 * 0.5) << samples;
    }
}

}
}
