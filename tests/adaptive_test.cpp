// labels: unit threads
// Adaptive sampling: where the samples go, that the mean stays right, and what it saves.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/image/metrics.h"
#include "core/render/adaptive.h"
#include "core/render/render_session.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;
using namespace std::chrono_literals;

constexpr DisplaySettings kLinear{.exposure = 0, .toneMap = ToneMap::None};

/// One pass of samples value(x, y) of the pixels that are wanted.
template <class Value>
void addPass(Film& film, int pass, const Value& value) {
    for (int i = 0; i < film.tiles(); ++i) {
        const std::vector<std::uint8_t> wanted = film.wanted(i, pass);
        Tile tile = film.tile(i);
        tile.wanted = wanted;
        TileResult result{.tile = film.tile(i), .radiance = {}, .counts = {}, .complete = true};
        eachTraced(tile, [&](int x, int y) { result.radiance.push_back(value(x, y)); });
        film.add(i, result, pass);
    }
}

/// Passes until all pixels have ended; returns how many. `decide` decides after a stage.
template <class Value, class Decide>
int sampled(Film& film, const Value& value, const Decide& decide) {
    int passes = 0;
    while (!film.ended(passes)) {
        addPass(film, passes++, [&](int x, int y) { return value(x, y, passes); });
        if (isAdaptiveStage(passes)) decide(passes);
    }
    return passes;
}

