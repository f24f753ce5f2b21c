// labels: unit
// The smallest model of a picture: what is proved changes no bit, what is measured stays within the
// tolerance.

#include <gtest/gtest.h>

#include "app/document/document_needs.h"
#include "app/document/scene_files.h"
#include "core/image/flip.h"
#include "core/image/metrics.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 64, kHeight = 36;

const NeedsStep kQuiet = [](const std::string&) {};

NeedsPlan planFor(Scene scene, const TraceSettings& trace, int samples = 1) {
    NeedsPlan plan;
    plan.camera = scene.cameras.front();
    plan.scene = std::make_shared<const Scene>(std::move(scene));
    plan.settings.trace = trace;
    plan.settings.width = kWidth;
    plan.settings.height = kHeight;
    plan.settings.stop = {samples, 0, 0};
    plan.threads = 2;
    return plan;
}

MeasuredNeeds measured(const NeedsPlan& plan) { return *measureNeeds(plan, kQuiet, {}); }

/// Null if there is no such item.
const NeedItem* itemOf(const MeasuredNeeds& needs, const std::string& what) {
    for (const NeedItem& item : needs.items)
        if (item.what == what) return &item;
    return nullptr;
}

/// The mean of so many samples, by a loop of this test's own.
ColorImage traced(const PictureModel& model, int samples, std::shared_ptr<const World> world = nullptr) {
    if (!world) world = buildWorld(model.scene, {model.accel});
    const TraceContext context(world, model.camera, model.trace, kWidth, kHeight, 0, {});
    const auto integrator = makeIntegrator(model.trace.method);
    ThreadPool pool(2);
    Film film(kWidth, kHeight);
    for (int pass = 0; pass < samples; ++pass)
        pool.forEach(film.tiles(), {},
                     [&](int i) { film.add(i, integrator->renderTile(context, film.tile(i), pass), pass); });
    return film.mean(samples);
}

std::shared_ptr<const World> thatSkipsNothing(const PictureModel& model) {
    World world = *buildWorld(model.scene, {model.accel});
    world.needs = {true, true, true, true, {}, {true, true, true, {}}};
    return std::make_shared<const World>(std::move(world));
}

/// A ball of this material before a wall that glows, and nothing else.
Scene ballByAWall(const MaterialModel& ball) {
    Scene scene = underSky(Color(0.1F));
    add(scene, Plane{20, 20, true}, glowing({0.3F, 0.5F, 0.4F}), at({0, 0, -9}) * facing({0, -1, 0}));
    add(scene, Sphere{1}, ball, at({0, 0, -4}));
    return scene;
}

TEST(ProvedNeeds, OfAllScenesAndMethodsChangeNoBit) {
    int proofs = 0;
    for (const BuiltinScene& scene : builtinScenes()) {
        const Document document = openScene(scene.name).document;
        for (const Method method : {Method::Cast, Method::Whitted, Method::Distributed, Method::Path}) {
            PictureModel asSet{document.scene, document.camera, document.render.trace};
            asSet.trace.method = method;
            PictureModel smaller = asSet;
            for (const ProvedNeed& proved : provedNeeds(asSet)) {
                ++proofs;
                for (const auto& rung : proved.ladder.rungs) rung.climb(smaller);
            }
            EXPECT_EQ(traced(asSet, 1, thatSkipsNothing(asSet)).values(), traced(smaller, 1).values())
                << scene.name << " by " << kMethodNames[static_cast<std::size_t>(method)];
        }
    }
    EXPECT_GT(proofs, 100);
}

