// labels: unit
// Lamps, the taught local models and shadow rays, by hand.

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

const DVec3 kEye(2, 1.5, 1), kLamp(-1, 2, 0.5); // above a floor y = 0, looking at the origin

Scene floorSeen(const MaterialModel& material) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, material);
    look(scene, kEye, DVec3(0));
    return scene;
}

void expectColor(const Color& actual, const DVec3& expected, double relative = 2e-6) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], relative * std::fabs(expected[c])) << "channel " << c;
}

/// I = Ia·ka + light·(kd (L·N) + ks (R·V)^n) or, for Blinn, (H·N)^n: as the lecture writes it.
DVec3 lectureFormula(const TaughtMaterial& m, const DVec3& ambient, const DVec3& light, const DVec3& towards,
                     const DVec3& normal) {
    const DVec3 l = glm::normalize(towards), v = glm::normalize(kEye), n = normal;
    const DVec3 r = 2 * glm::dot(l, n) * n - l, h = glm::normalize(l + v);
    const double angle = m.specularModel == SpecularModel::Phong ? glm::dot(r, v) : glm::dot(h, n);
    return ambient * DVec3(m.ambient) +
           light * (DVec3(m.diffuse) * glm::dot(l, n) +
                    DVec3(m.specular) * std::pow(std::fmax(angle, 0), static_cast<double>(m.shininess)));
}

TaughtMaterial shiny(SpecularModel model) {
    TaughtMaterial m = matte({0.5F, 0.4F, 0.3F}, {0.1F, 0.2F, 0.3F});
    m.specular = Color(0.6F, 0.5F, 0.4F);
    m.shininess = 12;
    m.specularModel = model;
    return m;
}

TEST(DirectLight, IsTheLecturesFormulaWithATaughtLamp) {
    const Color ambient(0.3F, 0.2F, 0.1F), light(0.9F, 0.5F, 0.2F);
    std::array<Color, 2> seen;
    for (const SpecularModel model : {SpecularModel::Phong, SpecularModel::BlinnPhong}) {
        const TaughtMaterial material = shiny(model);
        Scene scene = floorSeen(material);
        scene.ambient = ambient;
        scene.lights = {taughtLampAt(kLamp, light)};
        const Color actual = Tracing(scene, casting()).pixel();
        expectColor(actual, lectureFormula(material, ambient, light, kLamp, {0, 1, 0}), 1e-5);
        seen[static_cast<std::size_t>(model)] = actual;
    }
    EXPECT_GT(glm::length(seen[0] - seen[1]), 0.01F) << "Phong and Blinn-Phong differ";
}

TEST(DirectLight, OfSeveralLampsAddsUp) {
    const TaughtMaterial material = shiny(SpecularModel::Phong);
    Scene scene = floorSeen(material);
    scene.lights = {taughtLampAt(kLamp, Color(1, 0, 0)), taughtLampAt({1, 1, 1}, Color(0, 1, 0)),
                    taughtLampAt({0, 3, 0}, Color(1, 1, 1))};
    scene.lights.back().enabled = false;
    expectColor(Tracing(scene, casting()).pixel(),
                lectureFormula(material, {}, {1, 0, 0}, kLamp, {0, 1, 0}) +
                    lectureFormula(material, {}, {0, 1, 0}, {1, 1, 1}, {0, 1, 0}),
                1e-5);
}

TEST(DirectLight, OfAPointLampFallsWithTheSquareOfTheDistance) {
    const auto radianceFrom = [](const DVec3& lamp) {
        Scene scene = floorSeen(matte(Color(0.5F)));
        scene.lights = {lampAt(lamp, PointLamp{}, 10)};
        return Tracing(scene, casting()).pixel();
    };
    expectColor(radianceFrom({0, 2, 0}), DVec3(0.397887358));
    expectColor(radianceFrom({3, 2, 0}), DVec3(0.067910214));
    expectColor(radianceFrom({0, 4, 0}), DVec3(0.397887358 / 4));
}

TEST(DirectLight, OfAPointLampEndsAtItsRange) {
    Scene scene = floorSeen(matte(Color(0.5F)));
    scene.lights = {lampAt({0, 2, 0})};
    scene.lights[0].range = 2.001;
    EXPECT_GT(Tracing(scene, casting()).pixel().r, 0);
    scene.lights[0].range = 1.999;
    EXPECT_EQ(Tracing(scene, casting()).pixel(), Color(0));
}

