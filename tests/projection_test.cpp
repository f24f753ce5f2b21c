// labels: unit
#include <gtest/gtest.h>

#include "app/rayview/arrows.h"
#include "app/rayview/depth_view.h"
#include "app/rayview/image_plane.h"
#include "core/transport/trace_context.h"

namespace eyeray {
namespace {

Camera tilted() {
    Camera camera;
    camera.eye = {1, 2, 5};
    camera.target = {-0.5, 0.25, -1};
    camera.verticalFov = radians(50);
    return camera;
}

Projection projectionOf(const Camera& camera) { return {camera, {0.5, 0, 0}, 320, 200, 0.1, 100}; }

TEST(Projection, PutsAPointOnAPixelsRayAtThatPixelsCentre) {
    const Projection projection = projectionOf(tilted());
    const EyeRays rays(tilted(), {0.5, 0, 0}, 320, 200);
    for (const auto& [x, y] : {std::pair{0, 0}, {319, 199}, {160, 30}, {17, 150}}) {
        const Ray ray = rays.through(x, y, Vec2(0.5F));
        const auto point = projection.point(DVec3(ray.at(7)));
        ASSERT_TRUE(point);
        EXPECT_NEAR(point->at.x, x + 0.5, 1e-3);
        EXPECT_NEAR(point->at.y, y + 0.5, 1e-3);
    }
}

TEST(Projection, AgreesWithItsMatrixAndReadsDepthsBack) {
    const Projection projection = projectionOf(tilted());
    for (const DVec3& p : {DVec3(0, 0, 0), DVec3(-1, 0.5, -3), DVec3(0.2, -0.7, 2)}) {
        const DVec4 clip = projection.clip() * DVec4(p, 1);
        const auto point = projection.point(p);
        ASSERT_TRUE(point);
        EXPECT_NEAR(point->at.x, (clip.x / clip.w * 0.5 + 0.5) * 320, 1e-3);
        EXPECT_NEAR(point->at.y, (0.5 - clip.y / clip.w * 0.5) * 200, 1e-3);
        EXPECT_NEAR(point->depth, clip.w, 1e-5);
        EXPECT_NEAR(projection.distance(static_cast<float>(clip.z / clip.w * 0.5 + 0.5)), clip.w, 1e-3);
    }
}

TEST(Projection, CutsALineAtTheNearPlane) {
    const Projection projection = projectionOf(tilted());
    const DVec3 forward = -projection.axes().backward, eye = projection.eye();
    const DVec3 aside = projection.axes().right;
    const auto line = projection.line(eye - forward + aside, eye + 3.0 * forward + aside);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->from.depth, 0.1, 1e-6);
    EXPECT_NEAR(line->to.depth, 3, 1e-6);
    EXPECT_FALSE(projection.point(eye - forward));
    EXPECT_FALSE(projection.line(eye - forward, eye - 2.0 * forward + aside));
}

TEST(Projection, DepthAlongALineIsThatOfThePointInSpace) {
    const Projection projection = projectionOf(tilted());
    const DVec3 from(-1, 0, 2), to(1, 0.5, -6);
    const auto line = projection.line(from, to);
    ASSERT_TRUE(line);
    for (const double share : {0.1, 0.5, 0.8}) {
        const auto point = projection.point(from + share * (to - from));
        const float onScreen =
            glm::length(point->at - line->from.at) / glm::length(line->to.at - line->from.at);
        EXPECT_NEAR(line->at(onScreen).depth, point->depth, 1e-3);
    }
}

TEST(VisibleParts, ChangeWhereAWallBegins) {
    const Projection projection = projectionOf(tilted());
    // a wall 4 m away over the right half of the picture
    Pixels<float> depth(320, 200, 1.0F);
    const float wall = (100.0F - 0.1F * 100.0F / 4) / (100.0F - 0.1F);
    for (int y = 0; y < 200; ++y)
        for (int x = 160; x < 320; ++x) depth.at(x, y) = wall;
    ASSERT_NEAR(projection.distance(wall), 4, 1e-3);
    const ScreenLine behind{{{20, 100}, 6}, {{300, 100}, 6}}, before{{{20, 100}, 3}, {{300, 100}, 3}};
    const auto parts = visibleParts({projection, depth, 0.01F}, behind);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_FALSE(parts[0].hidden);
    EXPECT_TRUE(parts[1].hidden);
    EXPECT_NEAR(parts[0].to, 0.5, 0.02);
    EXPECT_EQ(parts[0].to, parts[1].from);
    EXPECT_EQ(visibleParts({projection, depth, 0.01F}, before).size(), 1U);
    EXPECT_TRUE(visibleParts({projection, depth, 0.01F}, {{{-50, 20}, 1}, {{-10, 90}, 1}}).empty());
}

TEST(ImagePlane, HasTheCornersOfTheLectures) {
    Camera camera;
    camera.verticalFov = radians(60);
    const ImagePlane plane = imagePlaneOf(camera, DVec3(0), 640.0 / 480, 2);
    EXPECT_EQ(plane.scale, 1);
    EXPECT_NEAR(plane.corners[1].x, 0.7698, 5e-5);
    EXPECT_NEAR(plane.corners[1].y, 0.5774, 5e-5);
    EXPECT_EQ(plane.corners[1].z, -1);
    EXPECT_EQ(plane.cornerText(0), "(−0.77, 0.58, −1)");
    EXPECT_EQ(plane.cornerText(2), "(0.77, −0.58, −1)");
    EXPECT_EQ(plane.point({0, 0}, 640, 480), plane.corners[0]);
    EXPECT_NEAR(glm::length(plane.point({320, 240}, 640, 480) - DVec3(0, 0, -1)), 0, 1e-12);
}

TEST(ImagePlane, ItsGridIsThinnedUntilItsLinesStandApart) {
    EXPECT_EQ(gridStep(100, 900, 7), 1);
    EXPECT_EQ(gridStep(400, 200, 7), 16);
    EXPECT_EQ(gridStep(16, 0, 7), 16);
}

TEST(Arrows, OfTooManyTheWeightiestAndTheSelectedOneStay) {
    std::vector<Arrow> arrows(40);
    for (int i = 0; i < 40; ++i) {
        arrows[static_cast<std::size_t>(i)].ray = i;
        arrows[static_cast<std::size_t>(i)].weight = i < 30 ? 0.5F : 0.1F * static_cast<float>(i - 30);
    }
    const auto kept = weightiest(arrows, 10, 31);
    EXPECT_EQ(kept.size(), 11U);
    for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_LT(kept[i - 1].ray, kept[i].ray);
    EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [](const Arrow& a) { return a.weight > 0.55F; }), 4);
    EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [](const Arrow& a) { return a.ray == 31; }), 1);
    EXPECT_EQ(weightiest(arrows, 40, -1).size(), 40U);
}

}
}