TEST(MeasuredNeeds, OfAllScenesStayWithinTheTolerance) {
    for (const BuiltinScene& scene : builtinScenes()) {
        const Document document = openScene(scene.name).document;
        NeedsPlan plan = needsPlan(document, kWidth, kHeight, false);
        plan.settings.stop = {64, 0, 0};
        const MeasuredNeeds needs = measured(plan);
        const DisplaySettings& shown = document.render.display;
        const ByteImage asSet = display(traced(needs.asSet, kModelSamples), shown);
        const ByteImage smaller = display(traced(needs.needed, kModelSamples), shown);
        EXPECT_LE(maxByteDifference(asSet, smaller), 1) << scene.name;
        const double change = meanFlip(flip(display(traced(needs.asSet, 64), shown),
                                            display(traced(needs.needed, needs.needed.samples), shown)));
        EXPECT_LE(change, 1.2 * kDefaultTolerance) << scene.name;
        EXPECT_LE(needs.error.flip, kDefaultTolerance) << scene.name;
    }
}

TEST(MeasuredNeeds, OfAMatteSceneAreNoRaysBeyondThoseOfTheEye) {
    const MeasuredNeeds needs = measured(planFor(ballByAWall(matte(Color(0.5F))), toDepth(5)));
    for (const char* const rays : {"shadow rays", "reflection rays", "refraction rays"}) {
        ASSERT_NE(itemOf(needs, rays), nullptr) << rays;
        EXPECT_TRUE(itemOf(needs, rays)->proved);
        EXPECT_EQ(itemOf(needs, rays)->to, "off");
    }
    EXPECT_EQ(itemOf(needs, "max depth")->to, "0");
    EXPECT_EQ(itemOf(needs, "max depth")->reason, "nothing sends a ray on");
    EXPECT_EQ(itemOf(needs, "method")->to, "local");
    EXPECT_EQ(needs.error.steps, 0);
}

TEST(MeasuredNeeds, OfOneConvexMirrorAreItsRaysAlone) {
    const MeasuredNeeds outside = measured(planFor(ballByAWall(mirror(Color(0.8F))), toDepth(9)));
    ASSERT_NE(itemOf(outside, "max depth"), nullptr);
    EXPECT_TRUE(itemOf(outside, "max depth")->proved);
    EXPECT_EQ(itemOf(outside, "max depth")->to, "1");
    EXPECT_EQ(itemOf(outside, "reflection rays"), nullptr);

    Scene within = ballByAWall(mirror(Color(0.8F)));
    look(within, {0, 0, -4.2}, {0, 0, -5});
    for (const ProvedNeed& proved :
         provedNeeds({std::make_shared<const Scene>(within), within.cameras.front(), toDepth(9)}))
        EXPECT_NE(proved.ladder.what, "max depth") << "in it, rays go round for ever";
}

/// The eye sees a wall that glows by way of two mirrors, each of this reflectivity.
Scene periscope(float reflectivity) {
    Scene scene = underSky(Color(0));
    const Shape pane = Plane{2, 2, true};
    add(scene, pane, mirror(Color(reflectivity)), at({0, 0, -3}) * facing(DVec3(0, -1, -1)));
    add(scene, pane, mirror(Color(reflectivity)), at({0, 3, -3}) * facing(DVec3(0, -1, -1)));
    scene.objects[0].transform = at({0, 0, -3}) * glm::rotate(DMat4(1), radians(45.0), DVec3(1, 0, 0));
    scene.objects[1].transform = at({0, 3, -3}) * glm::rotate(DMat4(1), radians(45.0), DVec3(1, 0, 0));
    add(scene, Plane{40, 40, true}, glowing(Color(0.5F)),
        at({0, 3, -9}) * glm::rotate(DMat4(1), radians(90.0), DVec3(1, 0, 0)));
    look(scene, {0, 0, 0}, {0, 0, -3}, 25);
    return scene;
}

TEST(MeasuredNeeds, OfTwoMirrorsInARowIsDepthTwo) {
    const MeasuredNeeds needs = measured(planFor(periscope(0.9F), toDepth(12)));
    ASSERT_NE(itemOf(needs, "max depth"), nullptr);
    EXPECT_FALSE(itemOf(needs, "max depth")->proved);
    EXPECT_EQ(itemOf(needs, "max depth")->to, "2");
    EXPECT_EQ(itemOf(needs, "max depth")->error.steps, 0);
}

