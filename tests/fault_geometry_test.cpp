// labels: unit
// What each fault of geometry and camera does to a picture, by numbers of stability.md or a closed form.

#include <gtest/gtest.h>

#include "core/scene/generate.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TraceSettings with(Fault fault, TraceSettings settings = casting()) {
    settings.faults.set(fault, true);
    return settings;
}

std::size_t litPixels(const std::vector<Color>& picture) {
    return static_cast<std::size_t>(
        std::count_if(picture.begin(), picture.end(), [](const Color& c) { return !isBlack(c); }));
}

/// A glowing unit ball that fills a third of the picture's width, from afar.
std::size_t pixelsOfBall(double distance, const TraceSettings& settings) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, glowing(Color(1)));
    look(scene, {0, 0, distance}, {0, 0, 0}, degrees(2 * std::atan(3 / distance)));
    return litPixels(Tracing(scene, settings, 200, 200).radiance());
}

TEST(FaultSphereSlide, MakesASquareOfASphereFarAway) {
    constexpr double kTruth = kPiD * 200 * 200 / 36;
    for (const double distance : {10.0, 1e3, 1e4, 1e5})
        EXPECT_NEAR(static_cast<double>(pixelsOfBall(distance, casting())), kTruth, 0.01 * kTruth);
    const TraceSettings slide = with(Fault::SphereSlide);
    EXPECT_NEAR(static_cast<double>(pixelsOfBall(10, slide)), kTruth, 0.01 * kTruth);
    EXPECT_GT(static_cast<double>(pixelsOfBall(1e4, slide)), 3 * kTruth) << "phantom hits all around it";
    TraceSettings inDouble = slide;
    inDouble.precision = Precision::Double;
    EXPECT_NEAR(static_cast<double>(pixelsOfBall(1e4, inDouble)), kTruth, 0.01 * kTruth);
}

/// A ball under a lamp at the eye, which lights all that the eye sees of it.
Scene ballLitFromTheEye(double scale) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{static_cast<float>(2 * scale)}, matte(Color(1)), at(scale * DVec3(3, -2, 10)));
    look(scene, scale * DVec3(3, -2, 17), scale * DVec3(3, -2, 10), 20);
    scene.lights = {taughtLampAt(scale * DVec3(3, -2, 17))};
    return scene;
}

TEST(FaultCentreSampling, LeavesAnEdgeAsItIsHoweverManySamples) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, glowing(Color(0)));
    look(scene, {0, 0, 5}, {0, 0, 0});
    const Tracing wrong(scene, with(Fault::CentreSampling), 32, 32), right(scene, casting(), 32, 32);
    EXPECT_EQ(wrong.radiance(0), right.radiance(0)) << "whose first sample is through the centre too";
    for (int pass = 1; pass < 4; ++pass) {
        EXPECT_EQ(wrong.radiance(pass), wrong.radiance(0));
        EXPECT_NE(right.radiance(pass), right.radiance(0));
    }
}

TEST(FaultGlobalEpsilon, ShadowsTheSurfaceByItselfUnlessTheEpsilonFitsTheScale) {
    const auto darkShare = [](double scale, float epsilon) {
        TraceSettings settings = with(Fault::GlobalEpsilon);
        settings.epsilon = epsilon;
        const Scene scene = ballLitFromTheEye(scale);
        const double all = static_cast<double>(litPixels(Tracing(scene, casting(), 100, 100).radiance()));
        return 1 - static_cast<double>(litPixels(Tracing(scene, settings, 100, 100).radiance())) / all;
    };
    EXPECT_EQ(darkShare(1, 1e-3F), 0);
    EXPECT_GT(darkShare(1, 0), 0.2);
    EXPECT_GT(darkShare(1e4, 1e-3F), 0.2) << "too small for a large scene";
}

TEST(FaultMollerTrumbore, LeaksWhereRaysAreAimedAtVertices) {
    Scene scene = underSky(Color(1));
    add(scene, makeKnot({.triangles = 4000}), matte(Color(0)));
    const auto mesh = scene.meshes[0].triangles;
    const auto leaks = [&](const TraceSettings& settings) {
        const Tracing tracing(scene, settings);
        const Vec3 origin(tracing.world().origin);
        int count = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto v = static_cast<std::size_t>(i) % mesh->positions.size();
            const Vec3 vertex = mesh->positions[v], outside = vertex + 0.05F * mesh->normals[v];
            const Ray ray{outside - origin, vertex - outside, 0, 1.5F};
            const bool hit = tracing.context().textbook
                                 ? closestHit(*tracing.context().textbook, ray).has_value()
                                 : std::visit([&](const auto& g) { return closestHit(g, ray).has_value(); },
                                              *tracing.world().accel);
            count += hit ? 0 : 1;
        }
        return count;
    };
    EXPECT_EQ(leaks(casting()), 0);
    EXPECT_GT(leaks(with(Fault::MollerTrumbore)), 20);
}

TEST(FaultSlabNan, MissesWhatHasAFaceInTheRaysPlane) {
    // The middle column of an odd picture runs in the plane x = 0, where the quad's box ends (stability F12).
    Scene scene = underSky(Color(0));
    TriangleMesh quad;
    quad.positions = {{-1, -1, -5}, {0, -1, -5}, {0, 1, -5}, {-1, 1, -5}};
    quad.triangles = {{0, 1, 2}, {0, 2, 3}};
    add(scene, quad, glowing(Color(1)));
    const auto middle = [&](const TraceSettings& settings) {
        const std::vector<Color> picture = Tracing(scene, settings, 5, 5).radiance();
        return picture[2 * 5 + 2];
    };
    EXPECT_EQ(middle(casting()), Color(1));
    EXPECT_EQ(middle(with(Fault::SlabNan)), Color(0));
}

