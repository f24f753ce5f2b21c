// labels: unit
// Photons from the lamps: where they leave, what surfaces do to them, and that no light is made or lost.

#include <gtest/gtest.h>

#include "core/study/photon_walk.h"
#include "core/transport/lights.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

std::shared_ptr<const World> built(const Scene& scene) {
    return buildWorld(std::make_shared<const Scene>(scene), {});
}

/// A walk whose lens stands where no photon comes.
PhotonWalk blind(const Scene& scene) {
    const auto world = built(scene);
    const Camera& camera = scene.cameras.front();
    return {world, camera, lensOf(camera, world->origin, 1, 0)};
}

template <class Each>
void walk(const PhotonWalk& photons, int count, const Each& each) {
    photons.walk(0, count, {}, each);
}

/// Mean over the photons of what of their power lands, at first, within `half` metres of (x, z) on y = 0.
double irradianceAt(const Scene& scene, double x, double z, double half, int photons = 1 << 19) {
    const PhotonWalk all = blind(scene);
    const DVec3 origin = all.world().origin;
    double sum = 0;
    walk(all, photons, [&](const PhotonPath& path) {
        const DVec3 landed = DVec3(path.steps.front().to) + origin;
        if (path.end == PhotonEnd::Escaped && path.steps.size() == 1) return;
        if (std::abs(landed.x - x) < half && std::abs(landed.z - z) < half)
            sum += static_cast<double>(path.steps.front().power.g);
    });
    return sum / photons / (4 * half * half);
}

Scene floorUnder(const Light& lamp, const Color& albedo = Color(0.5F)) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{}, matte(albedo));
    scene.lights.push_back(lamp);
    look(scene, {0, 5, 30}, {0, 5, 31});
    return scene;
}

Light lampTowards(const DVec3& position, const DVec3& direction, const LampShape& shape, double intensity) {
    Light lamp = lampAt(position, shape, intensity);
    lamp.transform = at(position) * facing(direction);
    return lamp;
}

TEST(PhotonWalk, APointLampGivesAPlaneIntensityTimesCosineOverDistanceSquared) {
    const double height = 2, intensity = 7;
    const Scene scene = floorUnder(lampAt({0, height, 0}, PointLamp{}, intensity));
    for (const double x : {0.0, 1.0, 2.5}) {
        const double square = height * height + x * x;
        const double expected = intensity * height / (square * std::sqrt(square));
        EXPECT_NEAR(irradianceAt(scene, x, 0, 0.15) / expected, 1, 0.08) << x;
    }
    EXPECT_NEAR(luminance(blind(scene).lamps().power()), 4 * kPiD * intensity, 1e-3);
}

TEST(PhotonWalk, ASunGivesItsIrradianceTimesTheCosine) {
    Scene scene = floorUnder(lampTowards({0, 0, 0}, {1, -1, 0}, DirectionalLamp{}, 3));
    add(scene, Sphere{0.1F}, matte(Color(0)), at({0, -0.2, 0})); // the middle of the scene
    EXPECT_NEAR(irradianceAt(scene, 0, 0, 6) / (3 * std::sqrt(0.5)), 1, 0.04);
    EXPECT_NEAR(irradianceAt(scene, 20, -9, 6) / (3 * std::sqrt(0.5)), 1, 0.04);
}

TEST(PhotonWalk, ASpotShinesAsTheTracerSeesIt) {
    const Light lamp = lampTowards({0, 2, 0}, {0, -1, 0}, SpotLamp{radians(20), radians(45)}, 5);
    const Scene scene = floorUnder(lamp);
    const auto world = built(scene);
    const double half = 0.1;
    const auto traced = [&](double x, double z) {
        const auto seen = sampleLight(world->lights.front(), Vec3(DVec3(x, 0, z) - world->origin));
        return seen ? static_cast<double>(seen->irradiance.g * seen->wi.y) : 0;
    };
    for (const double x : {0.0, 0.6, 1.0, 1.4, 1.8}) {
        double expected = 0;
        for (const double dx : {-0.8, -0.4, 0.0, 0.4, 0.8})
            for (const double dz : {-0.8, -0.4, 0.0, 0.4, 0.8})
                expected += traced(x + dx * half, dz * half) / 25;
        EXPECT_NEAR(irradianceAt(scene, x, 0, half) / expected, 1, 0.1) << x;
    }
    walk(blind(scene), 1000, [](const PhotonPath& path) {
        EXPECT_LE(-path.emitted.direction.y, 1);
        EXPECT_GE(-path.emitted.direction.y, std::cos(radians(45)) - 1e-6);
    });
}