TEST(MeasuredNeeds, OfAFaintMirrorIsACutoffThatSkipsItsRays) {
    Scene scene = ballByAWall(mirror(Color(0.8F)));
    add(scene, Sphere{0.6F}, mirror(Color(0.005F)), at({1.7, 0, -4}));
    scene.environment = {Color(0.01F), Color(0.01F), Color(0.01F)};
    std::get<TaughtMaterial>(scene.materials.back().model).emission = Color(0.6F);
    const MeasuredNeeds needs = measured(planFor(scene, toDepth(1)));
    EXPECT_EQ(itemOf(needs, "reflection rays"), nullptr);
    ASSERT_NE(itemOf(needs, "cutoff"), nullptr);
    EXPECT_EQ(itemOf(needs, "cutoff")->from, "0");
    EXPECT_EQ(itemOf(needs, "cutoff")->to, "0.5");
    EXPECT_LE(itemOf(needs, "cutoff")->error.steps, 1);
}

TEST(MeasuredNeeds, LeaveOutTheLampBehindAWall) {
    Scene scene = ballByAWall(matte(Color(0.5F)));
    std::get<TaughtMaterial>(scene.materials[0].model).diffuse = Color(0.2F);
    scene.lights = {taughtLampAt({2, 3, 0}), taughtLampAt({0, 0, -20})};
    scene.lights[0].name = "before";
    scene.lights[1].name = "behind";
    const MeasuredNeeds needs = measured(planFor(scene, toDepth(0)));
    EXPECT_EQ(itemOf(needs, "lamp before"), nullptr);
    ASSERT_NE(itemOf(needs, "lamp behind"), nullptr);
    EXPECT_FALSE(needs.needed.scene->lights[1].enabled);
}

TEST(MeasuredNeeds, CountSamplesByWhatMoreWouldChange) {
    const Scene flat = underSky(Color(0.3F));
    const MeasuredNeeds ofSky = measured(planFor(flat, toDepth(0), 256));
    ASSERT_NE(itemOf(ofSky, "samples"), nullptr);
    EXPECT_EQ(itemOf(ofSky, "samples")->to, "1");

    const MeasuredNeeds ofEdges = measured(planFor(ballByAWall(matte(Color(0.5F))), toDepth(0), 256));
    EXPECT_GT(ofEdges.needed.samples, 4) << "an edge needs more than a sky";
}

TEST(MeasuredNeeds, CountTheSamplesThatAdaptiveSamplingTakesByItself) {
    NeedsPlan plan = planFor(ballByAWall(matte(Color(0.5F))), toDepth(0), 256);
    plan.settings.stop.error = 0.02;
    plan.settings.stop.adaptive = true;
    const MeasuredNeeds needs = measured(plan);
    const NeedItem* const item = itemOf(needs, "samples");
    ASSERT_NE(item, nullptr);

    ThreadPool pool(1);
    const TraceContext context(buildWorld(plan.scene, {}), plan.camera, plan.settings.trace, kWidth, kHeight,
                               0, {});
    PassLoop adaptive(makeIntegrator(plan.settings.trace.method), context, pool);
    adaptive.sampleAdaptively(plan.settings.stop.error, plan.settings.display);
    while (adaptive.passes() < 256) ASSERT_TRUE(adaptive.pass(1e6, {}));
    const std::string stated = "256 (mean ";
    ASSERT_EQ(item->from.rfind(stated, 0), 0U) << item->from;
    EXPECT_NEAR(std::stod(item->from.substr(stated.size())), adaptive.samplesPerPixel(),
                0.2 * adaptive.samplesPerPixel());
}

