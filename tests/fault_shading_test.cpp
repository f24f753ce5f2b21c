// labels: unit
// What each fault of light, optics, sampling and film does, by numbers of stability.md or a closed form.

#include <gtest/gtest.h>

#include "core/render/film.h"
#include "core/render/render_settings.h"
#include "core/transport/faults.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TraceSettings with(Fault fault, TraceSettings settings = toDepth(8)) {
    settings.faults.set(fault, true);
    return settings;
}

/// The floor y = 0 seen straight from above; everything else is black.
Scene floorBelow(const TaughtMaterial& material) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, material);
    look(scene, {0, 2, 0}, {0, 0, 0});
    return scene;
}

TEST(FaultShadowNoTmax, LetsAWallBehindTheLampBlockIt) {
    Scene scene = floorBelow(matte(Color(1)));
    scene.lights = {taughtLampAt({1, 1, 0})};
    add(scene, Sphere{0.5F}, matte(Color(0)), at({2, 2, 0}));
    EXPECT_NEAR(Tracing(scene).pixel().r, std::sqrt(0.5F), 1e-6);
    EXPECT_EQ(Tracing(scene, with(Fault::ShadowNoTmax)).pixel(), Color(0));
}

TEST(FaultAbsCosine, LightsTheBack) {
    Scene scene = floorBelow(matte(Color(1)));
    scene.lights = {taughtLampAt({0, -1, 0})};
    TraceSettings unshadowed = casting();
    unshadowed.shadows = false;
    EXPECT_EQ(Tracing(scene, unshadowed).pixel(), Color(0));
    EXPECT_NEAR(Tracing(scene, with(Fault::AbsCosine, unshadowed)).pixel().r, 1, 1e-6);
}

TEST(FaultAmbientPerLight, MultipliesTheAmbientTerm) {
    Scene scene = floorBelow(matte(Color(0), Color(0.1F)));
    scene.ambient = Color(1);
    for (int i = 0; i < 3; ++i) scene.lights.push_back(taughtLampAt({0, 1.0 + i, 1}));
    EXPECT_NEAR(Tracing(scene).pixel().r, 0.1F, 1e-6);
    EXPECT_NEAR(Tracing(scene, with(Fault::AmbientPerLight)).pixel().r, 0.3F, 1e-6);
}

TEST(FaultHardTerminator, BlackensFacetsThatTheirNormalsCallLit) {
    // Of a ball of `facets` around, lit from the side, this share of the lit half faces away from the lamp.
    for (const int facets : {8, 16, 32}) {
        TriangleMesh mesh = cases::closedMesh(facets / 2, facets, 1);
        for (const Vec3& position : mesh.positions) mesh.normals.push_back(glm::normalize(position));
        Scene scene = underSky(Color(0));
        add(scene, mesh, matte(Color(1)), glm::rotate(DMat4(1), kPiD / facets, DVec3(0, 1, 0)));
        scene.lights = {taughtLampAt({1e4, 0, 0})};
        look(scene, {0, 0.5, 10}, {0, 0, 0}, 12.5);
        const auto lit = [&](const TraceSettings& settings) {
            const std::vector<Color> picture = Tracing(scene, settings, 200, 200).radiance();
            return static_cast<double>(
                std::count_if(picture.begin(), picture.end(), [](const Color& c) { return !isBlack(c); }));
        };
        const double angle = kPiD / facets;
        const double share = 2 / kPiD * (std::sin(angle) * std::cos(angle) + angle);
        EXPECT_NEAR(1 - lit(with(Fault::HardTerminator)) / lit(toDepth(1)), share, 0.2 * share) << facets;
    }
}

