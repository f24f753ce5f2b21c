// labels: unit
// Eye rays: the lectures' image plane, exact symmetry, and the silhouettes of balls (stability 2.8).

#include <gtest/gtest.h>

#include "core/transport/trace_context.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

Camera cameraOfFov(double degrees) {
    Camera camera;
    camera.verticalFov = radians(degrees);
    return camera;
}

/// Where the ray meets the image plane z = −1.
Vec2 onImagePlane(const Ray& ray) { return Vec2(ray.direction) / -ray.direction.z; }

TEST(EyeRays, CornersAreThoseOfTheLecture) {
    const EyeRays rays(cameraOfFov(60), DVec3(0), 640, 480);
    const Vec2 topLeft = onImagePlane(rays.through(0, 0, Vec2(0)));
    const Vec2 bottomRight = onImagePlane(rays.through(639, 479, Vec2(1)));
    EXPECT_NEAR(topLeft.x, -0.769800359, 1e-6);
    EXPECT_NEAR(topLeft.y, 0.577350269, 1e-6);
    EXPECT_NEAR(bottomRight.x, 0.769800359, 1e-6);
    EXPECT_NEAR(bottomRight.y, -0.577350269, 1e-6);
}

TEST(EyeRays, PixelCentresFollowTheFormula) {
    constexpr int kWidth = 37, kHeight = 23;
    const EyeRays rays(cameraOfFov(50), DVec3(0), kWidth, kHeight);
    const double tangent = std::tan(radians(25));
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Ray ray = rays.through(x, y, Vec2(0.5F));
            const Vec2 p = onImagePlane(ray);
            EXPECT_NEAR(p.x, tangent * (2.0 * x + 1 - kWidth) / kHeight, 1e-6);
            EXPECT_NEAR(p.y, tangent * (kHeight - 1 - 2.0 * y) / kHeight, 1e-6);
            EXPECT_NEAR(glm::length(ray.direction), 1, 1e-6);
        }
}

TEST(EyeRays, MirroredPixelsHaveMirroredRaysBitForBit) {
    for (const auto& [width, height] : {std::pair{640, 480}, {641, 479}, {3, 1000}}) {
        const EyeRays rays(cameraOfFov(60), DVec3(0), width, height);
        for (int y = 0; y < height; y += 7)
            for (int x = 0; x < width; ++x) {
                const Vec3 d = rays.through(x, y, Vec2(0.5F)).direction;
                const Vec3 across = rays.through(width - 1 - x, y, Vec2(0.5F)).direction;
                const Vec3 below = rays.through(x, height - 1 - y, Vec2(0.5F)).direction;
                ASSERT_EQ(across, Vec3(-d.x, d.y, d.z));
                ASSERT_EQ(below, Vec3(d.x, -d.y, d.z));
            }
    }
}

