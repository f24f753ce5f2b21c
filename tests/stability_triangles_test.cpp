// labels: unit
// Triangles that break tracers, in whole pictures: without area, thin as needles, in axis-aligned walls, in
// one plane with others (stability F07, F09, F10, F13, F17).

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;
using cases::Random;

constexpr int kWidth = 64, kHeight = 48;
constexpr std::array kIndices = {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8};

Scene lit(TriangleMesh mesh, const MaterialModel& material) {
    Scene scene = underSky({0.2F, 0.4F, 0.8F});
    add(scene, std::move(mesh), material);
    scene.lights = {taughtLampAt({2, 3, 4})};
    look(scene, {0.3, 0.4, 4}, {0, 0, 0}, 40);
    return scene;
}

TEST(ZeroAreaTriangles, ChangeNoBitOfThePicture) {
    TriangleMesh mesh = cases::closedMesh(12, 16, 1, 0.2);
    const auto clean = Tracing(lit(mesh, mirror(Color(0.5F))), toDepth(3), kWidth, kHeight).radiance();
    Random random(1);
    for (int i = 0; i < 1000; ++i) { // points and lines, in what is looked at and beside it
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const Vec3 a(random.inCube(1.5)), along = i % 2 == 0 ? Vec3(0) : Vec3(0, 0, 0.25F);
        mesh.positions.insert(mesh.positions.end(), {a, a + along, a + 3.0F * along});
        mesh.triangles.push_back({first, first + 1, i % 3 == 0 ? first : first + 2});
    }
    for (const AccelKind index : kIndices)
        EXPECT_EQ(Tracing(lit(mesh, mirror(Color(0.5F))), toDepth(3), kWidth, kHeight, index).radiance(),
                  clean);
}

TEST(Needles, GiveFinitePixelsByEveryIndex) {
    for (const double offset : {0.0, 10.0, 1000.0}) {
        Random random(2);
        TriangleMesh mesh;
        for (int i = 0; i < 2000; ++i) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const DVec3 a = random.inCube(1) + DVec3(offset, 0, 0), along = random.inCube(1);
            const double width = std::pow(10, random.uniform(-7, -3));
            for (const DVec3& p : {a, a + along, a + 0.5 * along + width * random.inCube(1)})
                mesh.positions.emplace_back(p);
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
        Scene scene = lit(mesh, mirror(Color(0.5F)));
        scene.objects[0].transform = at({-offset, 0, 0});
        const TileResult brute = Tracing(scene, toDepth(3), kWidth, kHeight, AccelKind::Brute).tile();
        EXPECT_EQ(brute.counts.invalidSamples, 0U);
        for (const Color& c : brute.radiance) ASSERT_TRUE(isFinite(c));
        for (const AccelKind index : kIndices)
            EXPECT_EQ(Tracing(scene, toDepth(3), kWidth, kHeight, index).radiance(), brute.radiance);
    }
}

// A box without thickness must not be culled: a test with <= loses every ray.
TEST(Wall, OfTwoTrianglesInAnyAxisPlaneIsWhole) {
    for (int axis = 0; axis < 3; ++axis) {
        TriangleMesh wall;
        for (const auto& [u, v] : {std::pair{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}) {
            Vec3 p(0);
            p[(axis + 1) % 3] = static_cast<float>(u);
            p[(axis + 2) % 3] = static_cast<float>(v);
            wall.positions.push_back(p);
        }
        wall.triangles = {{0, 1, 2}, {0, 2, 3}};
        Scene scene = underSky(Color(0));
        add(scene, wall, glowing(Color(1)));
        for (int i = 0; i < 5; ++i)
            add(scene, wall, glowing(Color(1)), at(DVec3(-1 - i))); // so that there is a tree
        DVec3 eye(0.1, 0.2, 0.3);
        eye[axis] = 4;
        look(scene, eye, {0.1, 0.2, 0.3});
        for (const AccelKind index : kIndices)
            for (const Color& c : Tracing(scene, casting(), kWidth, kHeight, index).radiance())
                ASSERT_EQ(c, Color(1)) << axis;
    }
}

// Which of two surfaces in one plane is seen is a matter of rounding; but always the same one.
TEST(CoplanarSurfaces, AreSeenAlikeByEveryIndexAndInEveryRun) {
    const DMat4 turned = glm::rotate(DMat4(1), 0.7, glm::normalize(DVec3(1, 2, 3)));
    TriangleMesh square;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        square.positions.emplace_back(x, y, 0);
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    TriangleMesh other = square;
    for (Vec3& p : other.positions)
        p = Vec3(transformPoint(glm::rotate(DMat4(1), 0.3, DVec3(0, 0, 1)), DVec3(p)));
    Scene scene = underSky(Color(0));
    add(scene, square, glowing({1, 0, 0}), turned);
    add(scene, other, glowing({0, 1, 0}), turned);
    for (int i = 0; i < 5; ++i) add(scene, Sphere{0.1F}, glowing({0, 0, 1}), at({i - 2, 1.2, 0}));
    look(scene, transformPoint(turned, {0.2, 0.1, 3}), {0, 0, 0});
    const auto brute = Tracing(scene, casting(), kWidth, kHeight, AccelKind::Brute).radiance();
    EXPECT_GT(std::ranges::count(brute, Color(1, 0, 0)), 50);
    EXPECT_GT(std::ranges::count(brute, Color(0, 1, 0)), 50);
    for (const AccelKind index : kIndices)
        for (int run = 0; run < 2; ++run)
            EXPECT_EQ(Tracing(scene, casting(), kWidth, kHeight, index).radiance(), brute);
}

}
}