TEST(FaultReflectionSign, MakesARayLongerThanOne) {
    // Stability F30: at 45 degrees |2 (n . l) n + l| is the root of 5.
    Scene scene = underSky(Color(1));
    add(scene, Plane{}, mirror(Color(1)));
    look(scene, {-1, 1, 0}, {0, 0, 0});
    const auto reflection = [&](const TraceSettings& settings) {
        return Tracing(scene, settings).retrace().rays.at(1).direction;
    };
    EXPECT_NEAR(glm::length(reflection(toDepth(1))), 1, 1e-6);
    EXPECT_NEAR(glm::length(reflection(with(Fault::ReflectionSign, toDepth(1)))), std::sqrt(5.0F), 1e-5);
}

/// Inside a glass ball around the origin, at the angle of incidence θ on its wall.
Scene insideGlass(double degreesOfIncidence) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, glass(1.5F));
    const double theta = radians(degreesOfIncidence);
    look(scene, {0, 0, 0.5}, {0, 0, -1});
    // From (0, 0, a) along direction d the sine of incidence is |a d_x|.
    const double a = 0.9, sine = std::min(1.0, std::sin(theta) / a);
    scene.cameras[0].eye = {0, 0, a};
    scene.cameras[0].target = scene.cameras[0].eye + DVec3(sine, 0, -std::sqrt(1 - sine * sine));
    return scene;
}

const RayRecord* refractionOf(const Retrace& trace) {
    for (const RayRecord& ray : trace.rays)
        if (ray.kind == RayKind::Refraction && ray.depth == 1) return &ray;
    return nullptr;
}

TEST(FaultEtaNotFlipped, RefractsWhereGlassReflectsAllLight) {
    // Stability F29: 60 degrees inside glass go out at 35.26 degrees.
    const Scene scene = insideGlass(60);
    EXPECT_EQ(refractionOf(Tracing(scene, toDepth(1)).retrace()), nullptr);
    const Retrace wrong = Tracing(scene, with(Fault::EtaNotFlipped, toDepth(1))).retrace();
    const RayRecord* const out = refractionOf(wrong);
    ASSERT_NE(out, nullptr);
    const double cosine = std::fabs(glm::dot(out->direction, wrong.rays[0].hit.normal));
    EXPECT_NEAR(degrees(std::acos(cosine)), 35.26, 0.01);
}

TEST(FaultSchlickInnerCosine, ReflectsASixthOfTheTruth) {
    // Stability F28: leaving glass at 40 degrees 0.040673 in place of 0.245291.
    const auto reflected = [](const TraceSettings& settings) {
        for (const RayRecord& ray : Tracing(insideGlass(40), settings).retrace().rays)
            if (ray.kind == RayKind::Reflection && ray.depth == 1) return ray.share.r;
        return 0.0F;
    };
    EXPECT_NEAR(reflected(toDepth(1)), 0.245291, 1e-5);
    EXPECT_NEAR(reflected(with(Fault::SchlickInnerCosine, toDepth(1))), 0.040673, 1e-5);
}

TEST(FaultNanRefraction, GivesNoNumberBeyondTheCriticalAngle) {
    for (const double angle : {41.7, 41.9}) { // the critical angle is 41.8103 degrees
        const TileResult result = Tracing(insideGlass(angle), with(Fault::NanRefraction, toDepth(1))).tile();
        EXPECT_EQ(result.counts.invalidSamples, angle > 41.81 ? 1U : 0U) << angle;
        EXPECT_EQ(Tracing(insideGlass(angle), toDepth(1)).tile().counts.invalidSamples, 0U);
    }
}

TEST(FaultEarlyClamp, LosesTheLightThatAMirrorDims) {
    // A lamp's surface of radiance 10 in a mirror of 0.05: 0.5, but 0.05 of what is left after a cut at 1.
    Scene scene = underSky(Color(10));
    add(scene, Plane{}, mirror(Color(0.05F)));
    look(scene, {-1, 1, 0}, {0, 0, 0});
    EXPECT_NEAR(Tracing(scene).pixel().r, 0.5F, 1e-6);
    EXPECT_NEAR(Tracing(scene, with(Fault::EarlyClamp)).pixel().r, 0.05F, 1e-6);
}

