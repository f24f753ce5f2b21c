// labels: unit
// Charts of speed against accuracy: what is measured is what theory says.

#include <gtest/gtest.h>

#include <cmath>

#include "core/image/metrics.h"
#include "core/render/render_session.h"
#include "core/study/experiment_run.h"
#include "core/study/pass_loop.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

const ReferenceStore kNoStore = {[](const TraceSettings&) { return std::nullopt; },
                                 [](const TraceSettings&, const ReferenceHalves&) {}};

/// Each sample of each pixel is white or black by a coin of its own: a half-covered pixel.
class Coin : public Integrator {
public:
    TileResult renderTile(const TraceContext& context, const Tile& tile, int pass) const override {
        TileResult result{tile, {}, {}, true};
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                std::uint64_t bits = (static_cast<std::uint64_t>(context.seed) << 40U) +
                                     (static_cast<std::uint64_t>(pass) << 24U) +
                                     (static_cast<std::uint64_t>(y) << 12U) + static_cast<std::uint64_t>(x);
                // Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators": mix64
                bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
                bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
                result.radiance.emplace_back((bits ^ (bits >> 31U)) % 2 == 0 ? 0.0F : 1.0F);
            }
        return result;
    }
    Retrace retrace(const TraceContext&, int, int, int) const override { return {}; }
    std::optional<RayCounts> retraceTile(const TraceContext&, const Tile&, int,
                                         const EachSample&) const override {
        return std::nullopt;
    }
};

TraceContext contextOf(const Scene& scene, const TraceSettings& settings, int side, std::uint32_t seed) {
    const auto shared = std::make_shared<const Scene>(scene);
    return {buildWorld(shared, {}), scene.cameras.front(), settings, side, side, seed, {}};
}

/// A floor that sees exactly half of a small, far lamp: from x < 0 nothing comes. The eye looks at one place.
Scene halfOfALamp(bool blocked) {
    Scene scene = underSky(Color(0));
    look(scene, {0, 1, 3}, {0, 0, 0}, 0.001);
    add(scene, Plane{20, 20, true}, matte(Color(1)));
    Light lamp = lampAt({0, 100, 0}, RectangleLamp{1, 1}, 1e5);
    lamp.transform = lamp.transform * facing({0, -1, 0});
    scene.lights = {lamp};
    if (blocked) add(scene, Plane{10, 10, true}, matte(Color(0)), at({-5, 50, 0}));
    return scene;
}

ExperimentPlan smallPlan(const TaughtMaterial& ball = mirror(Color(0.8F))) {
    Scene scene = underSky(Color(0.2F));
    look(scene, {0, 0.5, 4}, {0, 0, 0});
    add(scene, Plane{20, 20, true}, matte(Color(0.7F)), at({0, -1, 0}));
    add(scene, Sphere{1}, ball);
    scene.lights = {lampAt({2, 4, 3}, SphereLamp{0.5}, 20)};
    ExperimentPlan plan;
    plan.camera = scene.cameras.front();
    plan.scene = std::make_shared<const Scene>(std::move(scene));
    plan.width = 32;
    plan.height = 24;
    plan.referenceSamples = 64;
    plan.repeats = 2;
    plan.threads = 2;
    plan.grid = {{Method::Cast, Method::Whitted, Method::Path},
                 {1, 4},
                 {0.002F},
                 {Sampler::Sobol},
                 {GlassShadows::Straight},
                 {AccelKind::Auto},
                 {1, 4}};
    return plan;
}

TEST(Experiment, ShadowsPrecisionAndAdaptiveSamplingAreDimensions) {
    ExperimentGrid grid = smallPlan().grid;
    grid.methods = {Method::Local, Method::Whitted};
    grid.depths = {4};
    grid.shadows = {1, 0};
    grid.adaptive = {0, 1};
    grid.precisions = {Precision::Float, Precision::Double};
    const auto labels = [&](const TraceSettings& base) {
        std::vector<std::string> all;
        for (const ExperimentSetting& setting : combinations(grid, base))
            all.push_back(labelOf(setting, grid));
        return all;
    };
    EXPECT_EQ(labels({}), (std::vector<std::string>{"local", "local adaptive", "whitted", "whitted adaptive",
                                                    "whitted no shadows", "whitted no shadows adaptive"}));
    TraceSettings faulty;
    faulty.faults.set(Fault::SphereSlide, true);
    EXPECT_EQ(labels(faulty).size(), 12U) << "precision, too";
}