TEST(DirectLight, OfADirectionalLampGoesWithTheCosine) {
    Scene scene = floorSeen(matte(Color(0.5F)));
    scene.lights = {lampAt({7, 8, 9}, DirectionalLamp{}, 3)};
    scene.lights[0].transform = facing({0, -1, std::sqrt(3.0)}); // 60° from the vertical
    expectColor(Tracing(scene, casting()).pixel(), DVec3(0.5 / kPiD * 3 * 0.5));
}

TEST(DirectLight, OfASpotIsFullInTheInnerConeAndFadesOutSquared) {
    const SpotLamp spot{radians(20), radians(40)};
    const auto share = [&](double degrees) { // that a point at this angle from the axis gets
        Scene scene = floorSeen(matte(Color(1)));
        scene.lights = {lampAt({0, 2, 0}, spot, kPiD * 4)};
        scene.lights[0].transform *= facing({std::sin(radians(degrees)), -std::cos(radians(degrees)), 0});
        return static_cast<double>(Tracing(scene, casting()).pixel().r);
    };
    EXPECT_NEAR(share(0), 1, 1e-5);
    EXPECT_NEAR(share(19.9), 1, 1e-5);
    const double edge =
        (std::cos(radians(30)) - std::cos(radians(40))) / (std::cos(radians(20)) - std::cos(radians(40)));
    EXPECT_NEAR(share(30), edge * edge, 1e-5);
    EXPECT_EQ(share(40.1), 0);
    EXPECT_EQ(share(180), 0);
}

TEST(DirectLight, OfARectangleIsThatOfAPointWithACosine) {
    const auto radiance = [](const DVec3& shines) {
        Scene scene = floorSeen(matte(Color(0.5F)));
        scene.lights = {lampAt({0, 4, 3}, RectangleLamp{0.5, 0.4}, 7)};
        scene.lights[0].transform *= facing(shines);
        return Tracing(scene, casting()).pixel();
    };
    const double pointLike = 0.5 / kPiD * 7 * 0.5 * 0.4 * (4.0 / 5) / 25;
    expectColor(radiance({0, -1, 0}), DVec3(pointLike * 4.0 / 5));
    expectColor(radiance({0, -4, -3}), DVec3(pointLike));
    EXPECT_EQ(radiance({0, 1, 0}), Color(0)) << "from behind";
}

TEST(DirectLight, OfASphereLampIsThatOfItsDisk) {
    Scene scene = floorSeen(matte(Color(0.5F)));
    scene.lights = {lampAt({0, 3, 0}, SphereLamp{0.2}, 7)};
    expectColor(Tracing(scene, casting()).pixel(), DVec3(0.5 / kPiD * 7 * kPiD * 0.04 / 9));
}

TEST(DirectLight, OfALampThatFollowsTheCameraComesFromTheEye) {
    Scene scene = floorSeen(matte(Color(0.5F)));
    scene.lights = {taughtLampAt({0, 0, 0})};
    scene.lights[0].followsCamera = true;
    const double cosine = kEye.y / glm::length(kEye);
    expectColor(Tracing(scene, casting()).pixel(), DVec3(0.5 * cosine), 1e-5);

    scene.lights[0].shape = DirectionalLamp{}; // shines where the camera looks
    expectColor(Tracing(scene, casting()).pixel(), DVec3(0.5 * cosine), 1e-5);
}

TEST(DirectLight, LeavesTheUnlitSideExactlyDark) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, shiny(SpecularModel::Phong), at({0, 0, -4}));
    add(scene, cases::closedMesh(40, 80, 1.0), shiny(SpecularModel::BlinnPhong), at({2, 0, -4}));
    scene.lights = {taughtLampAt({5, 3, -4})};
    const Tracing tracing(scene, casting(), 64, 48);
    int dark = 0, lit = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const Retrace sample = tracing.retrace(x, y);
            const RayRecord& eye = sample.rays.front();
            if (eye.object < 0) continue;
            const DVec3 p = DVec3(eye.origin) + static_cast<double>(eye.t) * DVec3(eye.direction) +
                            tracing.world().origin;
            const DVec3 normal = p - DVec3(2 * eye.object, 0, -4);
            const double cosine = glm::dot(glm::normalize(normal), glm::normalize(DVec3(5, 3, -4) - p));
            if (cosine > 0.1) lit += sample.radiance.g > 0 ? 1 : 0;
            if (cosine > -0.1) continue; // the mesh is only nearly a ball
            EXPECT_EQ(sample.radiance, Color(0));
            EXPECT_EQ(sample.rays.size(), 1U) << "nor is a shadow ray spent there";
            ++dark;
        }
    EXPECT_GT(dark, 100);
    EXPECT_GT(lit, 100);
}

