// labels: unit
// Preparing scenes: what a World shares, leaves out and keeps the same when a scene is moved, scaled or
// indexed otherwise.

#include <gtest/gtest.h>

#include "core/scene/choose_index.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 64, kHeight = 48;

/// Shapes, meshes, instances, glass, mirrors and lamps in a cube of half side 3.
Scene mixedScene(std::uint32_t seed) {
    cases::Random random(seed);
    Scene scene = underSky({0.3F, 0.5F, 0.8F});
    scene.ambient = Color(0.1F);
    const std::vector<MaterialModel> materials = {matte({0.8F, 0.6F, 0.4F}), mirror(Color(0.7F)),
                                                  glass(1.5F, Color(0.9F), Color(0.1F)),
                                                  matte({0.3F, 0.5F, 0.9F}, Color(0.2F)), glass(1.33F)};
    const std::vector<Shape> shapes = {Sphere{0.5F}, Box{{1, 0.5F, 0.7F}}, Cylinder{1, 0.2F, 0.4F},
                                       Plane{1, 1, true}};
    const auto material = [&] { return materials[static_cast<std::size_t>(random.below(5))]; };
    for (int i = 0; i < 24; ++i)
        add(scene, shapes[static_cast<std::size_t>(i % 4)], material(), cases::randomPlacement(random, 1));
    add(scene, cases::closedMesh(12, 24, 0.5, 0.2), material(), cases::randomPlacement(random, 1));
    for (int i = 0; i < 3; ++i) { // instances of that mesh
        Object instance = scene.objects.back();
        instance.transform = cases::randomPlacement(random, 1);
        scene.objects.push_back(instance);
    }
    add(scene, cases::triangleSoup(random, 100, 2), material());
    add(scene, Plane{}, matte(Color(0.6F)), at({0, -3, 0}));
    scene.lights = {taughtLampAt({4, 5, 3}, Color(0.5F)), lampAt({-3, 4, 2}, SphereLamp{0.3}, 40),
                    lampAt({0, 4, 0}, RectangleLamp{1, 1}, 20)};
    scene.lights[2].transform *= facing({0, -1, 0.3});
    look(scene, {1, 1.5, 8}, {0, 0, 0}, 40);
    return scene;
}

struct Difference {
    double rms = 0;
    int pixels = 0; // that differ by more than half a code of an 8-bit display
};
Difference compare(const std::vector<Color>& a, const std::vector<Color>& b) {
    Difference result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const DVec3 d(a[i] - b[i]);
        result.rms += glm::dot(d, d) / static_cast<double>(a.size());
        result.pixels += glm::length(d) > 0.5 / 255 ? 1 : 0;
    }
    result.rms = std::sqrt(result.rms);
    return result;
}

TEST(World, BvhAndBruteForceGiveTheSameBits) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const Tracing brute(mixedScene(seed), toDepth(4), kWidth, kHeight, AccelKind::Brute);
        const TileResult a = brute.tile();
        for (const AccelKind kind : {AccelKind::Bvh2, AccelKind::Bvh8}) {
            const TileResult b = Tracing(mixedScene(seed), toDepth(4), kWidth, kHeight, kind).tile();
            EXPECT_EQ(a.radiance, b.radiance) << seed;
            EXPECT_EQ(a.counts.rays, b.counts.rays) << seed;
        }
    }
}

TEST(World, SceneMovedFarAwayLooksTheSame) {
    const Scene scene = mixedScene(7);
    const auto here = Tracing(scene, toDepth(4), kWidth, kHeight).radiance();
    for (const DVec3& offset : {DVec3(1e4, 0, 0), DVec3(148376, 1234, -223423)}) {
        const Tracing moved(mapped(scene, at(offset)), toDepth(4), kWidth, kHeight);
        const Difference difference = compare(here, moved.radiance());
        EXPECT_LT(difference.rms, 0.5 / 255);
        EXPECT_LE(difference.pixels, 1);
    }
}

TEST(World, SceneScaledLooksTheSame) {
    const Scene scene = mixedScene(8);
    const auto here = Tracing(scene, toDepth(4), kWidth, kHeight).radiance();
    for (const double scale : {1e-3, 1e3}) {
        Scene scaled = mapped(scene, glm::scale(DMat4(1), DVec3(scale)));
        for (Material& material : scaled.materials)
            std::get<TaughtMaterial>(material.model).attenuation /= static_cast<float>(scale);
        const Difference difference = compare(here, Tracing(scaled, toDepth(4), kWidth, kHeight).radiance());
        EXPECT_LT(difference.rms, 0.5 / 255) << scale;
        EXPECT_LE(difference.pixels, 2) << scale;
    }
}

