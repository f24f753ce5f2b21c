// labels: unit threads
// Eye hits that one picture leaves to the next: the same bits as without, and forgotten when they must be.

#include <gtest/gtest.h>

#include <functional>

#include "core/render/render_session.h"
#include "tests/geometry_cases.h"
#include "tests/instruction_sets.h"
#include "tests/random_methods.h"

namespace eyeray {
namespace {

using namespace scenes;
using namespace std::chrono_literals;

constexpr std::array kMethods = {Method::Local, Method::Cast, Method::Whitted, Method::Distributed,
                                 Method::Path};

/// Shapes, meshes, glass, mirrors and a texture under sky and lamps with and without a surface.
Scene everything() {
    Scene scene = showroom();
    scene.textures = {{"", CheckerTexture{Color(0.9F), Color(0.1F)}}};
    TaughtMaterial checkered = matte(Color(0.8F), Color(0.8F));
    checkered.diffuseTexture.texture = 0;
    add(scene, Plane{1, 1, true}, checkered, at({0, -0.9, 1}));
    add(scene, Sphere{0.2F}, glass(1.5F, Color(0.9F)), at({0.6, 0.3, 0.5}));
    add(scene, Sphere{0.2F}, mirror(Color(0.8F)), at({-0.6, 0.3, 0.5}));
    add(scene, cases::closedMesh(8, 12, 0.25), matte({0.2F, 0.7F, 0.3F}), at({0, 0.5, 0.5}));
    look(scene, {0, 0, 3.6}, {0, 0, 0}, 60);
    return scene;
}

std::shared_ptr<const World> worldOf(const Scene& scene, AccelKind accel = AccelKind::Auto,
                                     const World* previous = nullptr) {
    return buildWorld(std::make_shared<const Scene>(scene), {accel}, previous);
}

RenderSettings settingsFor(const TraceSettings& trace) {
    RenderSettings settings;
    settings.width = 72, settings.height = 50; // so that tiles are cut on the right and below
    settings.trace = trace;
    settings.stop.samples = 2;
    return settings;
}

void expectEqual(const std::vector<Color>& a, const std::vector<Color>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(a[i] == b[i]) << "sample " << i;
}

/// Memory for the hits of a tile.
struct Kept {
    static constexpr std::size_t kSamples = 1024;
    std::vector<float> t, u, v;
    std::vector<std::uint32_t> primitive, instance;

    Kept() : t(kSamples), u(kSamples), v(kSamples), primitive(kSamples), instance(kSamples) {}
    TileHits hits(bool known) {
        return {t.data(), u.data(), v.data(), primitive.data(), instance.data(), known};
    }
};

TileResult rendered(const Tracing& tracing, const Tile& tile) {
    const FloatEnvironment environment;
    return tracing.integrator().renderTile(tracing.context(), tile, 0);
}

TEST(EyeHits, ThatAnyMethodLeavesGiveAnyOtherTheSameBits) {
    withEachInstructionSet([] {
        for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh8}) {
            const auto world = worldOf(everything(), accel);
            for (const Method leaves : {Method::Cast, Method::Path})
                for (const Method finds : {Method::Whitted, Method::Distributed})
                    for (const int step : {1, 4}) {
                        const Tracing first(world, by(leaves), 40, 30), next(world, by(finds), 40, 30);
                        Tile tile{8, 8, 40, 30, step};
                        Kept kept;
                        const TileResult traced = rendered(next, tile);
                        tile.hits = kept.hits(false);
                        rendered(first, tile);
                        tile.hits = kept.hits(true);
                        const TileResult known = rendered(next, tile);
                        expectEqual(known.radiance, traced.radiance);
                        EXPECT_EQ(known.counts.rays, traced.counts.rays) << "the picture's rays count";
                    }
        }
    });
}

TEST(EyeHits, AreTakenInThePlaceOfTracing) {
    Scene scene = underSky({0.25F, 0.5F, 1});
    add(scene, Sphere{1}, matte(Color(0)), at({0, 0, -2}));
    for (const Method method : kMethods) {
        const Tracing tracing(scene, by(method), 32, 32);
        Kept kept;
        std::ranges::fill(kept.instance, TileHits::kMissed);
        for (const Color& c : rendered(tracing, {0, 0, 32, 32, 1, {}, kept.hits(true)}).radiance)
            ASSERT_EQ(c, Color(0.25F, 0.5F, 1)) << "nothing but the sky is said to be there";
    }
}

