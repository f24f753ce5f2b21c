// labels: unit
// Lamps with an extent: irradiances in closed form, and sampling by solid angle against sampling by area.

#include <gtest/gtest.h>

#include "core/transport/emitters.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kGrid = 256;

/// Calls f with the points of a grid in [0, 1)².
template <class F>
void overSquare(const F& f, int n = kGrid) {
    for (int i = 0; i < n * n; ++i) f((Vec2(i % n, i / n) + 0.5F) / static_cast<float>(n));
}

/// Irradiance at the origin with this normal, of an emitter of radiance 1, as the mean of cos / pdfW.
template <class Sampling>
double irradiance(const Sampling& sampling, const Vec3& normal) {
    double sum = 0;
    overSquare([&](const Vec2& u) {
        if (const auto s = sampling(u)) sum += std::max(0.0F, glm::dot(s->wi, normal)) / s->pdfW;
    });
    return sum / (kGrid * kGrid);
}

SphericalEllipsoid sphereAt(const DVec3& center, double radius) {
    DMat4 map(DMat3(1.0) * radius);
    map[3] = DVec4(center, 1);
    return SphericalEllipsoid(map);
}

double sphereIrradiance(double angleDegrees, double radius, double distance) {
    const double a = radians(angleDegrees);
    const auto sphere = sphereAt(distance * DVec3(std::sin(a), std::cos(a), 0), radius);
    return irradiance([&](const Vec2& u) { return sphere.sample(Vec3(0), u); }, {0, 1, 0});
}

TEST(SphericalEllipsoid, LightsAsTheClosedForms) { // stability of form factors: Le = 1, r = 1, d = 2
    EXPECT_NEAR(sphereIrradiance(0, 1, 2), 0.785398163, 1e-4);
    EXPECT_NEAR(sphereIrradiance(60, 1, 2), 0.392699082, 1e-4);
    EXPECT_NEAR(sphereIrradiance(75, 1, 2), 0.2212009, 1e-4);
    EXPECT_NEAR(sphereIrradiance(90, 1, 2), 0.090586074, 1e-4);
    EXPECT_NEAR(sphereIrradiance(0, 0.5, 5), 0.031415927, 1e-5);
    EXPECT_NEAR(sphereIrradiance(0, 1e-4, 5), kPiD * 4e-10, 1e-13);
    EXPECT_NEAR(sphereIrradiance(0, 2, 1), kPiD, 1e-3) << "from inside it is a whole sky";
}

/// Rectangle from `corner`, facing the origin.
SphericalRectangle facingOrigin(const DVec3& corner, const DVec3& edgeX, const DVec3& edgeY) {
    const DVec3 center = corner + 0.5 * (edgeX + edgeY);
    const bool faces = glm::dot(glm::cross(edgeX, edgeY), center) < 0;
    return {center, edgeX, faces ? edgeY : -edgeY};
}

double bySolidAngle(const SphericalRectangle& r, const Vec3& normal) {
    return irradiance([&](const Vec2& u) { return r.sample(Vec3(0), u); }, normal);
}
double byArea(const SphericalRectangle& r, const Vec3& normal) {
    return irradiance([&](const Vec2& u) { return r.sampleByArea(Vec3(0), u); }, normal);
}

