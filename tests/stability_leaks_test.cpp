// labels: unit
// A million rays aimed at the edges and vertices of closed meshes, none of which gets out, and a million that
// leave surfaces, none of which meets its own again (stability F04 to F07). eyeray_leaks_bench sends more.

#include <gtest/gtest.h>

#include "tests/leaks.h"

namespace eyeray {
namespace {

TEST(ClosedMeshes, HoldAMillionAimedRaysAtAnyScaleAndPlace) {
    const auto meshes = leaks::closedMeshes();
    const int rays = 1'000'000 / static_cast<int>(meshes.size());
    for (const auto& closed : meshes) {
        EXPECT_EQ(leaks::leaksOf(closed, leaks::indexed<Bvh8>(closed), rays, 1), 0) << closed.name;
        EXPECT_EQ(leaks::leaksOf(closed, leaks::indexed<Bvh2>(closed), rays / 10, 2), 0) << closed.name;
    }
}

TEST(Surfaces, AreLeftByAMillionRaysOverTwelveDecadesOfScale) {
    const leaks::Spawned spawned = leaks::spawnAtAllScales(9000, 3);
    EXPECT_EQ(spawned.back, 0);
    EXPECT_GT(spawned.rays, 1'000'000);
}

}
}