TEST(FaultFloatWorld, ShakesASceneFarFromTheOrigin) {
    const auto picture = [](double away, const TraceSettings& settings) {
        Scene scene = underSky(Color(0));
        const DVec3 place(away, 0.7 * away, 0.3 * away);
        add(scene, Sphere{1}, glowing(Color(1)), at(place));
        look(scene, place + DVec3(1.3, 0.4, 5.1), place);
        return Tracing(scene, settings, 64, 64).radiance();
    };
    const std::vector<Color> truth = picture(0, casting());
    EXPECT_EQ(picture(1 << 20, casting()), truth) << "floats are relative to the World's origin";
    EXPECT_EQ(picture(0, with(Fault::FloatWorld)), truth);
    const std::vector<Color> shaken = picture(1e7 + 0.3, with(Fault::FloatWorld));
    int wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) wrong += shaken[i] != truth[i] ? 1 : 0;
    EXPECT_GT(wrong, 40) << "a unit in the last place is a metre there";
}

TEST(FaultObjectRayNormalised, HidesAnInstanceBehindWhatIsBehindIt) {
    // Stability F21: a sphere of radius 1 at a tenth of its size, 5 m away: t is 49 in place of 4.9.
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, glowing(Color(1)), at({0, 0, -5}) * glm::scale(DMat4(1), DVec3(0.1)));
    add(scene, Plane{100, 100, true}, glowing(Color(0.25F)),
        at({0, 0, -8}) * glm::rotate(DMat4(1), kPiD / 2, DVec3(1, 0, 0)));
    EXPECT_EQ(Tracing(scene, casting()).pixel(), Color(1));
    EXPECT_EQ(Tracing(scene, with(Fault::ObjectRayNormalised)).pixel(), Color(0.25F));
}

TEST(FaultNormalsByMatrix, TurnsTheNormalOfASquashedSphere) {
    // Stability F22: squashed to a tenth, the normal at 45 degrees is 78.58 degrees off.
    Scene scene = underSky(Color(0));
    const DMat4 squash = glm::scale(DMat4(1), DVec3(1, 1, 0.1));
    add(scene, Sphere{1}, matte(Color(1)), squash);
    const double r = std::sqrt(0.5);
    look(scene, {r, 0, 5}, {r, 0, 0});
    const auto normalOf = [&](const TraceSettings& settings) {
        return DVec3(Tracing(scene, settings).retrace().rays.at(0).hit.normal);
    };
    const double cosine = glm::dot(normalOf(casting()), normalOf(with(Fault::NormalsByMatrix)));
    EXPECT_NEAR(degrees(std::acos(cosine)), 78.58, 0.01);
}

TEST(FaultSolidChecker, FlipsATenthOfTheSquares) {
    Scene scene = underSky(Color(0));
    TaughtMaterial material = matte(Color(0), Color(1));
    material.diffuseTexture.texture = 0;
    scene.textures.push_back({"", CheckerTexture{Color(1), Color(0)}});
    scene.ambient = Color(1);
    add(scene, Plane{}, material, at({0, 1, 0}));
    look(scene, {0.3, 2.7, 0}, {0.1, 0, -3});
    const std::vector<Color> right = Tracing(scene, casting(), 200, 200).radiance();
    const std::vector<Color> wrong = Tracing(scene, with(Fault::SolidChecker), 200, 200).radiance();
    double flips = 0;
    for (std::size_t i = 0; i < right.size(); ++i) flips += right[i] != wrong[i] ? 1 : 0;
    EXPECT_GT(flips / static_cast<double>(right.size()), 0.03);
    EXPECT_LT(flips / static_cast<double>(right.size()), 0.7);
}

TEST(FaultsOfTheCamera, MoveItsRaysAsTheirFormulasSay) {
    const Scene scene = underSky(Color(0));
    constexpr int kWidth = 40, kHeight = 20;
    const auto tangent = [&](const TraceSettings& settings, int x, int y) {
        const Vec3 d = Tracing(scene, settings, kWidth, kHeight).retrace(x, y).rays.at(0).direction;
        return DVec2(d.x / -d.z, d.y / -d.z);
    };
    const double half = std::tan(radians(22.5));
    const DVec2 last = tangent(casting(), kWidth - 1, 0);
    EXPECT_NEAR(last.x, 2 * half * 39 / 40, 1e-6);
    EXPECT_NEAR(last.y, half * 19 / 20, 1e-6);
    EXPECT_NEAR(tangent(with(Fault::HorizontalFov), kWidth - 1, 0).x, half * 39 / 40, 1e-6);
    EXPECT_NEAR(tangent(with(Fault::DegreesAsRadians), kWidth - 1, 0).x, 2 * std::tan(22.5) * 39 / 40, 1e-5);
    EXPECT_NEAR(tangent(with(Fault::CornerSampling), 0, 0).x, -2 * half, 1e-6);
    EXPECT_NEAR(tangent(with(Fault::FlippedRows), kWidth - 1, 0).y, -last.y, 1e-7);
}

TEST(Faults, OfWhichNoneIsOnLeaveTheTextbookIndexUnmade) {
    const Scene scene = ballLitFromTheEye(1);
    EXPECT_EQ(Tracing(scene, casting()).context().textbook, nullptr);
    // A fault that this picture has no use for leaves every bit as it is, though traced by other code.
    const std::vector<Color> plain = Tracing(scene, casting(), 64, 64).radiance();
    EXPECT_EQ(Tracing(scene, with(Fault::EtaNotFlipped), 64, 64).radiance(), plain);
}

}
}