TEST(SphericalRectangle, LightsAsTheClosedForms) {
    const Vec3 up(0, 1, 0);
    EXPECT_NEAR(bySolidAngle(facingOrigin({-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}), up), 0.752274688, 1e-5);
    EXPECT_NEAR(bySolidAngle(facingOrigin({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), up), kPiD * 0.138531606, 1e-5);
    EXPECT_NEAR(bySolidAngle(facingOrigin({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), up), kPiD * 0.055734197, 1e-5);
}

TEST(SphericalRectangle, SamplesBySolidAngleAsByArea) {
    const Vec3 normal = glm::normalize(Vec3(0.3F, 1, -0.2F));
    for (const double scale : {1e-3, 0.05, 1.0, 30.0})
        for (const DVec3& corner : {DVec3(-0.2, 1, 0.1), DVec3(2, 0.5, -3), DVec3(-0.9, 0.3, -0.1)}) {
            const auto rectangle =
                facingOrigin(corner, scale * DVec3(1, 0.5, 0), scale * DVec3(-0.2, 0.4, 0.3));
            const double solid = bySolidAngle(rectangle, normal), area = byArea(rectangle, normal);
            EXPECT_NEAR(solid, area, 0.02 * area + 1e-9) << scale;
        }
}

SphericalDisc discAbove(double radius, double height, bool byArea = false) {
    return {{0, height, 0}, {radius, 0, 0}, {0, 0, radius}, byArea};
}

double discIrradiance(const SphericalDisc& disc) {
    return irradiance([&](const Vec2& u) { return disc.sample(Vec3(0), u); }, {0, 1, 0});
}

TEST(SphericalDisc, LightsAsTheClosedForm) { // π R² / (R² + h²)
    for (const double radius : {0.01, 0.5, 1.0, 5.0}) {
        const double exact = kPiD * radius * radius / (radius * radius + 1);
        EXPECT_NEAR(discIrradiance(discAbove(radius, 1)), exact, 2e-3 * exact) << radius;
        EXPECT_NEAR(discIrradiance(discAbove(radius, 1, true)), exact, 2e-3 * exact) << radius;
    }
}

TEST(SphericalDisc, ShinesToItsFrontOnly) {
    const SphericalDisc up({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, false);
    overSquare([&](const Vec2& u) { EXPECT_FALSE(up.sample(Vec3(0), u)); }, 8);
    EXPECT_TRUE(up.sample(Vec3(0, 3, 0), Vec2(0.4F)));
}

TEST(SphericalDisc, DensityIsThatOfTheSamples) {
    for (const double height : {0.1, 1.0, 10.0}) {
        const SphericalDisc disc({0.3, height, 0.2}, {1, 0.1, 0}, {0, 0.2, 0.7}, false);
        overSquare(
            [&](const Vec2& u) {
                const auto s = disc.sample(Vec3(0), u);
                if (!s) return;
                EXPECT_NEAR(disc.pdfW(Vec3(0), s->wi) / s->pdfW, 1, 2e-4);
            },
            16);
    }
}

TEST(SphericalRectangle, OfAnyAnglesIsSampledByItsArea) {
    const auto skewed = facingOrigin({-0.5, 1, -0.5}, {1, 0, 0}, {0.5, 0, 1});
    EXPECT_NEAR(bySolidAngle(skewed, {0, 1, 0}), byArea(skewed, {0, 1, 0}), 1e-9);
}

TEST(SphericalRectangle, ShinesToOneSide) {
    const SphericalRectangle away({0, 1, 0}, {1, 0, 0}, {0, 0, -1});
    EXPECT_FALSE(away.sample(Vec3(0), Vec2(0.5F)));
    EXPECT_TRUE(away.sample(Vec3(0, 2, 0), Vec2(0.5F)));
}

TEST(SkyGradient, IsSampledInProportionToItsLuminance) {
    const Environment sky{{0.2F, 0.5F, 1.2F}, {1, 0.7F, 0.6F}, {0.1F, 0.2F, 0.1F}};
    const SkyGradient gradient(sky);
    constexpr int kBands = 16;
    std::array<double, kBands> drawn{}, expected{};
    overSquare([&](const Vec2& u) {
        const auto s = gradient.sample(u);
        EXPECT_NEAR(glm::length(s.wi), 1, 1e-5F);
        EXPECT_NEAR(s.pdfW, gradient.pdfW(s.wi), 1e-6F);
        drawn[std::min<std::size_t>(kBands - 1, static_cast<std::size_t>((s.wi.y + 1) / 2 * kBands))] += 1;
    });
    double total = 0;
    constexpr int n = 1 << 14;
    for (int i = 0; i < n; ++i) {
        const float y = (static_cast<float>(i) + 0.5F) / n * 2 - 1;
        const double p = gradient.pdfW({std::sqrt(1 - y * y), y, 0}) * 4 * kPiD / n;
        expected[static_cast<std::size_t>(i * kBands / n)] += p;
        total += p;
    }
    EXPECT_NEAR(total, 1, 1e-4);
    for (std::size_t b = 0; b < kBands; ++b) EXPECT_NEAR(drawn[b] / (kGrid * kGrid), expected[b], 0.006) << b;
}

/// A lamp that is turned, stretched and squeezed, and a place that it lights.
Scene oddlyPlaced(const LampShape& shape, const DVec3& scale) {
    Scene scene = underSky(Color(0));
    Light lamp = lampAt({0.5, 2, -1}, shape, 1);
    lamp.transform = lamp.transform * facing({0.2, -1, 0.3}) * glm::scale(DMat4(1), scale);
    scene.lights = {lamp};
    add(scene, Sphere{0.1F}, matte(Color(0)), at({100, 0, 0})); // so that there is something to index
    return scene;
}

TEST(Emitters, AreWhereTheirSurfacesAre) {
    for (const LampShape& shape :
         {LampShape(RectangleLamp{0.7, 0.4}), LampShape(DiscLamp{0.4}), LampShape(SphereLamp{0.5})})
        for (const DVec3& scale : {DVec3(1), DVec3(2, 0.5, 1.3), DVec3(-1, 1, 1)}) {
            const Scene scene = oddlyPlaced(shape, scale);
            const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
            const Emitters emitters(*world, scene.cameras.front(), false);
            const Vec3 from = Vec3(DVec3(0.1, -0.3, 0.2) - world->origin);
            ASSERT_TRUE(emitters.all.at(0).findable);
            int hits = 0;
            overSquare(
                [&](const Vec2& u) {
                    const auto s = sampleEmitter(emitters.all[0], from, 0, u);
                    ASSERT_TRUE(s);
                    EXPECT_NEAR(emitterPdfW(emitters.all[0], from, s->wi), s->pdfW, 1e-4F * s->pdfW);
                    const auto hit =
                        std::visit([&](const auto& geometry) { return closestHit(geometry, {from, s->wi}); },
                                   *world->accel);
                    if (!hit) return; // of a ray along its edge
                    ++hits;
                    EXPECT_EQ(world->objects[hit->instance].sceneLight, 0);
                    EXPECT_NEAR(hit->t, s->distance, 1e-4F);
                },
                32);
            EXPECT_GE(hits, 32 * 32 - 8);
        }
}

TEST(Emitters, StretchedSphereLightsAsFoundByRaysOfAllDirections) {
    const Scene scene = oddlyPlaced(SphereLamp{0.5}, {2, 0.5, 1.3});
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    const Emitters emitters(*world, scene.cameras.front(), false);
    const Vec3 from = Vec3(DVec3(0.1, -0.3, 0.2) - world->origin);
    const Vec3 normal = glm::normalize(Vec3(0.2F, 1, 0.1F));
    const double sampled =
        irradiance([&](const Vec2& u) { return sampleEmitter(emitters.all[0], from, 0, u); }, normal);
    double sum = 0;
    constexpr int n = 1024;
    overSquare(
        [&](const Vec2& u) {
            const float z = 2 * u.x - 1, r = std::sqrt(1 - z * z), turn = 2 * kPi * u.y;
            const Vec3 w(r * std::cos(turn), r * std::sin(turn), z);
            const auto hit = std::visit([&](const auto& geometry) { return closestHit(geometry, {from, w}); },
                                        *world->accel);
            if (hit && world->objects[hit->instance].sceneLight == 0)
                sum += std::max(0.0F, glm::dot(w, normal)) * 4 * kPiD;
        },
        n);
    EXPECT_NEAR(sampled, sum / (static_cast<double>(n) * n), 0.002 * sampled);
}

TEST(Emitters, OfTaughtLampsHaveTheLecturesIrradianceAtAnyDistance) {
    Scene scene = underSky(Color(0));
    Light lamp = lampAt({0, 5, 0}, SphereLamp{0.5}, 1);
    lamp.falloff = false;
    scene.lights = {lamp};
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    const Emitters emitters(*world, scene.cameras.front(), false);
    const auto s = sampleEmitter(emitters.all.at(0), Vec3(DVec3(0, 1, 0) - world->origin), 0, Vec2(0.3F));
    ASSERT_TRUE(s);
    EXPECT_NEAR(s->irradiance.x, kPi, 1e-5F);
    EXPECT_EQ(s->pdfW, 0) << "a ray that finds its surface would not know its irradiance";
}

// ---- Objects that glow

constexpr std::uint32_t kNowhere = 0xffffffff; // on no instance

/// What glows in a scene, seen from the scene's origin.
struct Glow {
    explicit Glow(const Scene& scene)
        : tracing(scene), objects(tracing.world()), from(-tracing.world().origin) {}

    std::optional<Hit> hit(const Vec3& wi) const {
        return std::visit([&](const auto& g) { return closestHit(g, Ray{from, wi}); },
                          *tracing.world().accel);
    }

    Tracing tracing;
    GlowingObjects objects;
    Vec3 from;
};

/// Irradiance of all that glows, and that densities of samples are those of what they hit; but for a few at
/// edges, where they change fast or a neighbour is hit.
double glowIrradiance(const Scene& scene, const Vec3& normal) {
    const Glow glow(scene);
    double sum = 0;
    int unlike = 0;
    overSquare([&](const Vec2& u) {
        const auto s = glow.objects.sample(glow.from, kNowhere, u);
        if (!s) return;
        const auto hit = glow.hit(s->wi);
        if (!hit || std::fabs(hit->t - s->distance) > 1e-5F * s->distance) return;
        const float ofHit = glow.objects.pdfW(*hit, glow.from, kNowhere, s->wi);
        if (!(std::fabs(ofHit / s->pdfW - 1) < 2e-3F)) ++unlike;
        sum += s->radiance.g * std::max(0.0F, glm::dot(s->wi, normal)) / s->pdfW;
    });
    EXPECT_LE(unlike, kGrid * kGrid / 100);
    return sum / (kGrid * kGrid);
}

/// The same of radiance 1 by rays of all directions.
double irradianceByChance(const Scene& scene, const Vec3& normal) {
    const Glow glow(scene);
    double sum = 0;
    constexpr int n = 1024;
    overSquare(
        [&](const Vec2& u) {
            const float z = 2 * u.x - 1, r = std::sqrt(1 - z * z), turn = 2 * kPi * u.y;
            const Vec3 w(r * std::cos(turn), r * std::sin(turn), z);
            if (glow.hit(w)) sum += std::max(0.0F, glm::dot(w, normal)) * 4 * kPiD;
        },
        n);
    return sum / (static_cast<double>(n) * n);
}

TEST(GlowingObjects, LightAsTheClosedForms) {
    const Vec3 up(0, 1, 0);
    TriangleMesh quad;
    quad.positions = {{-0.5F, 0, -0.5F}, {0.5F, 0, -0.5F}, {0.5F, 0, 0.5F}, {-0.5F, 0, 0.5F}};
    quad.triangles = {{0, 1, 2}, {0, 2, 3}};
    quad.doubleSided = false;
    Scene mesh = underSky(Color(0)), plane = mesh, sphere = mesh, box = mesh, away = mesh;
    add(mesh, quad, glowing(Color(1)), at({0, 1, 0}));
    add(away, quad, glowing(Color(1)), at({0, -1, 0})); // its front looks down
    add(plane, Plane{1, 1, true}, glowing(Color(1)), at({0, 1, 0}));
    add(sphere, Sphere{1}, glowing(Color(1)), at({0, 2, 0}));
    add(box, Box{Vec3(1)}, glowing(Color(1)), at({0, 1.5, 0}));
    EXPECT_NEAR(glowIrradiance(mesh, up), 0.752274688, 2e-3);
    EXPECT_NEAR(glowIrradiance(away, -up), 0, 0);
    EXPECT_NEAR(glowIrradiance(plane, up), 0.752274688, 1e-4);
    EXPECT_NEAR(glowIrradiance(sphere, up), 0.785398163, 1e-4);
    EXPECT_NEAR(glowIrradiance(box, up), 0.752274688, 1e-2) << "its lower face alone is seen";
}

Scene oneGlowing(const Shape& shape, const DMat4& place) {
    Scene scene = underSky(Color(0));
    add(scene, shape, glowing(Color(1)), place);
    return scene;
}

/// Irradiance of the side of a cylinder of radius 1 at `distance` from its axis, level with its middle and
/// facing it, by twice the factor of Siegel and Howell's catalogue for a place level with an end.
double cylinderIrradiance(double height, double distance) {
    const double l = height / 2, h = distance;
    const double x = (1 + h) * (1 + h) + l * l, y = (1 - h) * (1 - h) + l * l;
    const double across = std::atan(l / std::sqrt(h * h - 1)) / h;
    const double skew = std::atan(std::sqrt(x * (h - 1) / (y * (h + 1)))) * (x - 2 * h) / std::sqrt(x * y);
    return 2 * (across + l / h * (skew - std::atan(std::sqrt((h - 1) / (h + 1)))));
}

TEST(GlowingObjects, CylinderLightsAsTheClosedForm) {
    for (const double height : {0.1, 2.0, 100.0})
        for (const double distance : {1.1, 2.0, 20.0}) {
            const Scene scene = oneGlowing(Cylinder{static_cast<float>(height), 1, 1}, at({distance, 0, 0}));
            const double exact = cylinderIrradiance(height, distance);
            EXPECT_NEAR(glowIrradiance(scene, {1, 0, 0}), exact, 5e-3 * exact) << height << " " << distance;
        }
}

TEST(GlowingObjects, CapOfACylinderAndRoundPlaneLightAsDiscs) { // π R² / (R² + h²)
    const Vec3 up(0, 1, 0);
    const double exact = kPiD * 0.25 / (0.25 + 1);
    EXPECT_NEAR(glowIrradiance(oneGlowing(Cylinder{1, 0.5F, 0.5F}, at({0, 1.5, 0})), up), exact,
                5e-3 * exact);
    EXPECT_NEAR(glowIrradiance(oneGlowing(Plane{1, 1, true, true}, at({0, 1, 0})), up), exact, 2e-3 * exact);
}

TEST(GlowingObjects, ConesLightAsFoundByRaysOfAllDirections) {
    const DMat4 odd = facing({0.4, -1, 0.3}) * glm::scale(DMat4(1), DVec3(1.5, 0.7, 1));
    const Vec3 normal = glm::normalize(Vec3(0.3F, 1, -0.2F));
    for (const Cylinder& cone : {Cylinder{1, 0.5F, 0.5F}, Cylinder{1, 0, 0.8F}, Cylinder{1.5F, 1, 0.3F}})
        for (const DVec3& center :
             {DVec3(0, 1.4, 0), DVec3(0.9, 0.8, -0.3), DVec3(-2, 1, 3), DVec3(0.1, 0, 0.1)}) {
            const Scene scene = oneGlowing(cone, at(center) * odd);
            const double byChance = irradianceByChance(scene, normal);
            EXPECT_NEAR(glowIrradiance(scene, normal), byChance, 0.005 * byChance + 1e-4)
                << cone.radiusTop << " " << cone.radiusBottom << " at " << center.x << " " << center.y;
        }
}

TEST(GlowingObjects, AreChosenByTheirPower) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, glowing(Color(3)), at({0, 4, 0}));
    add(scene, Sphere{0.5F}, glowing(Color(4)), at({0, -4, 0}));
    const Tracing tracing(scene);
    const GlowingObjects glowing(tracing.world());
    int upper = 0;
    overSquare([&](const Vec2& u) {
        upper += glowing.sample(Vec3(-tracing.world().origin), kNowhere, u)->radiance.g == 3 ? 1 : 0;
    });
    EXPECT_NEAR(upper, 0.75 * kGrid * kGrid, kGrid);
}

TEST(GlowingObjects, AreNoneWhereNothingGlowsEvenly) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, matte(Color(0.5F)));
    add(scene, Plane{}, glowing(Color(1)), at({0, -2, 0}));
    EXPECT_TRUE(GlowingObjects(Tracing(scene).world()).empty());
}

}
}
