// labels: unit
// Surfaces of meshes for several hits at once against one after the other, with every instruction set: same
// bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/mesh_lanes_test.cpp"
#include <hwy/foreach_target.h>

#include <span>
#include <vector>

#include "core/geometry/accel_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {
namespace {

/// As surfaceAt of each ray and its hit, all of the same instance.
std::vector<SurfacePoint> surfacesInLanes(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays,
                                          std::span<const Hit> hits) {
    std::vector<SurfacePoint> points;
    for (std::size_t first = 0; first < rays.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, rays.size() - first);
        Spread3 origin, direction;
        HitSpread lanes{HitLanes{}};
        for (std::size_t lane = 0; lane < count; ++lane) {
            origin.set(lane, rays[first + lane].origin), direction.set(lane, rays[first + lane].direction);
            lanes.set(lane, hits[first + lane]);
        }
        const RayLanes row{gathered(origin), gathered(direction), all(0.0F), all(kInfinity)};
        const SurfaceSpread found(surfacesAt(geometry, row, lanes.gathered(), hn::FirstN(FloatTag(), count)));
        for (std::size_t lane = 0; lane < count; ++lane)
            points.push_back({.position = found.position.at(lane),
                              .error = found.error.at(lane),
                              .geometricNormal = found.geometricNormal.at(lane),
                              .shadingNormal = found.shadingNormal.at(lane),
                              .lift = found.lift.at(lane)});
    }
    return points;
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include "tests/geometry_cases.h"
#include "tests/instruction_sets.h"

namespace eyeray {
namespace {

HWY_EXPORT(surfacesInLanes);

using cases::Random;

/// Unit normals that lean away from the faces' by up to `lean`, some of them to the other side.
void addNormals(Random& random, TriangleMesh& mesh, double lean) {
    for (const Vec3& position : mesh.positions)
        mesh.normals.emplace_back(safeNormalize(safeNormalize(DVec3(position)) + random.inCube(lean)));
}

/// Somewhere on its triangles, also on edges and corners, seen from both sides.
void expectSurfacesOfSingleHits(Random& random, const TriangleMesh& mesh, const DMat4& objectToWorld) {
    const auto indexed = indexMesh<Bvh8>(cases::shared(mesh), {});
    const auto geometry = indexInstances<Bvh8>({cases::place<Bvh8>(objectToWorld, indexed)}, {});
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    for (int i = 0; i < 203; ++i) {
        const double u = random.below(4) == 0 ? 0 : random.uniform(0, 1);
        const double v = random.below(4) == 0 ? 0 : random.uniform(0, 1 - u);
        rays.push_back(cases::ray(random.inCube(3), random.direction()));
        hits.push_back(
            {.t = 1,
             .u = static_cast<float>(u),
             .v = static_cast<float>(v),
             .primitive = static_cast<std::uint32_t>(random.below(static_cast<int>(mesh.triangles.size())))});
    }
    const std::vector<SurfacePoint> found = HWY_DYNAMIC_DISPATCH(surfacesInLanes)(geometry, rays, hits);
    ASSERT_EQ(found.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SurfacePoint one = surfaceAt(geometry, rays[i], hits[i]);
        ASSERT_EQ(found[i].position, one.position) << i;
        ASSERT_EQ(found[i].error, one.error) << i;
        ASSERT_EQ(found[i].geometricNormal, one.geometricNormal) << i;
        ASSERT_EQ(found[i].shadingNormal, one.shadingNormal) << i;
        ASSERT_EQ(found[i].lift, one.lift) << i;
    }
}

void expectSurfacesOfSingleHits(Random& random, const TriangleMesh& mesh) {
    expectSurfacesOfSingleHits(random, mesh, DMat4(1));
    expectSurfacesOfSingleHits(random, mesh, glm::translate(DMat4(1), random.inCube(5)));
    expectSurfacesOfSingleHits(random, mesh, glm::scale(DMat4(1), DVec3(2, -2, 2)));
    for (int i = 0; i < 4; ++i) expectSurfacesOfSingleHits(random, mesh, cases::randomPlacement(random, 1));
}

TEST(MeshLanes, AreTheSurfacesOfSingleHits) {
    withEachInstructionSet([] {
        Random random(1);
        for (const double size : {1e-6, 0.5, 1e5}) {
            TriangleMesh mesh = cases::closedMesh(12, 16, size, 0.3);
            expectSurfacesOfSingleHits(random, mesh);
            addNormals(random, mesh, 0.4);
            expectSurfacesOfSingleHits(random, mesh);
            addNormals(random, mesh = cases::triangleSoup(random, 100, size), 3);
            expectSurfacesOfSingleHits(random, mesh);
        }
    });
}

TEST(MeshLanes, HaveTheFacesNormalWhereThoseOfTheVerticesCancelOut) {
    withEachInstructionSet([] {
        Random random(2);
        TriangleMesh mesh = cases::closedMesh(6, 8, 0.5);
        addNormals(random, mesh, 0.2);
        for (std::size_t i = 0; i < mesh.normals.size(); i += 2) mesh.normals[i] = Vec3(0);
        expectSurfacesOfSingleHits(random, mesh);
        for (Vec3& normal : mesh.normals) normal = Vec3(0);
        expectSurfacesOfSingleHits(random, mesh);
    });
}

}
}
#endif