/// A scene and settings that a person changes step by step; the session keeps what it may.
struct Workplace {
    Scene scene = everything();
    RenderSettings settings = settingsFor(toDepth(4));
    AccelKind accel = AccelKind::Auto;
    std::shared_ptr<const World> world = worldOf(scene);

    TaughtMaterial& materialOf(std::size_t object) {
        auto& model = scene.materials[static_cast<std::size_t>(scene.objects[object].material)].model;
        if (!std::holds_alternative<TaughtMaterial>(model)) model = matte(Color(0.5F));
        return std::get<TaughtMaterial>(model);
    }
    void start(RenderSession& session) {
        world = worldOf(scene, accel, world.get());
        session.start(world, scene.cameras.front(), settings);
    }
    /// The picture by a session that knows nothing.
    ColorImage anew() const {
        RenderSession session(1);
        session.start(worldOf(scene, accel), scene.cameras.front(), settings);
        EXPECT_EQ(session.wait(120s).knownHits, 0U);
        return session.image();
    }
};

enum class Leaves : std::uint8_t { All, Some, None }; // Some: of the tiles that show nothing of it

struct Edit {
    const char* name;
    Leaves leaves;
    std::function<void(Workplace&)> apply;
};

constexpr std::size_t kWall = 2, kMatteBall = 9;

std::vector<Edit> edits() {
    const auto toggle = [](bool& value) { value = !value; };
    std::vector<Edit> all = {
        {"nothing", Leaves::All, [](Workplace&) {}},
        {"a colour", Leaves::All, [](Workplace& w) { w.materialOf(kWall).diffuse *= Color(0.9F, 1, 0.8F); }},
        {"a mirror", Leaves::All, [](Workplace& w) { w.materialOf(kWall).reflectivity = Color(0.4F); }},
        {"a glow", Leaves::All, [](Workplace& w) { w.materialOf(kWall).emission += Color(0.1F, 0.2F, 0); }},
        {"a texture", Leaves::All, [](Workplace& w) { w.materialOf(kWall).diffuseTexture.texture = 0; }},
        {"another material", Leaves::All, [](Workplace& w) { w.scene.objects[0].material ^= 1; }},
        {"glass, or no longer", Leaves::Some,
         [](Workplace& w) {
             TaughtMaterial& material = w.materialOf(kMatteBall);
             material.transmission = isBlack(material.transmission) ? Color(0.8F) : Color(0);
         }},
        {"the sky", Leaves::All, [](Workplace& w) { w.scene.environment.zenith += Color(0.1F); }},
        {"a lamp's colour", Leaves::All, [](Workplace& w) { w.scene.lights[0].color *= Color(1, 0.9F, 1); }},
        {"a lamp that is a point", Leaves::All,
         [](Workplace& w) { w.scene.lights[1].transform = at({0.3, 0.2, 0.7}); }},
        {"a lamp that can be seen", Leaves::Some,
         [](Workplace& w) { w.scene.lights[2].transform *= at({0.1, 0, 0}); }},
        {"a lamp switched", Leaves::None, [&](Workplace& w) { w.scene.lights[0].enabled ^= true; }},
        {"an object moved", Leaves::Some,
         [](Workplace& w) { w.scene.objects[3].transform *= at({0, 0.01, 0}); }},
        {"an object hidden, or shown", Leaves::None,
         [](Workplace& w) { w.scene.objects[5].visible ^= true; }},
        {"the camera", Leaves::None, [](Workplace& w) { w.scene.cameras.front().eye.x += 0.01; }},
        {"the angle of view", Leaves::None,
         [](Workplace& w) { w.scene.cameras.front().verticalFov *= 0.98; }},
        {"the size", Leaves::None, [](Workplace& w) { w.settings.width = w.settings.width == 72 ? 40 : 72; }},
        {"the index", Leaves::None,
         [](Workplace& w) { w.accel = w.accel == AccelKind::Brute ? AccelKind::Bvh8 : AccelKind::Brute; }},
        {"the depth", Leaves::All, [](Workplace& w) { w.settings.trace.maxDepth ^= 1; }},
        {"the seed", Leaves::All, [](Workplace& w) { ++w.settings.seed; }},
        {"shadows", Leaves::All, [=](Workplace& w) { toggle(w.settings.trace.shadows); }},
        {"reflections", Leaves::All, [=](Workplace& w) { toggle(w.settings.trace.reflections); }},
        {"refractions", Leaves::All, [=](Workplace& w) { toggle(w.settings.trace.refractions); }},
        {"diffuse light", Leaves::All, [=](Workplace& w) { toggle(w.settings.trace.diffuse); }},
    };
    for (const Method method : kMethods)
        all.push_back({"the method", Leaves::All, [=](Workplace& w) { w.settings.trace.method = method; }});
    return all;
}

