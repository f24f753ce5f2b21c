// labels: unit
// Texture coordinates of shapes: where they point, and that they are finite and in range everywhere
// (stability F25).

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::place;
using cases::Random;
using cases::ray;

Vec2 at(const Shape& shape, const DVec3& position, std::uint32_t face = 0) {
    SurfacePoint point;
    point.position = Vec3(position);
    return textureCoordinates(shape, point, face);
}

void expectNear(const Vec2& a, double u, double v) {
    EXPECT_NEAR(a.x, u, 1e-6);
    EXPECT_NEAR(a.y, v, 1e-6);
}

void expectInUnitSquare(const Vec2& uv) {
    ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1) << uv.x << " " << uv.y;
}

TEST(TextureCoordinates, OfASphereAreLongitudeAndLatitudeFromTheTop) {
    const Sphere ball{2};
    expectNear(at(ball, {0, 0, 2}), 0.5, 0.5);
    expectNear(at(ball, {2, 0, 0}), 0.75, 0.5); // to the right as seen from the front
    expectNear(at(ball, {-2, 0, 0}), 0.25, 0.5);
    expectNear(at(ball, {0, std::sqrt(2.0), std::sqrt(2.0)}), 0.5, 0.25);
    EXPECT_EQ(at(ball, {0, 2, 0}).y, 0);
    EXPECT_EQ(at(ball, {0, -2, 0}).y, 1);
}

TEST(TextureCoordinates, OfASphereAreInRangeAtPolesAndSeam) {
    Random random(1);
    for (const float radius : {1e-3F, 1.0F, 1e3F})
        for (int i = 0; i < 50'000; ++i) {
            const double polar = std::pow(10, random.uniform(-30, -2)), phi = random.uniform(0, 2 * kPiD);
            const double up = random.below(2) == 0 ? 1 : -1;
            const DVec3 pole(polar * std::cos(phi), up, polar * std::sin(phi));
            const DVec3 seam(up * polar, random.uniform(-1, 1), -1);
            expectInUnitSquare(at(Sphere{radius}, static_cast<double>(radius) * glm::normalize(pole)));
            expectInUnitSquare(at(Sphere{radius}, static_cast<double>(radius) * glm::normalize(seam)));
        }
    expectInUnitSquare(at(Sphere{1}, {-0.0, 0, -1}));
    expectInUnitSquare(at(Sphere{1}, {0, 0, 0}));
}

TEST(TextureCoordinates, OfAPlaneAreItsPlaceInObjectUnits) {
    EXPECT_EQ(at(Plane{}, {3.5, 0, -2}), Vec2(3.5F, -2));
}

TEST(TextureCoordinates, OfABoxStandUprightOnEachFace) {
    const Box box{Vec3(2, 4, 6)};
    expectNear(at(box, {-1, 2, -3}, 0), 0, 0); // as seen from outside: back is left, top is 0
    expectNear(at(box, {1, 2, 3}, 1), 0, 0);
    expectNear(at(box, {-1, -2, 3}, 2), 0, 0);
    expectNear(at(box, {-1, 2, -3}, 3), 0, 0);
    expectNear(at(box, {1, 2, -3}, 4), 0, 0);
    expectNear(at(box, {-1, 2, 3}, 5), 0, 0);
    for (std::uint32_t face = 0; face < 6; ++face) expectNear(at(box, {0, 0, 0}, face), 0.5, 0.5);
    expectNear(at(box, {0.5, -1, 3}, 5), 0.75, 0.75);
    expectInUnitSquare(at(Box{Vec3(0)}, {0, 0, 0}, 5));
}

TEST(TextureCoordinates, OfACylinderAreAngleAndHeightAndASquareOverEachCap) {
    const Cylinder can{2, 1, 1};
    expectNear(at(can, {0, 1, 1}, 0), 0.5, 0);
    expectNear(at(can, {1, -1, 0}, 0), 0.75, 1);
    expectNear(at(can, {0, 1, 0}, 1), 0.5, 0.5);
    expectNear(at(can, {1, 1, 0}, 1), 1, 0.5);
    expectNear(at(can, {0, 1, 1}, 1), 0.5, 1);
    expectNear(at(can, {0, -1, -1}, 2), 0.5, 1);
    expectInUnitSquare(at(Cylinder{2, 0, 1}, {0, 1, 0}, 0));
    expectInUnitSquare(at(Cylinder{2, 0, 1}, {0, 1, 0}, 1));
}

TEST(TextureCoordinates, OfHitsAreInRangeUnderAnyPlacement) {
    Random random(2);
    const std::vector<Shape> shapes = {Sphere{0.5F}, Box{}, Cylinder{1, 0.5F, 0.5F}, Cylinder{1, 0, 0.5F}};
    for (const double size : {1e-3, 1.0, 1e3})
        for (const Shape& shape : shapes) {
            const DMat4 map = cases::randomPlacement(random, size, 0.1, 2);
            const auto scene = indexInstances<Bvh2>({place<Bvh2>(map, shape)}, {});
            for (int i = 0; i < 5000; ++i) {
                const DVec3 target = transformPoint(map, random.inCube(0.5));
                const Ray eye = ray(target + 5 * size * random.direction(), DVec3(0));
                const Ray r = ray(DVec3(eye.origin), target - DVec3(eye.origin));
                if (const auto hit = closestHit(scene, r))
                    expectInUnitSquare(textureCoordinates(scene, surfaceAt(scene, r, *hit), *hit, 0));
            }
        }
}

TEST(TextureCoordinates, OfAMeshAreInterpolatedThroughTheScene) {
    TriangleMesh mesh;
    mesh.positions = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{0, 1, 2}};
    mesh.uvs[2] = {Vec2(0), Vec2(4, 0), Vec2(0, 8)};
    mesh.colors = {Vec4(0, 0, 0, 1), Vec4(1, 0, 0, 1), Vec4(0, 1, 0, 1)};
    const auto scene = cases::geometryOf<Bvh2>(cases::shared(mesh));
    const Ray r = ray({0.5, 0.25, 1}, {0, 0, -1});
    const auto hit = closestHit(scene, r);
    ASSERT_TRUE(hit);
    EXPECT_EQ(textureCoordinates(scene, surfaceAt(scene, r, *hit), *hit, 2), Vec2(2, 2));
    EXPECT_EQ(textureCoordinates(scene, surfaceAt(scene, r, *hit), *hit, 0), Vec2(0));
    EXPECT_EQ(vertexColor(scene, *hit), Vec4(0.5F, 0.25F, 0, 1));
    const auto ball = indexInstances<Bvh2>({place<Bvh2>(DMat4(1), Shape(Sphere{1}))}, {});
    EXPECT_EQ(vertexColor(ball, *closestHit(ball, ray({0, 0, 3}, {0, 0, -1}))), Vec4(1));
}

}
}
