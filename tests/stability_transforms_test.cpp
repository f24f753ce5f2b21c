// labels: unit
// Scenes at any scale and frames around any normal (stability F05, F24).

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 96, kHeight = 72;

/// Shapes, a mesh, glass and a mirror on a floor, under lamps that have a size.
Scene stillLife(double scale) {
    Scene scene = underSky({0.3F, 0.5F, 0.8F});
    add(scene, Plane{}, matte(Color(0.6F)), at({0, -1, 0}));
    add(scene, Sphere{0.7F}, mirror(Color(0.8F)), at({-1.2, -0.3, -1}));
    add(scene, Sphere{0.6F}, glass(1.5F, Color(0.95F), Color(static_cast<float>(0.3 / scale))),
        at({0.3, -0.4, 0.5}));
    add(scene, Box{{0.8F, 0.8F, 0.8F}}, matte({0.8F, 0.3F, 0.2F}), at({1.4, -0.6, -0.6}));
    add(scene, cases::closedMesh(16, 24, 0.5, 0.2), matte({0.2F, 0.7F, 0.3F}), at({0.2, 0.6, -1}));
    scene.lights = {lampAt({-2, 4, 2}, SphereLamp{0.4}, 30), lampAt({2, 4, 1}, RectangleLamp{1, 1}, 20)};
    scene.lights[1].transform *= facing({-0.3, -1, -0.2});
    look(scene, {0.5, 1, 5}, {0, -0.2, 0}, 40);
    return mapped(scene, glm::scale(DMat4(1), DVec3(scale)));
}

TEST(ScaledScene, LooksTheSameFromAThousandthToTenThousandTimesItsSize) {
    const auto here = Tracing(stillLife(1), toDepth(5), kWidth, kHeight).radiance();
    for (const double scale : {1e-3, 1e-2, 0.1, 7.3, 100.0, 1e3, 1e4}) {
        const auto there = Tracing(stillLife(scale), toDepth(5), kWidth, kHeight).radiance();
        int different = 0;
        for (std::size_t i = 0; i < here.size(); ++i)
            different += isNear(here[i], there[i], 1.0F / 255) ? 0 : 1;
        EXPECT_LE(different, 1) << scale << ": at most a pixel at an edge";
    }
}

TEST(Frame, IsOrthonormalAroundAnyDirection) {
    cases::Random random(1);
    const auto expectOrthonormal = [](const Vec3& n) {
        const Frame frame = Frame::around(n);
        const Mat3 m(frame.tangent, frame.bitangent, frame.normal);
        const Mat3 identity = glm::transpose(m) * m;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(identity[i][k], i == k ? 1 : 0, 1e-6);
        ASSERT_GT(glm::determinant(m), 0.9F) << "right-handed";
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0F, -1.0F}) {
            Vec3 n(0);
            n[axis] = sign;
            expectOrthonormal(n);
        }
    for (int i = 0; i < 1'000'000; ++i) {
        expectOrthonormal(Vec3(random.direction()));
        const double small = std::pow(10, random.uniform(-20, -1)); // about the pole where others fail
        const DVec3 nearPole(small * random.uniform(-1, 1), small * random.uniform(-1, 1),
                             random.below(2) == 0 ? 1 : -1);
        expectOrthonormal(Vec3(glm::normalize(nearPole)));
    }
}

}
}
