// labels: unit
// Closed meshes let no ray through, not even one aimed at their edges and vertices (stability F07). Random
// rays find no leak; aimed ones do: the test of Möller and Trumbore in float leaks at one edge ray in ten.

#include <gtest/gtest.h>

#include "core/geometry/accel.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

TriangleMesh mapped(TriangleMesh mesh, const DMat4& map) {
    for (Vec3& p : mesh.positions) p = Vec3(transformPoint(map, DVec3(p)));
    return mesh;
}

DVec3 onRandomEdge(Random& random, const TriangleMesh& mesh) {
    const auto& triangle = random.oneOf(mesh.triangles);
    const auto corner = static_cast<std::size_t>(random.below(3));
    const DVec3 a(mesh.positions[triangle[corner]]), b(mesh.positions[triangle[(corner + 1) % 3]]);
    return a + random.uniform(0, 1) * (b - a);
}

DVec3 onRandomVertex(Random& random, const TriangleMesh& mesh) { return DVec3(random.oneOf(mesh.positions)); }

/// How many of `rays` rays from around `center` to the target, all inside a closed mesh, get out.
template <class Target>
int leaks(const TriangleMesh& mesh, const DVec3& center, double spread, int rays, Target&& target) {
    const auto binary = cases::geometryOf<Bvh2>(cases::shared(mesh));
    const auto wide = cases::geometryOf<Bvh8>(cases::shared(mesh));
    Random random(7);
    int count = 0;
    for (int i = 0; i < rays; ++i) {
        const DVec3 origin(Vec3(center + random.inCube(spread)));
        const Ray r = ray(origin, target(random, mesh) - origin);
        const bool held =
            closestHit(binary, r) && anyHit(binary, r) && closestHit(wide, r) && anyHit(wide, r);
        if (!held) ++count;
    }
    return count;
}

DVec3 onRandomEdgeOrVertex(Random& random, const TriangleMesh& mesh) {
    return random.below(2) == 0 ? onRandomEdge(random, mesh) : onRandomVertex(random, mesh);
}

const TriangleMesh kSphere = cases::closedMesh(120, 120, 1);

TEST(ClosedMesh, HoldsRaysAimedAtItsEdgesAndVertices) {
    EXPECT_EQ(leaks(kSphere, DVec3(0), 0.3, 100'000, onRandomEdgeOrVertex), 0);
}

TEST(ClosedMesh, HoldsThemRotated) {
    const DMat4 turned = glm::rotate(DMat4(1), 0.7, glm::normalize(DVec3(1, 2, 3)));
    EXPECT_EQ(leaks(mapped(kSphere, turned), DVec3(0), 0.3, 100'000, onRandomEdgeOrVertex), 0);
}

TEST(ClosedMesh, HoldsThemShifted) {
    const DVec3 far(1000, -300, 77);
    EXPECT_EQ(leaks(mapped(kSphere, glm::translate(DMat4(1), far)), far, 0.3, 100'000, onRandomEdgeOrVertex),
              0);
}

TEST(ClosedMesh, HoldsThemAtSmallAndLargeScale) {
    for (const double scale : {1e-3, 1e3}) {
        const TriangleMesh scaled = mapped(kSphere, glm::scale(DMat4(1), DVec3(scale)));
        EXPECT_EQ(leaks(scaled, DVec3(0), 0.3 * scale, 50'000, onRandomEdgeOrVertex), 0);
    }
}

TEST(ClosedMesh, HoldsThemFromOutside) {
    const auto geometry = cases::geometryOf<Bvh2>(cases::shared(kSphere));
    Random random(8);
    for (int i = 0; i < 100'000; ++i) {
        const DVec3 target = onRandomEdgeOrVertex(random, kSphere);
        const DVec3 origin(Vec3(target + random.uniform(1, 1000) * (target + 0.3 * random.direction())));
        const auto hit = closestHit(geometry, ray(origin, target - origin));
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->t, 1, 1e-2) << "the near side, not the far one";
    }
}

// Rounding of a far vertex moves an edge sideways: the triangle it moves into must not be culled by its box.
TEST(ClosedMesh, HoldsRaysAtLongThinTrianglesNearTheirMiddle) {
    constexpr int kFacets = 64;
    TriangleMesh tube;
    for (int i = 0; i < kFacets; ++i) {
        const double phi = 2 * kPiD * i / kFacets;
        for (const double end : {-1000.0, 1000.0})
            tube.positions.emplace_back(std::cos(phi), end, std::sin(phi));
    }
    for (std::uint32_t i = 0; i < kFacets; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kFacets);
        tube.triangles.push_back({a, b, b + 1});
        tube.triangles.push_back({a, b + 1, a + 1});
    }
    for (const double tilt : {0.0, 0.3, 1.1}) {
        const DMat4 map = glm::rotate(DMat4(1), tilt, glm::normalize(DVec3(1, 0.2, 0.5)));
        const auto nearTheMiddle = [](Random& random, const TriangleMesh& mesh) {
            const auto i = 2 * static_cast<std::size_t>(random.below(kFacets));
            const double share = random.uniform(0.48, 0.52);
            return (1 - share) * DVec3(mesh.positions[i]) + share * DVec3(mesh.positions[i + 1]);
        };
        EXPECT_EQ(leaks(mapped(tube, map), DVec3(0), 0.4, 60'000, nearTheMiddle), 0) << tilt;
    }
}

// A picture whose pixel centres lie exactly on the vertices of a grid: all of 65,536 pixels see it.
TEST(GridMesh, IsSeenByEveryPixelAimedAtItsVertices) {
    constexpr int kSize = 258;
    TriangleMesh grid;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) grid.positions.emplace_back((x - 128.5) / 64, (y - 128.5) / 64, 0);
    for (std::uint32_t y = 0; y + 1 < kSize; ++y)
        for (std::uint32_t x = 0; x + 1 < kSize; ++x) {
            const std::uint32_t a = y * kSize + x;
            grid.triangles.push_back({a, a + 1, a + kSize + 1});
            grid.triangles.push_back({a, a + kSize + 1, a + kSize});
        }
    const DMat4 turned = glm::rotate(DMat4(1), 0.9, glm::normalize(DVec3(3, 1, 2)));
    for (const DMat4& map : {DMat4(1), turned, glm::translate(DMat4(1), DVec3(5000, 10, -3000)) * turned}) {
        const TriangleMesh mesh = mapped(grid, map);
        const auto geometry = cases::geometryOf<Bvh2>(cases::shared(mesh));
        const DVec3 eye(Vec3(transformPoint(map, DVec3(0.1, 0.2, 4))));
        int missed = 0;
        for (std::size_t y = 1; y + 1 < kSize; ++y)
            for (std::size_t x = 1; x + 1 < kSize; ++x)
                if (!closestHit(geometry, ray(eye, DVec3(mesh.positions[y * kSize + x]) - eye))) ++missed;
        EXPECT_EQ(missed, 0);
    }
}

}
}