TEST(DirectLight, OnASmoothMeshFollowsItsNormalsOnBothSides) {
    TriangleMesh mesh = cases::closedMesh(12, 24, 1.0); // facets of 15°
    for (const Vec3& p : mesh.positions) mesh.normals.push_back(glm::normalize(p));
    Scene scene = underSky(Color(0));
    add(scene, mesh, matte(Color(1)));
    cases::Random random(2);
    for (const double distance : {3.0, 0.0}) // of the eye, outside and in the middle; the lamp is with it
        for (int i = 0; i < 200; ++i) {
            const DVec3 towards = random.direction(), eye = distance * towards;
            look(scene, eye, eye - towards);
            scene.lights = {taughtLampAt(eye + 0.5 * glm::cross(towards, random.direction()))};
            const Retrace sample = Tracing(scene, casting()).retrace();
            const RayRecord& ray = sample.rays.front();
            const DVec3 p = eye - static_cast<double>(ray.t) * towards;
            const DVec3 normal = distance > 0 ? glm::normalize(p) : -glm::normalize(p);
            const DVec3 lamp = DVec3(scene.lights[0].transform[3]);
            EXPECT_NEAR(sample.radiance.g, glm::dot(normal, glm::normalize(lamp - p)), 0.004);
        }
}

/// The floor at the origin under a lamp at height 4, with something in the scene besides.
struct Shadowed {
    Scene scene = floorSeen(matte(Color(1)));

    Shadowed() {
        scene.lights = {taughtLampAt({0, 4, 0})};
        scene.cameras[0].eye = {3, 0.5, 0};
    }
    Color seen(const TraceSettings& settings = casting()) const { return Tracing(scene, settings).pixel(); }
};

const Shape kCube = Box{Vec3(1)};

TEST(ShadowRays, AreBlockedByWhatStandsBetween) {
    Shadowed s;
    expectColor(s.seen(), DVec3(1));
    add(s.scene, kCube, matte(Color(1)), at({0, 2, 0}));
    EXPECT_EQ(s.seen(), Color(0));
    s.scene.objects.back().transform = at({0.51, 2, 0});
    expectColor(s.seen(), DVec3(1));
    s.scene.objects.back().transform = at({0.49, 2, 0});
    EXPECT_EQ(s.seen(), Color(0));
    s.scene.objects.back().visible = false;
    expectColor(s.seen(), DVec3(1));
}

TEST(ShadowRays, EndAtTheLamp) {
    Shadowed s;
    add(s.scene, kCube, matte(Color(1)), at({0, 4.5 + 1e-4, 0}));
    expectColor(s.seen(), DVec3(1));
    s.scene.objects.back().transform = at({0, 4.5 - 1e-3, 0});
    EXPECT_EQ(s.seen(), Color(0)) << "here the lamp is inside the box";
}

TEST(ShadowRays, ReachALampThatLiesInTheCeiling) {
    cases::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const DVec3 offset = random.inCube(100);
        Shadowed s;
        s.scene.lights[0].transform = at(DVec3(offset.x, 4, offset.z));
        add(s.scene, Plane{}, matte(Color(1)), glm::rotate(at({0, 4, 0}), kPiD, DVec3(1, 0, 0)));
        EXPECT_GT(s.seen().g, 0.01F);
    }
}

TEST(ShadowRays, OfADirectionalLampReachForEver) {
    Shadowed s;
    s.scene.lights[0] = lampAt({0, 1, 0}, DirectionalLamp{}, kPiD);
    s.scene.lights[0].transform *= facing({0, -1, 0});
    expectColor(s.seen(), DVec3(1));
    add(s.scene, kCube, matte(Color(1)), at({0, 1e5, 0}));
    EXPECT_EQ(s.seen(), Color(0));
}

TEST(ShadowRays, PassTheSurfaceOfALamp) {
    Shadowed s;
    s.scene.lights = {lampAt({0, 4, 0}, SphereLamp{1}, 16)};
    expectColor(s.seen(), DVec3(1));
    s.scene.lights.push_back(lampAt({0, 2, 0}, SphereLamp{0.5}, 4 * 4));
    expectColor(s.seen(), DVec3(2)); // nor does one lamp shade another
}