TraceSettings pathTracing() {
    TraceSettings settings = toDepth(kMaxDepth);
    settings.method = Method::Path;
    return settings;
}

/// Mean over the samples of the middle of a closed glowing ball of albedo ρ: 1/(1 − ρ).
double furnace(const TraceSettings& settings, float rho) {
    Scene scene = underSky(Color(0));
    TaughtMaterial wall = matte(Color(rho));
    wall.emission = Color(1);
    add(scene, Sphere{1}, wall);
    const Tracing tracing(scene, settings, 16, 16);
    double sum = 0;
    constexpr int kPasses = 64;
    for (int pass = 0; pass < kPasses; ++pass)
        for (const Color& c : tracing.radiance(pass)) sum += c.r;
    return sum / (kPasses * 256);
}

TEST(FaultRouletteUnweighted, DarkensAFurnace) {
    const double right = furnace(pathTracing(), 0.8F);
    EXPECT_NEAR(right, 5, 0.15);
    // Paths survive with p = ρ^k from the third bounce on and are not divided by it.
    const double wrong = furnace(with(Fault::RouletteUnweighted, pathTracing()), 0.8F);
    EXPECT_LT(wrong, 4);
    EXPECT_GT(wrong, 2);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) ma += a[i], mb += b[i];
    ma /= static_cast<double>(a.size()), mb /= static_cast<double>(b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(FaultBadSeeding, MakesNeighboursAlikeAndRepeatsItself) {
    constexpr int kWidth = 1000;
    std::vector<double> here, beside, good, goodBeside;
    for (std::uint32_t x = 0; x + 1 < kWidth; ++x) {
        const SampleAddress a{0, x, 0, 0}, b{0, x + 1, 0, 0};
        here.push_back(badlySeeded(a, kWidth, 0, SamplePurpose::Lens).x);
        beside.push_back(badlySeeded(b, kWidth, 0, SamplePurpose::Lens).x);
        good.push_back(sample2(Sampler::Sobol, a, 0, SamplePurpose::Lens).x);
        goodBeside.push_back(sample2(Sampler::Sobol, b, 0, SamplePurpose::Lens).x);
    }
    EXPECT_GT(correlation(here, beside), 0.999) << "stability F50";
    EXPECT_LT(std::fabs(correlation(good, goodBeside)), 0.1);
    EXPECT_EQ(badlySeeded({0, 5, 5, 0}, kWidth, 7, SamplePurpose::Lamp),
              badlySeeded({0, 5, 5, 9}, kWidth, 7, SamplePurpose::Lamp));
}

TEST(FaultEightBit, StopsWhereAStepRoundsToNothing) {
    // Stability F57: after 311 samples of 255 and 0 in turn the mean cannot move: steps are below ½ a code.
    const auto meanOf = [](bool eightBit) {
        Film film(1, 1);
        film.reset(eightBit);
        TileResult result{.tile = film.tile(0), .radiance = {Color(0)}, .counts = {}};
        for (int pass = 0; pass < 4000; ++pass) {
            result.radiance[0] = Color(pass < 1000 ? 0.4F : 0.6F);
            film.add(0, result, pass);
        }
        return film.mean(4000).at(0, 0).r;
    };
    EXPECT_NEAR(meanOf(false), 0.55F, 1e-6);
    EXPECT_NEAR(meanOf(true), 0.4F, 1e-3) << "0.2 / 1001 of 255 codes is less than half of one";
}

TEST(FaultNoGamma, ShowsHalfAs128) {
    const std::vector<Color> half{Color(0.5F)};
    std::vector<Rgba8> shown(1);
    RenderSettings settings;
    display(half, shownDisplay(settings), shown);
    EXPECT_EQ(shown[0].r, 188) << "stability F55";
    settings.trace.faults = Fault::NoGamma;
    display(half, shownDisplay(settings), shown);
    EXPECT_EQ(shown[0].r, 128);
}

}
}
