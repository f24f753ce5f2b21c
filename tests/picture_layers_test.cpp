// labels: unit threads
// Layers of a picture: they add up to it, and know what closed forms say.

#include <cmath>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "core/render/render_session.h"
#include "core/scene/gltf.h"
#include "core/study/layer_film.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 48, kHeight = 36;

std::unique_ptr<LayerFilm> filmOf(const Tracing& tracing, std::vector<Layer> layers, int passes = 1,
                                  int threads = 1) {
    auto film =
        std::make_unique<LayerFilm>(std::move(layers), tracing.context().width, tracing.context().height);
    ThreadPool pool(threads);
    for (int pass = 0; pass < passes; ++pass)
        film->addPass(tracing.context(), tracing.integrator(), pass, pool);
    return film;
}

ColorImage layerOf(const Tracing& tracing, const char* name, int passes = 1) {
    return filmOf(tracing, {layerNamed(name, *tracing.world().scene)}, passes)->image(0).values;
}

std::vector<Layer> layersOf(const Scene& scene, const std::vector<Quantity>& quantities) {
    std::vector<Layer> chosen;
    for (const Layer& layer : layersOf(scene))
        if (std::find(quantities.begin(), quantities.end(), layer.quantity) != quantities.end())
            chosen.push_back(layer);
    return chosen;
}

/// Sum of the layers of these quantities.
ColorImage sumOf(const Tracing& tracing, const std::vector<Quantity>& quantities, int passes) {
    const auto film = filmOf(tracing, layersOf(*tracing.world().scene, quantities), passes);
    ColorImage sum = film->image(0).values;
    for (std::size_t i = 1; i < film->layers().size(); ++i) {
        const ColorImage part = film->image(i).values;
        for (std::size_t p = 0; p < sum.values().size(); ++p) sum.values()[p] += part.values()[p];
    }
    return sum;
}

void expectSame(const ColorImage& sum, const ColorImage& color) {
    ASSERT_EQ(sum.values().size(), color.values().size());
    for (std::size_t i = 0; i < sum.values().size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(sum.values()[i][c], color.values()[i][c],
                        1e-5 * std::fmax(1.0F, color.values()[i][c]))
                << "pixel " << i;
}

/// A mirror and a ball of glass by two lamps, one of them behind glass, over a ground that is lit ambiently.
Scene twoLamps() {
    Scene scene = underSky({0.3F, 0.5F, 0.9F});
    scene.ambient = Color(0.2F);
    add(scene, Plane{}, matte(Color(0.6F, 0.5F, 0.4F), Color(0.5F)), at({0, -1, 0}));
    add(scene, Sphere{1}, glass(1.5F, Color(0.9F), Color(0.2F)), at({-0.7, 0, -4}));
    add(scene, Sphere{1}, mirror(Color(0.8F)), at({1.2, 0, -5}));
    add(scene, Sphere{0.4F}, glowing(Color(2, 1, 0)), at({0, 1.6, -5}));
    scene.lights = {taughtLampAt({2, 4, 0}), lampAt({-3, 2, -1}, PointLamp{}, 40)};
    scene.lights[0].name = "key";
    return scene;
}

TEST(PictureLayers, KindsAddUpToTheColorAndSoDoLampsAndTheRest) {
    for (const auto& file : std::filesystem::directory_iterator(EYERAY_SOURCE_DIR "/assets/scenes")) {
        SCOPED_TRACE(file.path().filename());
        ImportReport report;
        const auto scene = std::make_shared<const Scene>(importGltf(file.path(), report));
        const auto world = buildWorld(scene, {});
        for (const Method method : {Method::Whitted, Method::Cast, Method::Local}) {
            TraceSettings settings = toDepth(4);
            settings.method = method;
            const Tracing tracing(world, settings, kWidth, kHeight);
            const ColorImage color = layerOf(tracing, "color", 2);
            expectSame(sumOf(tracing, {Quantity::Kind}, 2), color);
            expectSame(sumOf(tracing, {Quantity::Lamp, Quantity::Rest}, 2), color);
        }
    }
}

TEST(PictureLayers, TheColorHasTheBitsOfTheFilm) {
    const Scene scene = twoLamps();
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.trace = toDepth(5);
    settings.stop = {.samples = 5};
    RenderSession session(2);
    session.start(world, scene.cameras.front(), settings);
    while (session.wait(std::chrono::milliseconds(100)).active()) {
    }
    EXPECT_EQ(layerOf(Tracing(world, settings.trace, kWidth, kHeight), "color", 5), session.image());
}

TEST(PictureLayers, WithShadowRaysOffTheLampsStillCountAsBroughtByThem) {
    TraceSettings settings = toDepth(5);
    settings.shadows = false;
    const Tracing tracing(twoLamps(), settings, kWidth, kHeight);
    expectSame(sumOf(tracing, {Quantity::Kind}, 1), layerOf(tracing, "color"));
    EXPECT_FALSE(isBlack(layerOf(tracing, "shadow").at(kWidth / 2, kHeight - 1)));
    // the ground before the eye: ka Ia, and nothing of the lamps
    EXPECT_TRUE(isNear(layerOf(tracing, "eye").at(kWidth / 2, kHeight - 1), Color(0.1F), 1e-6F));
}

TEST(PictureLayers, EachLampsLayerIsThePictureByThatLampAlone) {
    Scene scene = twoLamps();
    scene.ambient = Color(0);
    scene.environment = {};
    scene.materials[3] = {"", matte(Color(0.5F))};
    const Tracing both(scene, toDepth(5), kWidth, kHeight);
    for (const std::size_t lamp : {0U, 1U}) {
        Scene alone = scene;
        alone.lights[1 - lamp].enabled = false;
        expectSame(layerOf(both, lamp == 0 ? "lamp.key" : "lamp.1"),
                   layerOf(Tracing(alone, toDepth(5), kWidth, kHeight), "color"));
    }
}

TEST(PictureLayers, DepthOfAPlaneIsItsDistanceAlongTheRay) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, matte(Color(0.7F)), at({0, -2, 0}));
    look(scene, {0, 0, 0}, {0, 0, -1}, 90);
    const Tracing tracing(scene, toDepth(5), kWidth, kHeight);
    const ColorImage depth = layerOf(tracing, "depth");
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double right = (2 * x + 1 - kWidth) / static_cast<double>(kHeight);
            const double up = (kHeight - 2 * y - 1) / static_cast<double>(kHeight);
            if (up > 0) {
                EXPECT_EQ(depth.at(x, y).x, kInfinity);
                continue;
            }
            EXPECT_NEAR(depth.at(x, y).x, std::sqrt(1 + right * right + up * up) * 2 / -up, 1e-4 * 2 / -up);
        }
}