TEST(World, MirroredSceneGivesTheMirroredPictureBitForBit) {
    Scene scene = underSky({0.3F, 0.5F, 0.8F});
    add(scene, Sphere{0.5F}, glass(1.5F, Color(0.9F)), at({0.7, 0.2, -4}));
    add(scene, Sphere{0.5F}, mirror(Color(0.8F)), at({-0.7, 0.1, -5}));
    add(scene, Plane{20, 20, true}, matte(Color(0.5F)), at({0, -0.5, -5}));
    scene.lights = {taughtLampAt({1, 3, -3})};
    const DMat4 flip = glm::scale(DMat4(1), DVec3(-1, 1, 1));
    Scene flipped = scene;
    for (Object& object : flipped.objects) object.transform = flip * object.transform * flip;
    flipped.lights[0].transform = flip * scene.lights[0].transform * flip;
    const auto a = Tracing(scene, toDepth(5), kWidth, kHeight).radiance();
    const auto b = Tracing(flipped, toDepth(5), kWidth, kHeight).radiance();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            ASSERT_EQ(a[static_cast<std::size_t>(y * kWidth + x)],
                      b[static_cast<std::size_t>(y * kWidth + kWidth - 1 - x)]);
}

TEST(World, TwiceTheLightIsTwiceThePictureBitForBit) {
    Scene scene = mixedScene(9);
    scene.environment = {};
    scene.ambient = Color(0);
    const auto once = Tracing(scene, toDepth(4), kWidth, kHeight).radiance();
    for (Light& light : scene.lights) light.intensity *= 2;
    const auto twice = Tracing(scene, toDepth(4), kWidth, kHeight).radiance();
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(2.0F * once[i], twice[i]);
}

/// The index that object `i` of a World refers to.
const void* meshIndexOf(const World& world, std::size_t i) {
    return std::visit(
        [&](const auto& geometry) {
            return static_cast<const void*>(std::get<1>(geometry.instances[i].geometry).get());
        },
        *world.accel);
}

TEST(World, SharesTheIndicesOfMeshesThatDidNotChange) {
    Scene scene = underSky(Color(0));
    add(scene, cases::closedMesh(8, 16, 1), matte(Color(1)));
    add(scene, cases::closedMesh(4, 6, 1), matte(Color(1)), at({3, 0, 0}));
    scene.objects.push_back(scene.objects[0]);
    const auto build = [&](const World* previous, AccelKind kind = AccelKind::Bvh2) {
        return buildWorld(std::make_shared<const Scene>(scene), {kind}, previous);
    };
    const auto old = build(nullptr);
    EXPECT_EQ(meshIndexOf(*old, 0), meshIndexOf(*old, 2)) << "two instances of a mesh";
    EXPECT_NE(meshIndexOf(*old, 0), meshIndexOf(*old, 1));

    scene.materials[0].model = mirror(Color(1));
    scene.objects[0].transform = at({0, 5, 0});
    scene.meshes[1].triangles = std::make_shared<const TriangleMesh>(cases::closedMesh(5, 6, 1));
    const auto edited = build(old.get());
    EXPECT_EQ(meshIndexOf(*edited, 0), meshIndexOf(*old, 0));
    EXPECT_NE(meshIndexOf(*edited, 1), meshIndexOf(*old, 1));
    EXPECT_NE(meshIndexOf(*build(nullptr), 0), meshIndexOf(*old, 0)) << "nothing is shared unasked";
    EXPECT_NE(build(old.get(), AccelKind::Brute), nullptr) << "nor with an index of another kind";
}