TEST(PhotonWalk, LampsWithAnExtentShineFromTheirSurface) {
    const DVec3 position(0, 4, 0);
    for (const LampShape& shape :
         {LampShape(RectangleLamp{0.8, 0.3}), LampShape(DiscLamp{0.3}), LampShape(SphereLamp{0.25})}) {
        const Scene scene = floorUnder(lampTowards(position, {0, -1, 0}, shape, 6));
        const auto world = built(scene);
        const auto seen = sampleLight(world->lights.front(), Vec3(DVec3(0) - world->origin));
        const double asPoint = static_cast<double>(seen->irradiance.g);
        EXPECT_NEAR(irradianceAt(scene, 0, 0, 0.2) / asPoint, 1, 0.07) << shape.index();
        walk(blind(scene), 500, [&](const PhotonPath& path) {
            const DVec3 off = DVec3(path.emitted.origin) + world->origin - position;
            if (shape.index() == 3) {
                EXPECT_TRUE(std::abs(off.x) <= 0.4001 && std::abs(off.z) <= 0.4001);
                EXPECT_NEAR(std::abs(off.x * off.z), 0.06, 0.0601);
                EXPECT_NEAR(off.y, 0, 1e-6);
            } else if (shape.index() == 4) {
                EXPECT_LE(glm::length(off), 0.3 + 1e-6);
                EXPECT_NEAR(off.y, 0, 1e-6);
            } else {
                EXPECT_NEAR(glm::length(off), 0.25, 1e-6);
                EXPECT_GE(glm::dot(DVec3(path.emitted.direction), off), -1e-6);
            }
        });
    }
}

TEST(PhotonWalk, TwoLampsSendPhotonsByTheirPower) {
    Scene scene = floorUnder(lampAt({-1, 2, 0}, PointLamp{}, 3));
    scene.lights.push_back(lampAt({1, 2, 0}, PointLamp{}, 1));
    int first = 0;
    walk(blind(scene), 40000, [&](const PhotonPath& path) {
        first += path.emitted.light == 0 ? 1 : 0;
        EXPECT_NEAR(luminance(path.emitted.power), 4 * 4 * kPiD, 1e-3) << "all photons carry the same";
    });
    EXPECT_NEAR(first, 30000, 5 * std::sqrt(40000 * 0.75 * 0.25));
}

TEST(PhotonWalk, ATaughtLampGivesTheMiddleOfTheSceneItsTaughtLight) {
    Scene scene = floorUnder(taughtLampAt({0, 3, 0}, Color(0.5F)));
    add(scene, Box{Vec3(0.01F)}, matte(Color(0.5F)), at({4, 0, 0}));
    add(scene, Box{Vec3(0.01F)}, matte(Color(0.5F)), at({-4, 0, 0}));
    EXPECT_TRUE(blind(scene).lamps().replaced());
    EXPECT_NEAR(irradianceAt(scene, 0, 0, 0.2) / (0.5 * kPiD), 1, 0.06);
}

TEST(PhotonWalk, BeyondItsRangeALampSendsNothing) {
    Light lamp = lampAt({0, 2, 0});
    lamp.range = 1.9;
    walk(blind(floorUnder(lamp)), 1000, [](const PhotonPath& path) {
        EXPECT_EQ(path.end, PhotonEnd::Escaped);
        EXPECT_EQ(path.steps.size(), 1U);
    });
}

/// What becomes of the power of many photons, as shares of all, by channel.
struct Shares {
    DVec3 absorbed{0}, escaped{0}, bounced{0};
};
Shares sharesOf(const Scene& scene, int photons) {
    Shares shares;
    DVec3 all(0);
    walk(blind(scene), photons, [&](const PhotonPath& path) {
        all += DVec3(path.emitted.power);
        shares.absorbed += DVec3(path.absorbed);
        if (path.end == PhotonEnd::Escaped) shares.escaped += DVec3(path.steps.back().power);
        for (std::size_t i = 1; i < path.steps.size(); ++i) shares.bounced += DVec3(path.steps[i].power);
    });
    return {shares.absorbed / all, shares.escaped / all, shares.bounced / all};
}

