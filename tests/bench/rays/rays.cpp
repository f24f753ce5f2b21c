#include "tests/bench/rays/rays.h"

#include <random>

#include "core/scene/generate.h"

namespace eyeray::bench {
namespace {

constexpr int kSide = 512; // pixels

TriangleMesh box() {
    TriangleMesh mesh;
    for (int room = 0; room < 3; ++room) { // one in the other
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const float half = 1.0F - 0.3F * static_cast<float>(room);
        for (int i = 0; i < 8; ++i)
            mesh.positions.emplace_back((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                                        (i & 4) != 0 ? half : -half);
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& [a, b, c, d] : kFaces) {
            mesh.triangles.push_back({first + a, first + b, first + c});
            mesh.triangles.push_back({first + a, first + c, first + d});
        }
    }
    return mesh;
}

TriangleMesh slivers(int count) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto inCube = [&] {
        const float x = uniform(engine), y = uniform(engine), z = uniform(engine);
        return Vec3(x, y, z);
    };
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const Vec3 center = inCube(), along = 0.05F * inCube();
        mesh.positions.insert(mesh.positions.end(),
                              {center - along, center + along, center + 0.001F * inCube()});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

}

std::vector<TestMesh> testMeshes() {
    const auto shared = [](TriangleMesh mesh) {
        return std::make_shared<const TriangleMesh>(std::move(mesh));
    };
    return {{"box, 36", shared(box()), {2.2, 1.6, 2.9}, {0, 0, 0}},
            {"knot, 100,000", shared(makeKnot({.triangles = 100'000})), {0, 2.6, 2.6}, {0, 0, 0}},
            {"terrain, 1,000,000", shared(makeTerrain({.triangles = 1'000'000})), {0, 3.5, 6}, {0, 0, 0}},
            {"slivers, 200,000", shared(slivers(200'000)), {1.8, 1.4, 2.4}, {0, 0, 0}}};
}

std::vector<RaySet> raysFor(const TestMesh& test) {
    const auto scene =
        indexInstances<Bvh2>({{.placement = {}, .geometry = indexMesh<Bvh2>(test.mesh, {})}}, {});
    Camera camera;
    camera.eye = test.eye;
    camera.target = test.target;
    const std::array lamps{Vec3(test.eye + DVec3(3, 5, -2))};
    return raySets(scene, EyeRays(camera, DVec3(0), kSide, kSide), kSide, lamps);
}

}