TEST(World, SharesItsIndexWhileNoSurfaceMoves) {
    Scene scene = mixedScene(11);
    const auto build = [&](const World* previous) {
        return buildWorld(std::make_shared<const Scene>(scene), {AccelKind::Bvh8}, previous);
    };
    auto world = build(nullptr);
    const auto expectShared = [&](bool shared, const char* what) {
        const auto edited = build(world.get());
        EXPECT_EQ(edited->accel == world->accel, shared) << what;
        const Tracing anew(build(nullptr), toDepth(4), kWidth, kHeight);
        EXPECT_EQ(Tracing(edited, toDepth(4), kWidth, kHeight).radiance(), anew.radiance()) << what;
        EXPECT_EQ(edited->primitives, anew.world().primitives) << what;
        EXPECT_EQ(edited->nodes, anew.world().nodes) << what;
        EXPECT_EQ(edited->bytes, anew.world().bytes) << what;
        world = edited;
    };
    expectShared(true, "nothing");
    const auto opaque = std::ranges::find_if(
        scene.materials, [](const Material& material) { return !needsOf(material.model).transmits; });
    opaque->model = matte({0.1F, 0.9F, 0.2F});
    expectShared(true, "colour");
    opaque->model = mirror(Color(0.8F));
    expectShared(true, "matte to mirror");
    opaque->model = glass(1.5F, Color(0.9F));
    expectShared(false, "opaque to glass, which other rays go through");
    scene.lights[0].intensity *= 0.5;
    scene.lights[0].transform = at({1, 4, 2});
    scene.lights[2].color = {1, 0.5F, 0.5F};
    expectShared(true, "lamps without surface, and colour");
    scene.lights[2].transform[3].y += 0.1;
    expectShared(false, "the surface of a lamp");
    scene.objects[7].visible = false;
    expectShared(false, "an object less");
}

TEST(World, RefittedToMovedObjectsGivesTheBitsOfOneBuiltAnew) {
    Scene scene = mixedScene(12);
    const auto shared = [&] { return std::make_shared<const Scene>(scene); };
    for (const AccelKind kind : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8}) {
        const auto old = buildWorld(shared(), {kind});
        EXPECT_FALSE(old->refitted);
        scene.objects[5].transform[3].x += 0.1;
        scene.objects[25].transform[3].y -= 0.2;
        const auto moved = refitWorld(shared(), {kind}, *old);
        EXPECT_EQ(moved->refitted, kind != AccelKind::Brute);
        const auto anew = buildWorld(shared(), {kind}, moved.get());
        EXPECT_FALSE(anew->refitted);
        EXPECT_EQ(refitWorld(shared(), {kind}, *moved)->accel, moved->accel) << "nothing has moved since";
        EXPECT_EQ(Tracing(moved, toDepth(4), kWidth, kHeight).radiance(),
                  Tracing(anew, toDepth(4), kWidth, kHeight).radiance());
    }
}

TEST(World, CountsPrimitivesOfAllInstances) {
    Scene scene = underSky(Color(0));
    const TriangleMesh mesh = cases::closedMesh(8, 16, 1);
    add(scene, mesh, matte(Color(1)));
    scene.objects.push_back(scene.objects[0]);
    add(scene, Sphere{1}, matte(Color(1)));
    const Tracing tracing(scene);
    EXPECT_EQ(tracing.world().primitives, 2 * mesh.triangles.size() + 1);
    EXPECT_EQ(tracing.world().accelKind, AccelKind::Bvh8);
}

/// What Auto becomes.
AccelKind automatic(const Scene& scene, bool byStreams) {
    return buildWorld(std::make_shared<const Scene>(scene), {.byStreams = byStreams})->accelKind;
}

TEST(World, OfAFewPrimitivesIsNotIndexed) {
    for (const bool byStreams : {false, true}) {
        Scene scene = underSky(Color(0));
        const std::size_t most = byStreams ? kMostByStreams : kMostOneByOne;
        for (std::size_t i = 0; i < most; ++i) add(scene, Sphere{1}, matte(Color(1)));
        EXPECT_EQ(automatic(scene, byStreams), AccelKind::Brute);
        add(scene, Sphere{1}, matte(Color(1)));
        EXPECT_EQ(automatic(scene, byStreams), AccelKind::Bvh8);
        scene.objects.back().visible = false;
        EXPECT_EQ(automatic(scene, byStreams), AccelKind::Brute);
        scene.lights = {lampAt({0, 4, 0}, RectangleLamp{1, 1})};
        EXPECT_EQ(automatic(scene, byStreams), AccelKind::Bvh8) << "a lamp that is seen counts";
        scene.lights[0].shape = PointLamp{};
        EXPECT_EQ(automatic(scene, byStreams), AccelKind::Brute);
    }
}