TEST(MeasuredNeeds, TakeBackWhatFailsInTheWholePicture) {
    const NeedsPlan plan = planFor(periscope(0.9F), toDepth(12));
    MeasuredNeeds needs = measured(plan);
    ASSERT_EQ(itemOf(needs, "max depth")->to, "2");
    for (MeasuredNeeds::Taken& taken : needs.taken) {
        if (taken.ladder.what != "max depth") continue;
        taken.rung = 0;
        needs.items[taken.item].to = "0";
    }
    const MeasuredNeeds checked = *checkNeeds(plan, needs, kQuiet, {});
    EXPECT_EQ(checked.needed.trace.maxDepth, 2);
    EXPECT_EQ(itemOf(checked, "max depth")->takenBack, "0 is too little for the whole picture");

    MeasuredNeeds hopeless = measured(plan);
    hopeless.taken = {{{.what = "reflection rays",
                        .from = "on",
                        .rungs = {{"off", [](PictureModel& m) { m.trace.reflections = false; }}},
                        .leftOut = "reflection rays"},
                       0,
                       0}};
    hopeless.items[0].to = "off";
    const MeasuredNeeds kept = *checkNeeds(plan, hopeless, kQuiet, {});
    EXPECT_TRUE(kept.needed.trace.reflections);
    EXPECT_EQ(itemOf(kept, "reflection rays")->to, "on");
}

TEST(MeasuredNeeds, WithNoToleranceChangeNothingAtAll) {
    const Document document = openScene("mirrors").document;
    NeedsPlan plan = needsPlan(document, kWidth, kHeight, false);
    plan.settings.stop = {4, 0, 0};
    plan.tolerance = 0;
    const MeasuredNeeds needs = measured(plan);
    EXPECT_EQ(needs.needed.samples, 4);
    const DisplaySettings& shown = document.render.display;
    EXPECT_EQ(
        maxByteDifference(display(traced(needs.asSet, 4), shown), display(traced(needs.needed, 4), shown)),
        0);
}

TEST(MeasuredNeeds, EndAtOnceWhenAskedTo) {
    const std::stop_source stop;
    stop.request_stop();
    const NeedsPlan plan = planFor(periscope(0.9F), toDepth(12));
    EXPECT_FALSE(measureNeeds(plan, kQuiet, stop.get_token()));
    EXPECT_FALSE(checkNeeds(plan, measured(plan), kQuiet, stop.get_token()));
}

TEST(Mosaic, HasTheVeryPixelsOfThePicture) {
    const int width = 700, height = 330;
    const Scene scene = ballByAWall(mirror(Color(0.8F)));
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    const TraceContext context(world, scene.cameras.front(), toDepth(2), width, height, 0, {});
    const auto pictureOf = [&](const Mosaic& mosaic) {
        ThreadPool pool(2);
        PassLoop loop(makeIntegrator(Method::Whitted), context, pool, mosaic);
        loop.pass(1e9, {});
        return loop.picture();
    };
    const Mosaic whole = mosaicOf(width, height, width), part = mosaicOf(width, height, 5);
    EXPECT_EQ(whole.tiles.size(), 22U * 11U);
    EXPECT_EQ(part.tiles.size(), 5U * 3U);
    const ColorImage all = pictureOf(whole), some = pictureOf(part);
    ASSERT_EQ(some.width(), 5 * kTileSize);
    for (std::size_t i = 0; i < part.tiles.size(); ++i) {
        const Tile& tile = part.tiles[i];
        const int x0 = static_cast<int>(i % 5) * kTileSize, y0 = static_cast<int>(i / 5) * kTileSize;
        ASSERT_EQ(tile.x1 - tile.x0, kTileSize);
        ASSERT_EQ(tile.y1 - tile.y0, kTileSize);
        for (int y = 0; y < kTileSize; ++y)
            for (int x = 0; x < kTileSize; ++x)
                ASSERT_EQ(some.at(x0 + x, y0 + y), all.at(tile.x0 + x, tile.y0 + y));
    }
}

}
}