TEST(Experiment, AdaptivePassesAreThoseOfARenderSession) {
    const ExperimentPlan plan = smallPlan();
    TraceSettings settings;
    settings.method = Method::Distributed;
    const auto world = buildWorld(plan.scene, {});
    constexpr int kPasses = 40, kSide = 64;
    constexpr double kError = 0.02;
    ThreadPool pool(2);
    PassLoop passes(makeIntegrator(settings.method),
                    TraceContext(world, plan.camera, settings, kSide, kSide, 3, {}), pool);
    passes.sampleAdaptively(kError, {});
    while (passes.passes() < kPasses) ASSERT_TRUE(passes.pass(1e9, {}));
    RenderSettings render;
    render.width = render.height = kSide;
    render.trace = settings;
    render.seed = 3;
    render.stop = {.samples = kPasses, .seconds = 0, .error = kError, .adaptive = true};
    RenderSession session(2);
    session.start(world, plan.camera, render);
    const RenderStatus status = session.wait(std::chrono::seconds(120));
    EXPECT_EQ(passes.picture(), session.image());
    EXPECT_DOUBLE_EQ(passes.samplesPerPixel(), status.samplesPerPixel);
    EXPECT_LT(passes.samplesPerPixel(), kPasses);
}

TEST(Experiment, FindsTheErrorOfAHalfCoveredPixelByTheRootOfN) {
    const ColorImage half(64, 64, Color(0.5F));
    ThreadPool pool(2);
    PassLoop passes(std::make_shared<Coin>(), contextOf(underSky(Color(0)), {}, 64, 5), pool);
    for (const int samples : {1, 4, 16, 64, 256}) {
        while (passes.passes() < samples) ASSERT_TRUE(passes.pass(1e9, {}));
        const double expected = 0.5 / std::sqrt(samples);
        EXPECT_NEAR(errorsOf(half, passes.picture(), {})[ErrorMetric::Rmse] / expected, 1, 0.05) << samples;
    }
}

TEST(Experiment, FindsTheErrorOfAHalfSeenLampByTheRootOfN) {
    TraceSettings settings;
    settings.method = Method::Path;
    settings.maxDepth = 0;
    settings.cutoff = 0;
    settings.sampler = Sampler::Independent;
    constexpr int kSide = 48;
    ThreadPool pool(2);
    const auto rendered = [&](bool blocked, int samples) {
        PassLoop passes(makeIntegrator(settings.method), contextOf(halfOfALamp(blocked), settings, kSide, 9),
                        pool);
        while (passes.passes() < samples) EXPECT_TRUE(passes.pass(1e9, {}));
        return passes.picture();
    };
    const float whole = rendered(false, 4).at(0, 0).r;
    ASSERT_GT(whole, 0.1F);
    const ColorImage truth(kSide, kSide, Color(0.5F * whole));
    for (const int samples : {1, 4, 16, 64}) {
        const double expected = 0.5 * whole / std::sqrt(samples);
        EXPECT_NEAR(rmse(truth, rendered(true, samples)) / expected, 1, 0.06) << samples;
    }
}

TEST(Experiment, MeasuresEachCombinationOnceAndNamesWhatDiffers) {
    const ExperimentPlan plan = smallPlan();
    const auto settings = combinations(plan.grid, plan.base);
    std::vector<std::string> labels;
    labels.reserve(settings.size());
    for (const ExperimentSetting& setting : settings) labels.push_back(labelOf(setting, plan.grid));
    EXPECT_EQ(labels, (std::vector<std::string>{"cast", "whitted d1", "whitted d4", "path d1", "path d4"}));
    ExperimentGrid accels = plan.grid;
    accels.methods = {Method::Cast};
    accels.accels = {AccelKind::Brute, AccelKind::Bvh8};
    EXPECT_EQ(combinations(accels, plan.base).size(), 2U);
    EXPECT_EQ(labelOf(combinations(accels, plan.base)[1], accels), "cast bvh8");
}