TEST(World, OfAsManyPrimitivesIsIndexedSoonerForRaysThatComeOneByOne) {
    Scene scene = underSky(Color(0));
    for (std::size_t i = 0; i <= kMostOneByOne; ++i) add(scene, Box{}, matte(Color(1)));
    EXPECT_EQ(automatic(scene, false), AccelKind::Bvh8);
    EXPECT_EQ(automatic(scene, true), AccelKind::Brute);
}

TEST(World, OfTwoCylindersIsIndexedForTheyTakeLongToTest) {
    Scene scene = underSky(Color(0));
    add(scene, Cylinder{1, 0.5F, 0.5F}, matte(Color(1)));
    EXPECT_EQ(automatic(scene, true), AccelKind::Brute);
    add(scene, Cylinder{1, 0, 0.5F}, matte(Color(1)));
    EXPECT_EQ(automatic(scene, true), AccelKind::Bvh8);
}

TEST(World, OfPlanesWithoutEndIsNotIndexedForEveryRayIsTestedAgainstThem) {
    Scene scene = underSky(Color(0));
    for (std::size_t i = 0; i <= kMostByStreams; ++i) add(scene, Plane{}, matte(Color(1)));
    EXPECT_EQ(automatic(scene, true), AccelKind::Brute);
    for (Shape& shape : scene.shapes) shape = Plane{1, 1, true};
    EXPECT_EQ(automatic(scene, true), AccelKind::Bvh8);
}

TEST(World, LeavesOutWhatIsInvisibleOrFlat) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, matte(Color(1)), at({0, 0, -3}));
    add(scene, Sphere{1}, matte(Color(1)), glm::scale(at({0, 0, -4}), DVec3(1, 0, 1)));
    add(scene, Sphere{1}, glowing(Color(2)), at({0, 0, -9}));
    scene.objects[0].visible = false;
    const Tracing tracing(scene);
    EXPECT_EQ(tracing.world().primitives, 1U);
    const Retrace sample = tracing.retrace();
    EXPECT_EQ(sample.rays.front().object, 2) << "ids are those of the scene";
    EXPECT_EQ(sample.radiance, Color(2));
}

TEST(World, LampsGlowOnTheSideThatTheyLight) {
    Scene scene = underSky(Color(0));
    scene.lights = {lampAt({0, 0, -3}, RectangleLamp{1, 0.5}, 5)};
    scene.lights[0].color = {1, 0.5F, 0.25F};
    const auto seenFrom = [&](const DVec3& eye, const DVec3& target) {
        look(scene, eye, target);
        return Tracing(scene).retrace();
    };
    EXPECT_EQ(seenFrom({0, 0, 0}, {0, 0, -3}).radiance, Color(0)) << "shines along −z, away from the eye";
    const Retrace behind = seenFrom({0.49, 0.24, -6}, {0.49, 0.24, -3});
    EXPECT_EQ(behind.radiance, Color(5, 2.5F, 1.25F));
    EXPECT_EQ(behind.rays.front().object, -1);
    EXPECT_EQ(seenFrom({0.51, 0, -6}, {0.51, 0, -3}).radiance, Color(0));
    EXPECT_EQ(seenFrom({0, 0.26, -6}, {0, 0.26, -3}).radiance, Color(0));
    scene.lights[0].shape = SphereLamp{0.5};
    EXPECT_EQ(seenFrom({0, 0.49, 0}, {0, 0.49, -3}).radiance, Color(5, 2.5F, 1.25F));
    scene.lights[0].enabled = false;
    EXPECT_EQ(seenFrom({0, 0, 0}, {0, 0, -3}).radiance, Color(0));
}

TEST(World, IsNothingWhenItsBuildIsStopped) {
    const std::stop_source stop;
    stop.request_stop();
    const auto scene = std::make_shared<const Scene>(mixedScene(10));
    EXPECT_EQ(buildWorld(scene, {}, nullptr, stop.get_token()), nullptr);
}

TEST(World, OfAnEmptySceneShowsTheSky) {
    Scene scene = underSky({0.25F, 0.5F, 0.75F});
    EXPECT_EQ(Tracing(scene).pixel(), Color(0.25F, 0.5F, 0.75F));
    add(scene, Plane{}, glowing(Color(1)), at({0, -1, 0}));
    look(scene, {0, 1e5, 0}, {0, 0, 0});
    EXPECT_EQ(Tracing(scene).pixel(), Color(1)) << "and of an unbounded one its plane";
}

}
}