double meanOf(const std::vector<int>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// ---- Light that few samples meet: stability.md, F49

constexpr int kSide = 100;
constexpr double kChance = 0.05, kTolerance = 0.02;

struct RareLight {
    double mean, deviation, samples; // over the pixels
};

/// 10,000 pixels that are white in one sample of 20, decided by the film's variances as `around` takes them.
template <class Around>
RareLight rareLight(std::uint32_t seed, const Around& around) {
    cases::Random random(seed);
    Film film(kSide, kSide);
    const int passes = sampled(
        film, [&](int, int, int) { return Color(random.uniform(0, 1) < kChance ? 1.0F : 0.0F); },
        [&](int stage) {
            film.limit(nextLimits(around(film.displayedVariances(stage, kLinear), stage), film.samples(stage),
                                  stage, kTolerance));
        });
    RareLight result{0, 0, meanOf(film.samples(passes))};
    const ColorImage means = film.mean(passes);
    for (const Color& mean : means.values()) {
        result.mean += mean.x;
        result.deviation += (mean.x - kChance) * (mean.x - kChance);
    }
    result.mean /= kSide * kSide;
    result.deviation = std::sqrt(result.deviation / (kSide * kSide));
    return result;
}

TEST(Adaptive, RareLightKeepsItsMeanAndHasTheErrorAskedFor) {
    RareLight all{0, 0, 0};
    constexpr int kFilms = 8;
    for (std::uint32_t seed = 0; seed < kFilms; ++seed) {
        const RareLight one = rareLight(seed, [](const std::vector<double>& variances, int passes) {
            return surroundingVariances(variances, kSide, kSide, passes);
        });
        all.mean += one.mean / kFilms;
        all.deviation += one.deviation / kFilms;
        all.samples += one.samples / kFilms;
    }
    EXPECT_NEAR(all.mean, kChance, 0.005 * kChance) << "bias";
    EXPECT_NEAR(all.deviation, kTolerance, 0.1 * kTolerance);
    EXPECT_NEAR(all.samples, kChance * (1 - kChance) / (kTolerance * kTolerance), 10);
}

TEST(Adaptive, PixelsThatJudgeByTheirOwnSamplesLoseRareLight) {
    const RareLight naive = rareLight(0, [](const std::vector<double>& variances, int) { return variances; });
    EXPECT_LT(naive.mean, 0.6 * kChance) << "what the surroundings are asked for";
}

// ---- Decisions

TEST(Adaptive, DecidesAtPowersOfTwoFromThePilotOn) {
    std::vector<int> stages;
    for (int passes = 0; passes <= 40; ++passes)
        if (isAdaptiveStage(passes)) stages.push_back(passes);
    EXPECT_EQ(stages, (std::vector{4, 8, 16, 32}));
}

TEST(Adaptive, LimitsAreVarianceOverSquaredErrorWithinAStage) {
    const std::vector<double> variances = {0, 0.07, 0.11, 0.16, 7, 7};
    const std::vector<int> samples = {8, 8, 8, 8, 8, 5};
    EXPECT_EQ(nextLimits(variances, samples, 8, 0.1), (std::vector{8, 8, 11, 16, 16, 5}));
}

TEST(Adaptive, LikelySamplesAreThoseThatPixelsEndWith) {
    // a sky, and beside it twenty times the noise that one sample may have
    cases::Random random(5);
    const auto value = [&](int x, int, int) {
        return x < kSide / 2 ? Color(0.5F) : Color(random.uniform(0, 1) < 0.5F ? 0.3F : 0.7F);
    };
    Film looked(kSide, kSide), ended(kSide, kSide);
    for (int pass = 0; pass < 16; ++pass)
        addPass(looked, pass, [&](int x, int y) { return value(x, y, pass); });
    const int passes =
        sampled(ended, value, [&](int stage) { decideSamples(ended, stage, kTolerance, kLinear); });
    constexpr int kMost = 1000;
    const double likely = meanOf(likelySamples(looked, 16, kTolerance, kLinear, kMost));
    EXPECT_NEAR(likely, meanOf(ended.samples(passes)), 0.15 * likely);
    EXPECT_NEAR(likely, (kAdaptivePilot + 100) / 2.0, 0.15 * likely)
        << "0.2² / 0.02² = 100 where it is noisy";
    EXPECT_EQ(std::ranges::max(likelySamples(looked, 16, kTolerance, kLinear, 20)), 20);
}

/// As the header says it, pixel by pixel.
std::size_t place(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

double surroundingVariance(const std::vector<double>& variances, int width, int height, int x, int y,
                           int passes) {
    const auto around = [&](int reach) {
        double sum = 0;
        int count = 0;
        for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
                if (i != x || j != y) sum += variances[place(i, j, width)], ++count;
        return sum / count;
    };
    const double weight = 4.0 / passes;
    return (around(2) + weight * around(16)) / (1 + weight);
}

TEST(Adaptive, SurroundingVarianceIsOfTheNeighboursAlone) {
    constexpr int kWidth = 50, kHeight = 23;
    cases::Random random(1);
    std::vector<double> variances(place(0, kHeight, kWidth));
    for (double& variance : variances) variance = random.uniform(0, 1);
    for (const int passes : {4, 64}) {
        const std::vector<double> around = surroundingVariances(variances, kWidth, kHeight, passes);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                ASSERT_NEAR(around[place(x, y, kWidth)],
                            surroundingVariance(variances, kWidth, kHeight, x, y, passes), 1e-12);
    }
    EXPECT_EQ(surroundingVariances(std::vector{0.25}, 1, 1, 4), std::vector{0.25}) << "alone";
}

TEST(Adaptive, SamplesGoWhereTheNoiseIs) {
    constexpr int kWidth = 128, kHeight = 32, kEdge = 64;
    constexpr double kError = 0.02;
    cases::Random random(2);
    Film film(kWidth, kHeight);
    const int passes = sampled(
        film,
        [&](int x, int, int) { return Color(x < kEdge ? static_cast<float>(random.uniform(0, 1)) : 0.25F); },
        [&](int stage) { decideSamples(film, stage, kError, kLinear); });
    const std::vector<int> samples = film.samples(passes);
    constexpr double kNeeded = 1.0 / 12 / (kError * kError); // of a uniform number's variance
    double noisy = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int count = samples[place(x, y, kWidth)];
            if (x < kEdge - 16) noisy += count;
            ASSERT_TRUE(x < kEdge + 16 || count == kAdaptivePilot) << count;
            ASSERT_TRUE(x < kEdge || count < kNeeded) << count;
        }
    EXPECT_NEAR(noisy / (kHeight * (kEdge - 16)), kNeeded, 0.05 * kNeeded);
    EXPECT_LE(film.estimatedError(passes, kLinear), 1.02 * kError);
}

// ---- Pictures

RenderSettings settingsFor(double error, Method method = Method::Whitted) {
    RenderSettings settings;
    settings.width = 96;
    settings.height = 72;
    settings.trace.method = method;
    settings.stop = {.samples = 4096, .seconds = 0, .error = error, .adaptive = true};
    return settings;
}

/// A mirror ball and a matte one over a plane, checkered or not, that reaches the horizon.
Scene ballsOnPlane(bool checkered) {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    TaughtMaterial ground = matte(Color(0.8F), Color(0.3F));
    if (checkered) {
        scene.textures = {{"", CheckerTexture{Color(0.9F), Color(0.1F)}}};
        ground.diffuseTexture.texture = 0;
    }
    add(scene, Plane{}, ground, at({0, -1, 0}));
    add(scene, Sphere{1}, mirror(Color(0.8F)), at({1.2, 0, -5}));
    add(scene, Sphere{1}, matte(Color(0.7F, 0.2F, 0.1F)), at({-1.2, 0, -5}));
    scene.lights = {taughtLampAt({2, 4, 0})};
    return scene;
}

/// A session that has come to its end.
struct Rendered {
    Rendered(const Scene& scene, const RenderSettings& settings, int threads = 2) : session(threads) {
        session.start(buildWorld(std::make_shared<const Scene>(scene), {}), scene.cameras.front(), settings);
        status = session.wait(120s);
        EXPECT_EQ(status.phase, RenderStatus::Phase::Finished) << status.failure;
    }
    int samplesAt(int x, int y) const { return static_cast<int>(session.sampleCounts().at(x, y).x); }

    RenderSession session;
    RenderStatus status;
};

TEST(AdaptivePicture, HasTheSameBitsOnAnyNumberOfThreads) {
    for (const Method method : {Method::Whitted, Method::Path}) {
        const RenderSettings settings = settingsFor(0.02, method);
        const Rendered one(ballsOnPlane(true), settings, 1), four(ballsOnPlane(true), settings, 4);
        EXPECT_EQ(one.session.image(), four.session.image());
        EXPECT_EQ(one.session.sampleCounts(), four.session.sampleCounts());
        EXPECT_EQ(one.status.samples, four.status.samples);
    }
}

TEST(AdaptivePicture, IsTheMeanOfThePixelsFirstSamples) {
    for (const Method method : {Method::Whitted, Method::Distributed}) {
        const Rendered rendered(ballsOnPlane(true), settingsFor(0.03, method));
        const ColorImage image = rendered.session.image();
        double all = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const int samples = rendered.samplesAt(x, y);
                all += samples;
                ASSERT_EQ(rendered.session.pixel(x, y)->samples, samples);
                if (x % 7 != 0 || y % 5 != 0) continue;
                DVec3 sum(0);
                for (int pass = 0; pass < samples; ++pass)
                    sum += DVec3(rendered.session.retrace(x, y, pass)->radiance);
                ASSERT_EQ(image.at(x, y), Color(sum / static_cast<double>(samples))) << x << " " << y;
            }
        EXPECT_DOUBLE_EQ(rendered.status.samplesPerPixel, all / (image.width() * image.height()));
        EXPECT_LT(rendered.status.samplesPerPixel, rendered.status.samples);
    }
}