TEST(ShadowRays, SwitchedOffShadeNothing) {
    Shadowed s;
    add(s.scene, kCube, matte(Color(1)), at({0, 2, 0}));
    TraceSettings settings = casting();
    settings.shadows = false;
    expectColor(s.seen(settings), DVec3(1));
    EXPECT_EQ(Tracing(s.scene, settings).tile().counts[RayKind::Shadow], 0U);
    settings = casting();
    settings.method = Method::Local;
    expectColor(s.seen(settings), DVec3(1));
    EXPECT_EQ(Tracing(s.scene, settings).tile().counts[RayKind::Shadow], 0U);
    EXPECT_EQ(Tracing(s.scene, casting()).tile().counts[RayKind::Shadow], 1U);
}

TraceSettings withGlassShadows(GlassShadows policy) {
    TraceSettings settings = casting();
    settings.glassShadows = policy;
    return settings;
}

TEST(ShadowRays, MeetGlassByTheNamedPolicy) {
    Shadowed s;
    const Color kt(0.9F, 0.8F, 0.7F), sigma(0.5F, 1, 2);
    add(s.scene, kCube, glass(1.5F, kt, sigma), at({0, 2, 0}));
    const DVec3 through = DVec3(kt) * DVec3(kt) * glm::exp(-DVec3(sigma));
    expectColor(s.seen(withGlassShadows(GlassShadows::Straight)), through, 1e-5);
    expectColor(s.seen(withGlassShadows(GlassShadows::OpaqueOnly)), DVec3(1));
    EXPECT_EQ(s.seen(withGlassShadows(GlassShadows::AllBlock)), Color(0));
    add(s.scene, Sphere{0.1F}, matte(Color(1)), at({0, 2, 0}));
    for (const auto policy : {GlassShadows::Straight, GlassShadows::OpaqueOnly, GlassShadows::AllBlock})
        EXPECT_EQ(s.seen(withGlassShadows(policy)), Color(0)) << "something opaque inside";
}

TEST(ShadowRays, AreDimmedByTheMediumTheyAreIn) {
    Shadowed s; // half a metre of ball in a metre of block
    add(s.scene, kCube, glass(1.33F, Color(0.9F), Color(0.3F)), at({0, 2, 0}));
    add(s.scene, Sphere{0.25F}, glass(1.5F, Color(0.8F), Color(2)), at({0, 2.1, 0}));
    const double expected = 0.81 * 0.64 * std::exp(-0.3 * 0.5 - 2 * 0.5);
    expectColor(s.seen(), DVec3(expected), 1e-5);
}

TEST(ShadowRays, AreDimmedUpToALampInsideGlass) {
    Shadowed s;
    s.scene.lights = {taughtLampAt({0, 2, 0})};
    add(s.scene, Sphere{0.5F}, glass(1.5F, Color(0.8F), Color(2)), at({0, 2, 0}));
    expectColor(s.seen(), DVec3(0.8 * std::exp(-2 * 0.5)), 1e-5);
}

TEST(ShadowRays, StartInTheMediumOfTheRayThatHit) {
    Shadowed s; // the floor lies in a pool, 1.5 deep, which the eye is in too
    add(s.scene, Box{{20, 2, 20}}, glass(1.33F, Color(0.9F), Color(0.3F)), at({0, 0.5, 0}));
    const double toFloor = glm::length(s.scene.cameras[0].eye);
    expectColor(s.seen(), DVec3(0.9 * std::exp(-0.3 * (1.5 + toFloor))), 1e-5);
}

TEST(ShadowRays, ThroughAThinPaneLoseOnlyItsTint) {
    Shadowed s;
    add(s.scene, Plane{1, 1, true}, glass(1.5F, Color(0.8F), Color(5)), at({0, 2, 0}));
    expectColor(s.seen(), DVec3(0.8), 1e-5);
}

TEST(ShadowRays, PassHundredThinLayersEachOnce) {
    Shadowed s;
    for (int i = 0; i < 100; ++i)
        add(s.scene, Plane{1, 1, true}, glass(1.5F, Color(0.99F)), at({0, 2 + i * 1e-5, 0}));
    expectColor(s.seen(), DVec3(std::pow(0.99, 100)), 1e-4);
}

}
}