/// Finishes the picture and compares it with one made from nothing.
void expectPicture(RenderSession& session, Workplace& at, Leaves left) {
    const RenderStatus status = session.wait(120s);
    ASSERT_EQ(status.phase, RenderStatus::Phase::Finished) << status.failure;
    ASSERT_EQ(session.image(), at.anew());
    const auto pixels =
        static_cast<std::uint64_t>(at.settings.width) * static_cast<std::uint64_t>(at.settings.height);
    EXPECT_GE(status.knownHits, left == Leaves::All ? pixels : 0);
    EXPECT_LE(status.knownHits, left == Leaves::None ? 0 : pixels);
    EXPECT_EQ(status.counts[RayKind::Eye], 2 * pixels);
}

TEST(EyeHits, OfTheSamePictureAreKnownAfterEditsOfShadingAndForgottenAfterOthers) {
    for (const Edit& edit : edits()) {
        SCOPED_TRACE(edit.name);
        Workplace at;
        RenderSession session(2);
        at.start(session);
        expectPicture(session, at, Leaves::None);
        edit.apply(at);
        at.start(session);
        expectPicture(session, at, edit.leaves);
    }
}

TEST(EyeHits, GiveTheBitsOfNewPicturesThroughManyEditsOfWhichSomeAreInterrupted) {
    const std::vector<Edit> all = edits();
    cases::Random random(4);
    Workplace at;
    RenderSession session(3);
    at.start(session);
    bool whole = false; // all hits of this view have been left
    for (int i = 0; i < 80; ++i) {
        const Edit& edit = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
        SCOPED_TRACE(edit.name);
        edit.apply(at);
        at.start(session);
        whole = whole && edit.leaves == Leaves::All;
        if (random.below(2) == 0) {
            std::this_thread::sleep_for(std::chrono::microseconds(random.below(8000)));
            continue; // some tiles have left theirs, or none
        }
        session.wait(120s);
        ASSERT_EQ(session.image(), at.anew());
        EXPECT_TRUE(!whole || session.status().knownHits > 0);
        whole = true;
    }
}

/// Two small balls far out, between which other objects move without moving the middle of the scene.
Scene wideScene() {
    Scene scene = underSky({0.3F, 0.5F, 0.8F});
    for (const double far : {-9, 9}) add(scene, Sphere{0.1F}, matte(Color(1)), at(DVec3(far)));
    return scene;
}

/// Balls on all sides of the eye, some of them mirrors.
Scene ballsAllAround() {
    Scene scene = wideScene();
    cases::Random random(7);
    for (int i = 0; i < 40; ++i)
        add(scene, Sphere{0.4F}, i % 3 == 0 ? mirror(Color(0.7F)) : matte({0.8F, 0.6F, 0.2F}),
            at(random.inCube(4)));
    add(scene, Plane{}, matte(Color(0.6F)), at({0, -3, 0}));
    scene.lights = {taughtLampAt({4, 5, 3}, Color(0.8F))};
    look(scene, {0, 0, 0}, {0, 0, -1}, 70);
    return scene;
}

