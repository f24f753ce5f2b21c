// labels: unit
#include "core/scene/generate.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace eyeray {
namespace {

DVec3 normalOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const DVec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    return glm::cross(b - a, c - a);
}

void expectFrontsAlongNormals(const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            ASSERT_GT(glm::dot(safeNormalize(normalOf(mesh, triangle)), DVec3(mesh.normals[vertex])), 0.5);
    for (const Vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1, 1e-6);
}

TEST(Terrain, HasTheSizeHeightAndTrianglesAskedFor) {
    const TriangleMesh mesh = makeTerrain({8, 1.5, 5000, 3});
    EXPECT_GE(mesh.triangles.size(), 5000U);
    EXPECT_LT(mesh.triangles.size(), 5500U);
    const Bounds bounds = boundsOf(mesh);
    EXPECT_EQ(bounds.lo, Vec3(-4, 0, -4));
    EXPECT_EQ(bounds.hi, Vec3(4, 1.5F, 4));
    expectFrontsAlongNormals(mesh);
    for (const auto& triangle : mesh.triangles) ASSERT_GT(normalOf(mesh, triangle).y, 0);
}

TEST(Terrain, IsTheSameForTheSameSeedOnly) {
    EXPECT_EQ(makeTerrain({4, 1, 200, 7}).positions, makeTerrain({4, 1, 200, 7}).positions);
    EXPECT_NE(makeTerrain({4, 1, 200, 7}).positions, makeTerrain({4, 1, 200, 8}).positions);
}

TEST(Terrain, ConvergesToOneSurfaceAsItGetsFiner) {
    const TriangleMesh coarse = makeTerrain({1, 0.2, 2LL * 64 * 64, 1}),
                       fine = makeTerrain({1, 0.2, 2LL * 128 * 128, 1});
    double most = 0;
    for (std::size_t row = 0; row <= 64; ++row)
        for (std::size_t column = 0; column <= 64; ++column)
            most =
                std::max(most, std::fabs(static_cast<double>(coarse.positions[row * 65 + column].y -
                                                             fine.positions[2 * row * 129 + 2 * column].y)));
    EXPECT_LT(most, 0.01); // heights are scaled by their own extremes, which differ a little
}

TEST(Knot, IsClosedAndFacesOutwards) {
    const TriangleMesh mesh = makeKnot({2, 3, 1, 0.15, 10'000});
    EXPECT_GE(mesh.triangles.size(), 10'000U);
    expectFrontsAlongNormals(mesh);
    // Every edge, by the positions of its ends, is walked once in each direction.
    const auto key = [](const Vec3& p) { return std::array{p.x, p.y, p.z}; };
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{key(mesh.positions[t[i]]), key(mesh.positions[t[(i + 1) % 3]])}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

TEST(Knot, EnclosesTheVolumeOfItsTube) {
    // Pappus and Guldinus: area of the tube's section times the length of its curve.
    const KnotRule rule{2, 3, 1, 0.1, 200'000};
    const TriangleMesh mesh = makeKnot(rule);
    double volume = 0;
    for (const auto& t : mesh.triangles)
        volume += glm::dot(DVec3(mesh.positions[t[0]]), normalOf(mesh, t)) / 6;
    double length = 0;
    constexpr int kSteps = 100'000;
    const auto pointAt = [](double s) {
        const double reach = 2.0 / 3 + std::cos(3 * s) / 3;
        return DVec3(reach * std::cos(2 * s), std::sin(3 * s) / 3, reach * std::sin(2 * s));
    };
    for (int i = 0; i < kSteps; ++i)
        length += glm::length(pointAt(2 * kPiD * (i + 1) / kSteps) - pointAt(2 * kPiD * i / kSteps));
    EXPECT_NEAR(volume, length * kPiD * 0.01, 0.01 * volume);
}

TEST(Spiral, BallsStandOnTheFloorWithinTheSpreadAndApart) {
    for (const int count : {1, 2, 10, 500}) {
        const auto balls = makeSpiral({count, 10, 5, 42}); // far too large: they are made smaller
        ASSERT_EQ(balls.size(), static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < balls.size(); ++i) {
            EXPECT_EQ(balls[i].center.y, balls[i].radius);
            EXPECT_LE(std::hypot(balls[i].center.x, balls[i].center.z), 5);
            EXPECT_EQ(balls[i].turn, static_cast<int>(i));
            for (std::size_t k = 0; k < i; ++k)
                ASSERT_GT(glm::length(balls[i].center - balls[k].center), balls[i].radius + balls[k].radius)
                    << i << " and " << k << " of " << count;
        }
    }
}

TEST(Spiral, KeepsTheRadiusThatFits) {
    double largest = 0;
    for (const Ball& ball : makeSpiral({1000, 0.05, 5, 1})) largest = std::max(largest, ball.radius);
    EXPECT_LE(largest, 0.05);
    EXPECT_GT(largest, 0.049);
}

TEST(Flake, HasNineBallsOnEachOfTheLevelBefore) {
    const auto balls = makeFlake({0.5, 3});
    EXPECT_EQ(balls.size(), 1U + 9 + 81 + 729);
    EXPECT_EQ(std::count_if(balls.begin(), balls.end(), [](const Ball& b) { return b.turn == 2; }), 81);
    for (std::size_t i = 1; i < balls.size(); ++i) {
        const Ball& parent = balls[(i - 1) / 9]; // children stand in the order of their parents
        ASSERT_NEAR(balls[i].radius, parent.radius / 3, 1e-15);
        ASSERT_NEAR(glm::length(balls[i].center - parent.center), balls[i].radius + parent.radius, 1e-12);
    }
}

TEST(Flake, BallsOfOneParentTouchNoOther) {
    const auto balls = makeFlake({1, 2});
    for (std::size_t i = 1; i < 10; ++i)
        for (std::size_t k = 1; k < i; ++k)
            ASSERT_GE(glm::length(balls[i].center - balls[k].center),
                      balls[i].radius + balls[k].radius - 1e-12);
}

}
}