TEST(Experiment, SetsEachPointBesideItsOwnLimitAndTheFullestModel) {
    const ExperimentPlan plan = smallPlan();
    ExperimentProgress progress;
    const auto result = runExperiment(plan, kNoStore, progress, {});
    ASSERT_TRUE(result);
    ASSERT_EQ(result->curves.size(), 5U);
    ASSERT_EQ(result->points.size(), 10U);
    EXPECT_LT(result->fullest.error, 0.05);
    for (const ExperimentPoint& point : result->points) {
        ASSERT_EQ(point.repeats.size(), 2U) << point.failure;
        EXPECT_GT(point.seconds().least, 0);
        const ExperimentCurve& curve = result->curves[point.curve];
        const double sampling = point.error(ErrorAgainst::Limit, ErrorMetric::Rmse).median;
        const double model = point.error(ErrorAgainst::Fullest, ErrorMetric::Rmse).median;
        EXPECT_GT(sampling, 0);
        // d(point, fullest) ≥ d(limit, fullest) − d(point, limit): a distance.
        EXPECT_GE(model, rmse(curve.limit.picture, result->fullest.picture) - sampling - 1e-6);
        EXPECT_LE(model, rmse(curve.limit.picture, result->fullest.picture) + sampling + 1e-6);
    }
    const auto state = progress.state();
    EXPECT_NEAR(state.done, state.expected, 1e-6 * state.expected);
}

TEST(Experiment, TakesKeptReferencesAndFindsTheSameErrors) {
    const ExperimentPlan plan = smallPlan();
    std::vector<std::pair<TraceSettings, ReferenceHalves>> kept;
    const ReferenceStore store = {
        [&](const TraceSettings& model) -> std::optional<ReferenceHalves> {
            for (const auto& [settings, halves] : kept)
                if (settings == model) return halves;
            return std::nullopt;
        },
        [&](const TraceSettings& model, const ReferenceHalves& halves) { kept.emplace_back(model, halves); }};
    ExperimentProgress progress;
    const auto first = runExperiment(plan, store, progress, {});
    ASSERT_EQ(kept.size(), 6U) << "the five, and the fullest model";
    const auto second = runExperiment(plan, store, progress, {});
    ASSERT_EQ(kept.size(), 6U);
    for (std::size_t i = 0; i < first->points.size(); ++i)
        for (std::size_t k = 0; k < kErrorMetrics; ++k)
            EXPECT_EQ(first->points[i].repeats[1].toFullest.values[k],
                      second->points[i].repeats[1].toFullest.values[k]);
}

TEST(Experiment, StatesTheReferencesOwnErrorAsItIs) {
    ExperimentPlan plan = smallPlan(matte(Color(0.5F))); // whose noise no single bright pixel rules
    plan.grid.methods = {Method::Path};
    plan.grid.depths = {1};
    ExperimentProgress progress;
    const auto rough = runExperiment(plan, kNoStore, progress, {});
    plan.referenceSamples = 2048;
    const auto fine = runExperiment(plan, kNoStore, progress, {});
    const double truth = rmse(rough->curves[0].limit.picture, fine->curves[0].limit.picture);
    EXPECT_NEAR(rough->curves[0].limit.error / truth, 1, 0.25);
}

TEST(Experiment, KeepsAPointThatFailedWithTheReason) {
    ExperimentPlan plan = smallPlan();
    plan.limitSeconds = 1e-9;
    ExperimentProgress progress;
    const auto result = runExperiment(plan, kNoStore, progress, {});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->points.size(), 10U);
    for (const ExperimentPoint& point : result->points) {
        EXPECT_TRUE(point.repeats.empty());
        EXPECT_EQ(point.failure, "takes longer than 1e-09 s");
        EXPECT_TRUE(std::isnan(point.seconds().median));
    }
}

TEST(Experiment, IsNothingWhenStoppedBeforeItsReferences) {
    const std::stop_source stop;
    stop.request_stop();
    ExperimentProgress progress;
    EXPECT_FALSE(runExperiment(smallPlan(), kNoStore, progress, stop.get_token()));
}

TEST(Spread, IsTheMedianBetweenTheExtremes) {
    EXPECT_EQ(spreadOf({3, 1, 2}).median, 2);
    EXPECT_EQ(spreadOf({4, 1, 2, 3}).median, 2.5);
    EXPECT_EQ(spreadOf({4, 1, 2, 3}).least, 1);
    EXPECT_EQ(spreadOf({4, 1, 2, 3}).most, 4);
    EXPECT_TRUE(std::isnan(spreadOf({}).median));
    EXPECT_TRUE(std::isnan(spreadOf({1, std::nan("")}).least));
}

}
}
