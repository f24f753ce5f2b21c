// labels: unit
#include "core/scene/camera.h"

#include <gtest/gtest.h>

namespace eyeray {
namespace {

void expectNear(const DVec3& a, const DVec3& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

void expectOrthonormal(const CameraAxes& axes) {
    EXPECT_NEAR(glm::length(axes.right), 1, 1e-12);
    EXPECT_NEAR(glm::length(axes.up), 1, 1e-12);
    EXPECT_NEAR(glm::length(axes.backward), 1, 1e-12);
    EXPECT_NEAR(glm::dot(axes.right, axes.up), 0, 1e-12);
    EXPECT_NEAR(glm::dot(axes.up, axes.backward), 0, 1e-12);
    expectNear(glm::cross(axes.right, axes.up), axes.backward, 1e-12);
}

Camera lookingAt(const DVec3& eye, const DVec3& target, const DVec3& up = {0, 1, 0}) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.up = up;
    return camera;
}

TEST(Camera, ImagePlaneOf60DegreesAnd640x480HasTheCornersOfTheLecture) {
    const DVec2 half = imagePlaneHalfExtents(radians(60), 640.0 / 480.0);
    EXPECT_NEAR(half.x, 0.7698, 5e-5);
    EXPECT_NEAR(half.y, 0.5774, 5e-5);
    EXPECT_NEAR(half.y, 1 / std::sqrt(3.0), 1e-15);
}

TEST(Camera, AxesOfTheDefaultCameraAreTheWorldAxes) {
    const CameraAxes axes = axesOf(Camera{});
    expectNear(axes.right, {1, 0, 0}, 0);
    expectNear(axes.up, {0, 1, 0}, 0);
    expectNear(axes.backward, {0, 0, 1}, 0);
}

TEST(Camera, AxesAreOrthonormalWhereverItLooks) {
    for (const DVec3& up : {DVec3(0, 1, 0), DVec3(0, 0, 0), DVec3(3, 1e-9, -2), DVec3(0, 0, -1)})
        for (const DVec3& view : {DVec3(0, -1, 0), DVec3(0, 1, 0), DVec3(1e-9, -1, 0), DVec3(1, 2, 3),
                                  DVec3(0, 0, 0), DVec3(1e200, 0, 0), DVec3(0, 0, 1e-200)})
            expectOrthonormal(axesOf(lookingAt({0, 0, 0}, view, up)));
}

TEST(Camera, LookingStraightDownTheTopOfThePictureIsWhereItFacedBefore) {
    expectNear(axesOf(lookingAt({0, 5, 0}, {0, 0, 0})).up, {0, 0, -1}, 1e-12);
    expectNear(axesOf(lookingAt({0, 5, 0}, {0, 0, 0})).right, {1, 0, 0}, 1e-12);
    expectNear(axesOf(lookingAt({0, -5, 0}, {0, 0, 0})).right, {1, 0, 0}, 1e-12);
}

TEST(Camera, OrbitOfAQuarterTurnGoesFromTheFrontToTheRightSide) {
    const Camera turned = orbited(lookingAt({1, 2, 8}, {1, 2, 3}), kPiD / 2, 0);
    expectNear(turned.eye, {6, 2, 3}, 1e-12);
    expectNear(turned.target, {1, 2, 3}, 0);
}

TEST(Camera, OrbitUpwardsRaisesTheEyeAndStopsShortOfThePole) {
    const Camera start = lookingAt({0, 0, 5}, {0, 0, 0});
    expectNear(orbited(start, 0, kPiD / 4).eye, {0, 5 / std::sqrt(2.0), 5 / std::sqrt(2.0)}, 1e-12);
    const Camera top = orbited(start, 0, 100);
    EXPECT_LT(top.eye.y, 5);
    EXPECT_GT(top.eye.y, 4.99);
    expectNear(axesOf(top).right, {1, 0, 0}, 1e-9);
}

TEST(Camera, OrbitKeepsTheDistance) {
    Camera camera = lookingAt({3, 4, 5}, {-1, 0, 2});
    const double distance = camera.distance();
    for (int i = 0; i < 1000; ++i) {
        camera = orbited(camera, 0.37 * i, std::sin(i));
        EXPECT_NEAR(camera.distance(), distance, 1e-11);
    }
}

TEST(Camera, AHundredThousandOrbitsDoNotDrift) {
    const Camera start = lookingAt({0, 0, 5}, {0, 0, 0});
    Camera camera = start;
    constexpr int kSteps = 100'000;
    for (int i = 0; i < kSteps; ++i) camera = orbited(camera, 2 * kPiD / kSteps, 0);
    expectNear(camera.eye, start.eye, 1e-8);
    EXPECT_NEAR(camera.distance(), 5, 1e-9);
    expectOrthonormal(axesOf(camera));
}

TEST(Camera, OrbitFromStraightAboveGoesOnFromWhereThePictureFaced) {
    const Camera above = lookingAt({0, 5, 0}, {0, 0, 0}, {1, 0, 0}); // +x is up in the picture
    const Camera lower = orbited(above, 0, -kPiD / 4);
    EXPECT_LT(lower.eye.x, -3); // so the eye comes down on the −x side
    EXPECT_NEAR(lower.eye.z, 0, 1e-9);
}

TEST(Camera, MoveIsAlongItsOwnAxes) {
    const Camera camera = moved(lookingAt({0, 0, 0}, {2, 0, 0}), {1, 2, 3});
    expectNear(camera.eye, {3, 2, 1}, 1e-12);
    expectNear(camera.target, {5, 2, 1}, 1e-12);
}

TEST(Camera, DollyMultipliesTheDistanceToTheTarget) {
    const Camera camera = dollied(lookingAt({1, 0, 5}, {1, 0, 1}), 0.25);
    expectNear(camera.eye, {1, 0, 2}, 1e-12);
    expectNear(camera.target, {1, 0, 1}, 0);
}

TEST(Camera, TurnKeepsTheEyeAndTheDistanceAndLooksUpForPositivePitch) {
    const Camera start = lookingAt({1, 2, 3}, {1, 2, -1});
    const Camera up = turned(start, 0, kPiD / 6);
    expectNear(up.eye, start.eye, 0);
    EXPECT_NEAR(up.distance(), start.distance(), 1e-12);
    EXPECT_NEAR(up.target.y, 2 + 4 * std::sin(kPiD / 6), 1e-12);
    const Camera left = turned(start, kPiD / 2, 0);
    expectNear(left.target, {-3, 2, 3}, 1e-12);
}

}
}