TEST(PictureLayers, NormalOfABallPointsFromItsCentreAndItsAlbedoAndIdAreItsOwn) {
    Scene scene = underSky(Color(0.5F));
    add(scene, Sphere{0.1F}, matte(Color(0)), at({90, 0, 0})); // takes id 0
    add(scene, Sphere{1}, matte(Color(0.7F, 0.5F, 0.3F)), at({0.2, 0.1, -4}));
    const Tracing tracing(scene, toDepth(5), kWidth, kHeight);
    const ColorImage normal = layerOf(tracing, "normal"), depth = layerOf(tracing, "depth"),
                     id = layerOf(tracing, "id"), albedo = layerOf(tracing, "albedo");
    int hits = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (std::isinf(depth.at(x, y).x)) {
                EXPECT_EQ(normal.at(x, y), Vec3(0));
                EXPECT_EQ(id.at(x, y).x, kNoObject);
                EXPECT_EQ(albedo.at(x, y), Color(0));
                continue;
            }
            ++hits;
            const Ray ray = tracing.context().eyeRays.through(x, y, Vec2(0.5F));
            const Vec3 point = ray.origin + depth.at(x, y).x * ray.direction;
            const DVec3 centre = DVec3(0.2, 0.1, -4) - tracing.world().origin;
            EXPECT_TRUE(isNear(normal.at(x, y), Vec3(glm::normalize(DVec3(point) - centre)), 1e-4F));
            EXPECT_EQ(id.at(x, y).x, 1);
            EXPECT_EQ(albedo.at(x, y), Color(0.7F, 0.5F, 0.3F));
        }
    EXPECT_GT(hits, kWidth * kHeight / 20);
}

TEST(PictureLayers, RaysAddUpToTheCountsOfTheTracerAndRecursionReachesTheDeepest) {
    const Tracing tracing(twoLamps(), toDepth(6), kWidth, kHeight);
    const TileResult traced = tracing.tile();
    double rays = 0, deepest = 0;
    const ColorImage perPixel = layerOf(tracing, "rays"), depths = layerOf(tracing, "recursion");
    for (const Color& value : perPixel.values()) rays += static_cast<double>(value.x);
    for (const Color& value : depths.values()) deepest = std::max(deepest, static_cast<double>(value.x));
    EXPECT_EQ(rays, static_cast<double>(traced.counts.total()));
    EXPECT_EQ(deepest, traced.counts.deepest);
    const auto film = filmOf(tracing, {layerNamed("rays", *tracing.world().scene)});
    EXPECT_EQ(film->counts().rays, traced.counts.rays);
}