TEST(AdaptivePicture, WithoutEdgesNeedsNoMoreThanThePilot) {
    Scene scene = underSky(Color(0.5F));
    add(scene, Plane{}, mirror(Color(0.5F)), at({0, -1, 0}));
    add(scene, Sphere{1}, matte(Color(0.5F), Color(1)), at({0, 0, -1.5})); // in front of all of the picture
    look(scene, {0, 0, 0}, {0, 0, -1}, 40);
    const Rendered rendered(scene, settingsFor(kInvisibleError));
    EXPECT_EQ(rendered.status.samples, kAdaptivePilot);
    EXPECT_EQ(rendered.status.finishedBy, "no visible error left");
}

TEST(AdaptivePicture, OfACheckeredGroundSpendsItsSamplesTowardsTheHorizon) {
    const auto ground = [](bool checkered) {
        Scene scene = ballsOnPlane(checkered);
        scene.objects.resize(1);
        return scene;
    };
    const Rendered plain(ground(false), settingsFor(0.01)), checkered(ground(true), settingsFor(0.01));
    const auto ofRows = [](const Rendered& rendered, int first, int last) {
        double sum = 0;
        for (int y = first; y <= last; ++y)
            for (int x = 0; x < 96; ++x) sum += rendered.samplesAt(x, y);
        return sum / (96 * (last - first + 1));
    };
    EXPECT_EQ(ofRows(plain, 0, 15), kAdaptivePilot) << "sky";
    EXPECT_EQ(ofRows(plain, 56, 71), kAdaptivePilot) << "ground";
    EXPECT_GT(ofRows(checkered, 38, 42), 20 * kAdaptivePilot) << "horizon";
    EXPECT_GT(checkered.status.samplesPerPixel, 4 * plain.status.samplesPerPixel);
}

/// Root mean square of the displayed difference in the worst tile.
double worstTile(const ColorImage& a, const ColorImage& b, int side) {
    const ByteImage shownA = display(a, {}), shownB = display(b, {});
    double worst = 0;
    for (int y0 = 0; y0 + side <= a.height(); y0 += side)
        for (int x0 = 0; x0 + side <= a.width(); x0 += side) {
            double squared = 0;
            for (int y = y0; y < y0 + side; ++y)
                for (int x = x0; x < x0 + side; ++x) {
                    const double step = (shownA.at(x, y).g - shownB.at(x, y).g) / 255.0;
                    squared += step * step;
                }
            worst = std::max(worst, squared / (side * side));
        }
    return std::sqrt(worst);
}

TEST(AdaptivePicture, HasTheErrorOfTheUniformOneForAFractionOfItsSamples) {
    RenderSettings settings = settingsFor(0.02);
    settings.width = 256;
    settings.height = 192;
    const Rendered adaptive(ballsOnPlane(true), settings);
    settings.stop.adaptive = false;
    const Rendered uniform(ballsOnPlane(true), settings);
    settings.stop = {.samples = 256, .seconds = 0, .error = 0};
    settings.seed = 99;
    const Rendered reference(ballsOnPlane(true), settings);
    const auto error = [&](const Rendered& rendered) {
        return worstTile(rendered.session.image(), reference.session.image(), kTileSize);
    };
    EXPECT_LE(error(adaptive), 1.1 * error(uniform));
    EXPECT_LE(error(adaptive), 0.02);
    EXPECT_LT(adaptive.status.samplesPerPixel, 0.6 * uniform.status.samples);
}

}
}