TEST(EyeHits, AreKeptWhereAnObjectHasNotMoved) {
    Workplace at;
    at.scene = wideScene();
    add(at.scene, Sphere{0.2F}, matte(Color(0.5F)), scenes::at({-0.7, 0.4, 0}));
    add(at.scene, Sphere{0.2F}, matte(Color(0.5F)), scenes::at({0.7, 0.4, 0}));
    add(at.scene, Sphere{2}, matte(Color(0.5F)), scenes::at({0, -2.5, 0}));
    look(at.scene, {0, 0, 3}, {0, 0, 0}, 40);
    at.settings.width = 160, at.settings.height = 96;
    RenderSession session(2);
    at.start(session);
    expectPicture(session, at, Leaves::None);
    at.scene.objects[2].transform[3].x += 0.05;
    at.start(session);
    expectPicture(session, at, Leaves::Some);
    EXPECT_GT(session.status().knownHits, 10'000U) << "of 15,360 pixels";
    at.scene.objects[4].transform[3].y += 0.1;
    at.start(session);
    expectPicture(session, at, Leaves::Some);
    EXPECT_LT(session.status().knownHits, 8'000U) << "what has moved is large";
}

TEST(EyeHits, GiveTheBitsOfNewPicturesWhileObjectsAreDraggedAllAroundTheEye) {
    cases::Random random(5);
    for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh8}) {
        Workplace at;
        at.scene = ballsAllAround();
        at.accel = accel;
        RenderSession session(3);
        std::uint64_t known = 0;
        for (int i = 0; i < 60; ++i) {
            for (int moved = random.below(3); moved >= 0; --moved) {
                auto& place = at.scene.objects[2 + static_cast<std::size_t>(random.below(40))].transform[3];
                place += DVec4(random.inCube(1), 0);
            }
            at.start(session);
            if (random.below(3) == 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(random.below(4000)));
                continue;
            }
            session.wait(120s);
            ASSERT_EQ(session.image(), at.anew());
            known += session.status().knownHits;
        }
        EXPECT_GT(known, 0U);
    }
}

TEST(EyeHits, OfACoarsePictureAreThoseOfItsPixels) {
    Workplace at;
    RenderSession session(2);
    at.start(session);
    session.wait(120s);
    session.pause(); // it then stays coarse
    at.materialOf(kWall).diffuse = {0.9F, 0.1F, 0.1F};
    at.start(session);
    while (session.status().phase != RenderStatus::Phase::Paused) std::this_thread::yield();
    Picture picture;
    session.read(picture);
    const Tracing tracing(at.scene, at.settings.trace, at.settings.width, at.settings.height);
    for (int y = 0; y < at.settings.height; ++y)
        for (int x = 0; x < at.settings.width; ++x)
            ASSERT_EQ(picture.radiance.at(x, y),
                      tracing.pixel(std::min(x / 4 * 4 + 2, at.settings.width - 1),
                                    std::min(y / 4 * 4 + 2, at.settings.height - 1)));
    session.resume();
    expectPicture(session, at, Leaves::All);
}

TEST(EyeHits, AreNotKeptForPicturesWhoseEyeRaysAreOthers) {
    const std::vector<std::pair<const char*, std::function<void(Workplace&)>>> others = {
        {"lens",
         [](Workplace& w) {
             w.settings.trace.method = Method::Path;
             w.scene.cameras.front().lensRadius = 0.1;
         }},
        {"sample", [](Workplace& w) { w.settings.firstPass = 1; }},
        {"fault", [](Workplace& w) { w.settings.trace.faults.set(Fault::FlippedRows, true); }},
        {"aim", [](Workplace& w) { w.settings.trace.aim = Aim::Edges; }},
        {"not coarse", [](Workplace& w) { w.settings.coarse = false; }}};
    for (const auto& [name, change] : others) {
        SCOPED_TRACE(name);
        Workplace at, usual;
        RenderSession session(2);
        change(at);
        for (const Leaves left : {Leaves::None, Leaves::All}) { // two usual pictures, then two others
            usual.start(session);
            expectPicture(session, usual, left);
        }
        for (int i = 0; i < 2; ++i) {
            at.world = usual.world;
            at.start(session);
            expectPicture(session, at, Leaves::None);
        }
    }
}

}
}