TEST(PictureLayers, TheErrorIsTheStandardErrorOfTheLuminance) {
    const Tracing tracing(twoLamps(), toDepth(3), kWidth, kHeight);
    constexpr int kPasses = 6;
    const ColorImage error = layerOf(tracing, "error", kPasses);
    std::vector<std::vector<Color>> passes;
    passes.reserve(kPasses);
    for (int pass = 0; pass < kPasses; ++pass) passes.push_back(tracing.radiance(pass));
    double largest = 0;
    for (std::size_t i = 0; i < error.values().size(); ++i) {
        double mean = 0, squares = 0;
        for (const auto& pass : passes) mean += luminance(DVec3(pass[i])) / kPasses;
        for (const auto& pass : passes) squares += std::pow(luminance(DVec3(pass[i])) - mean, 2);
        const double expected = std::sqrt(squares / (kPasses - 1) / kPasses);
        largest = std::max(largest, expected);
        EXPECT_NEAR(error.values()[i].x, expected, 1e-6);
    }
    EXPECT_GT(largest, 0.01);
    EXPECT_EQ(layerOf(tracing, "error", 1), ColorImage(kWidth, kHeight, Color(0)));
}

TEST(PictureLayers, AreTheSameOnAnyNumberOfThreads) {
    const Tracing tracing(twoLamps(), toDepth(5), kWidth, kHeight);
    std::vector<Layer> layers = layersOf(*tracing.world().scene);
    std::erase_if(layers, [](const Layer& layer) { return layer.quantity == Quantity::Cost; });
    const auto one = filmOf(tracing, layers, 3, 1), many = filmOf(tracing, layers, 3, 5);
    for (std::size_t i = 0; i < layers.size(); ++i)
        EXPECT_EQ(one->image(i).values, many->image(i).values) << layers[i].name;
}

TEST(PictureLayers, OfTheFirstHitAreTheSameTracedAloneOrWithAllOthers) {
    const Tracing tracing(twoLamps(), toDepth(5), kWidth, kHeight);
    const auto all = filmOf(tracing, layersOf(*tracing.world().scene), 2);
    for (std::size_t i = 0; i < all->layers().size(); ++i) {
        const Layer& layer = all->layers()[i];
        if (!isOfFirstHit(layer.quantity)) continue;
        EXPECT_EQ(all->image(i).values, layerOf(tracing, layer.name.c_str(), 2)) << layer.name;
    }
}

TEST(PictureLayers, CostIsTimeThatPassesAndSamplesAreCounted) {
    const Tracing tracing(twoLamps(), toDepth(5), kWidth, kHeight);
    const ColorImage cost = layerOf(tracing, "cost");
    for (const Color& value : cost.values()) EXPECT_GT(value.x, 0);
    EXPECT_EQ(layerOf(tracing, "samples", 3), ColorImage(kWidth, kHeight, Color(3)));
}

TEST(PictureLayers, AStopLeavesThePassUncounted) {
    const std::stop_source stop;
    const auto world = buildWorld(std::make_shared<const Scene>(twoLamps()), {});
    const Tracing tracing(world, toDepth(5), kWidth, kHeight, stop.get_token());
    LayerFilm film({layerNamed("color", *world->scene)}, kWidth, kHeight);
    ThreadPool pool(2);
    EXPECT_TRUE(film.addPass(tracing.context(), tracing.integrator(), 0, pool));
    const ColorImage before = film.image(0).values;
    stop.request_stop();
    EXPECT_FALSE(film.addPass(tracing.context(), tracing.integrator(), 1, pool));
    EXPECT_EQ(film.passes(), 1);
    EXPECT_EQ(film.image(0).values, before);
}

TEST(PictureLayers, HaveNamesOfTheirOwnAndUnknownOnesAreRefusedWithTheList) {
    Scene scene = twoLamps();
    scene.lights.push_back(scene.lights[0]); // two of one name
    std::vector<std::string> names;
    for (const Layer& layer : layersOf(scene)) {
        EXPECT_EQ(std::count(names.begin(), names.end(), layer.name), 0) << layer.name;
        names.push_back(layer.name);
        EXPECT_EQ(layerNamed(layer.name, scene), layer);
    }
    EXPECT_EQ(layerNamed("lamp.2", scene).index, 2);
    try {
        layerNamed("kolor", scene);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("color normal depth albedo id"), std::string::npos);
    }
}

}
}