TEST(EyeRays, FollowTheCamera) {
    Camera camera = cameraOfFov(90);
    camera.eye = DVec3(10, 5, 3);
    camera.target = DVec3(14, 5, 3); // along +x, so +z is right
    const DVec3 origin(10, 0, 0);
    const EyeRays rays(camera, origin, 100, 100);
    const Ray centre = rays.through(50, 50, Vec2(0)), topLeft = rays.through(0, 0, Vec2(0));
    EXPECT_EQ(centre.origin, Vec3(0, 5, 3)) << "relative to the World's origin";
    EXPECT_NEAR(glm::length(centre.direction - Vec3(1, 0, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::length(topLeft.direction * std::sqrt(3.0F) - Vec3(1, 1, -1)), 0, 1e-6);
}

/// Area in pixels of a unit sphere's silhouette at 512² and fov 45°, by 4 × 4 rays a pixel, and its extent in
/// x.
struct Silhouette {
    double area = 0, left = 1e9, right = -1e9;
};
Silhouette silhouetteOf(const Vec3& center) {
    constexpr int kSide = 512, kGrid = 4;
    const EyeRays rays(cameraOfFov(45), DVec3(0), kSide, kSide);
    Silhouette result;
    for (int y = 0; y < kSide * kGrid; ++y)
        for (int x = 0; x < kSide * kGrid; ++x) {
            const Vec2 inPixel = (Vec2(x % kGrid, y % kGrid) + 0.5F) / static_cast<float>(kGrid);
            Ray ray = rays.through(x / kGrid, y / kGrid, inPixel);
            ray.origin -= center;
            if (!intersect(Sphere{1}, ray)) continue;
            result.area += 1.0 / (kGrid * kGrid);
            const double column = (x + 0.5) / kGrid;
            result.left = std::fmin(result.left, column);
            result.right = std::fmax(result.right, column);
        }
    return result;
}

TEST(EyeRays, SilhouetteOfABallHasItsTrueSize) {
    const Silhouette ball = silhouetteOf({0, 0, -5});
    EXPECT_NEAR(ball.area, 49'999.9917, 10);
    EXPECT_NEAR((ball.right - ball.left) / 2, 126.156616, 0.25);
    EXPECT_NEAR((ball.right + ball.left) / 2, 256, 1e-9);
    EXPECT_NEAR(silhouetteOf({0, 0, -10}).area, 12'121.2101, 5);
}

TEST(EyeRays, SilhouetteOfABallOffTheAxisIsAnEllipse) {
    const Silhouette ball = silhouetteOf({1, 0, -6});
    EXPECT_NEAR(ball.area, 34'772.055, 10);
    EXPECT_NEAR((ball.right - ball.left) / 2, 105.949487, 0.25);
    EXPECT_NEAR((ball.right + ball.left) / 2 - 256, 105.949487, 0.25);
}

TEST(EyeRays, FromALensMeetWhereItIsInFocus) {
    Camera camera;
    camera.target = {0, 0, -5};
    camera.lensRadius = 0.1;
    const EyeRays rays(camera, DVec3(0), 64, 48);
    const Ray through = rays.through(50, 7, {0.25F, 0.75F});
    const Vec3 sharp = through.direction * (-5 / through.direction.z);
    DVec3 sum(0);
    double distances = 0;
    constexpr int n = 64;
    for (int i = 0; i < n * n; ++i) {
        const Ray ray = rays.fromLens(through, (Vec2(i % n, i / n) + 0.5F) / static_cast<float>(n));
        EXPECT_NEAR(glm::length(ray.direction), 1, 1e-6F);
        EXPECT_LE(glm::length(ray.at((-5 - ray.origin.z) / ray.direction.z) - sharp), 1e-5F);
        sum += DVec3(ray.origin);
        distances += glm::length(ray.origin);
    }
    EXPECT_LT(glm::length(sum), 1e-3);
    EXPECT_NEAR(distances / (n * n), 0.1 * 2 / 3, 1e-4) << "uniform over the disc";

    camera.lensRadius = 0;
    EXPECT_EQ(EyeRays(camera, DVec3(0), 64, 48).fromLens(through, Vec2(0.3F)).direction, through.direction);
}

TEST(EyeRays, BlurAPointOutOfFocusToItsCircleOfConfusion) {
    Camera camera; // 512² at 45°: f = 618.04 pixels; lens 0.1, focus 5, point 10: a circle 12.360773 wide
    camera.target = {0, 0, -1};
    camera.lensRadius = 0.1;
    camera.focusDistance = 5;
    const EyeRays rays(camera, DVec3(0), 512, 512);
    const float atRim = 256 + 12.360773F / 2;
    const auto pixel = static_cast<int>(atRim);
    const Ray through = rays.through(pixel, 256, {atRim - static_cast<float>(pixel), 0});
    const Ray ray = rays.fromLens(through, {1, 0}); // from the rim on the right
    EXPECT_LE(glm::length(ray.at((-10 - ray.origin.z) / ray.direction.z) - Vec3(0, 0, -10)), 2e-5F);
}

TEST(EyeRays, AimedAtEdgesMeetEachCornerInSightAndPointsBetween) {
    Scene scene = scenes::underSky(Color(0));
    TriangleMesh triangle;
    triangle.positions = {{-0.51F, -0.4F, 0}, {0.6F, -0.3F, 0.2F}, {0.1F, 0.62F, -0.1F}};
    triangle.triangles = {{0, 1, 2}};
    scenes::add(scene, triangle, scenes::matte(Color(1)));
    scenes::look(scene, {0, 0, 3}, {0, 0, 0}, 40);
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    constexpr int kSide = 60;
    EyeRays rays(scene.cameras.front(), world->origin, kSide, kSide);
    const EyeRays plain = rays;
    rays.aimAtEdges(*world);
    int aimed = 0;
    std::array<int, 3> atCorner{};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Ray ray = rays.through(x, y, Vec2(0.5F)), centre = plain.through(x, y, Vec2(0.5F));
            if (ray.direction == centre.direction) continue;
            ++aimed;
            const double step = 2 * std::tan(radians(20)) / kSide; // no more than a pixel from its centre
            EXPECT_LT(glm::length(ray.direction - centre.direction), step);
            double nearest = 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const DVec3 a(triangle.positions[i] - Vec3(world->origin)),
                    b(triangle.positions[(i + 1) % 3] - Vec3(world->origin)), eye(ray.origin);
                if (ray.direction == glm::normalize(Vec3(a) - ray.origin)) ++atCorner[i];
                const DVec3 d(ray.direction), across = glm::cross(b - a, d);
                nearest = std::min(nearest, std::fabs(glm::dot(a - eye, across)) / glm::length(across));
            }
            EXPECT_LT(nearest, 1e-6) << "it meets the line of an edge";
        }
    EXPECT_GT(aimed, 60);
    for (const int hits : atCorner) EXPECT_EQ(hits, 1);
}

}
}