TEST(PhotonWalk, ADullFloorTakesItsShareOfHalfTheLightAndTheRestEscapes) {
    const Color albedo(0.8F, 0.5F, 0.05F);
    const Shares shares = sharesOf(floorUnder(lampAt({0, 2, 0}), albedo), 100000);
    for (int c = 0; c < 3; ++c) {
        const double taken = (1 - static_cast<double>(albedo[c])) / 2;
        EXPECT_NEAR(shares.absorbed[c], taken, 0.01) << c;
        EXPECT_NEAR(shares.escaped[c], 1 - taken, 0.01) << c;
        EXPECT_NEAR(shares.absorbed[c] + shares.escaped[c], 1, 1e-4) << c;
    }
}

TEST(PhotonWalk, InAClosedBallAllIsAbsorbedAfterTheBouncesOfAGeometricSeries) {
    for (const float albedo : {0.3F, 0.8F}) {
        Scene scene = underSky(Color(0));
        add(scene, Sphere{2}, matte(Color(albedo)));
        scene.lights.push_back(lampAt({0.7, 0.2, 0}));
        look(scene, {0, 0, 9}, {0, 0, 0});
        const Shares shares = sharesOf(scene, 60000);
        EXPECT_NEAR(shares.absorbed.g, 1, 1e-4);
        EXPECT_EQ(shares.escaped.g, 0);
        EXPECT_NEAR(shares.bounced.g / (static_cast<double>(albedo) / (1 - static_cast<double>(albedo))), 1,
                    0.02);
    }
}

TEST(PhotonWalk, ClearGlassAndMirrorsTakeNothing) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, glass(1.5F), at({0, 2, 0}));
    add(scene, Sphere{1}, mirror(Color(1)), at({0, -2, 0}));
    scene.lights.push_back(lampAt({0, 0, 0}));
    look(scene, {0, 0, 9}, {0, 0, 10});
    int refracted = 0, mirrored = 0;
    const Shares shares = sharesOf(scene, 20000);
    walk(blind(scene), 20000, [&](const PhotonPath& path) {
        for (const PhotonStep& step : path.steps) {
            refracted += step.kind == RayKind::Refraction ? 1 : 0;
            mirrored += step.kind == RayKind::Reflection ? 1 : 0;
        }
    });
    EXPECT_GT(refracted, 1000);
    EXPECT_GT(mirrored, 1000);
    EXPECT_NEAR(shares.escaped.g, 1, 1e-4);
    EXPECT_NEAR(shares.absorbed.g, 0, 1e-4);
}

TEST(PhotonWalk, AMediumLeavesByBeerAndLambertWhatItsThicknessSays) {
    Scene scene = underSky(Color(0));
    add(scene, Box{Vec3(4, 1, 4)}, glass(1, Color(1), Color(0.2F, 0.7F, 1.5F)));
    scene.lights.push_back(lampTowards({0, 5, 0}, {0, -1, 0}, DirectionalLamp{}, 1));
    look(scene, {0, 0, 9}, {0, 0, 10});
    int through = 0;
    walk(blind(scene), 5000, [&](const PhotonPath& path) {
        if (path.steps.size() != 3) return;
        ++through;
        const DVec3 left = DVec3(path.steps.back().power) / DVec3(path.emitted.power);
        EXPECT_NEAR(left.r, std::exp(-0.2), 1e-5);
        EXPECT_NEAR(left.g, std::exp(-0.7), 1e-5);
        EXPECT_NEAR(left.b, std::exp(-1.5), 1e-5);
    });
    EXPECT_GT(through, 100);
}

TEST(PhotonNumbers, AreFineEnoughAndEvenlySpread) {
    double sum = 0, square = 0;
    for (std::uint64_t photon = 0; photon < 20000; ++photon) {
        const PhotonNumbers numbers(1, photon);
        const double u = numbers(3);
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u;
        square += u * u;
        EXPECT_NE(numbers(3), numbers(4));
    }
    EXPECT_NEAR(sum / 20000, 0.5, 0.01);
    EXPECT_NEAR(square / 20000, 1.0 / 3, 0.01);
}

}
}
