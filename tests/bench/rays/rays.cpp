#include "tests/bench/rays/rays.h"

#include <random>

#include "core/scene/generate.h"
#include "core/transport/optics.h"

namespace eyeray::bench {
namespace {

constexpr int kSide = 512; // pixels
constexpr int kBlock = 8;

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

std::vector<Ray> eyeRays(const TestMesh& test) {
    const DVec3 forward = glm::normalize(test.target - test.eye);
    const DVec3 right = glm::normalize(glm::cross(forward, DVec3(0, 1, 0))), up = glm::cross(right, forward);
    const double half = std::tan(radians(22.5));
    std::vector<Ray> rays;
    for (int block = 0; block < kSide * kSide / (kBlock * kBlock); ++block)
        for (int i = 0; i < kBlock * kBlock; ++i) {
            const int x = block % (kSide / kBlock) * kBlock + i % kBlock;
            const int y = block / (kSide / kBlock) * kBlock + i / kBlock;
            const double u = half * (2.0 * x + 1 - kSide) / kSide, v = half * (kSide - 2.0 * y - 1) / kSide;
            rays.push_back(
                {.origin = Vec3(test.eye), .direction = Vec3(glm::normalize(forward + u * right + v * up))});
        }
    return rays;
}

Vec3 overSurface(const Vec3& normal, std::mt19937& engine) { // cosine distributed
    std::uniform_real_distribution<float> uniform(0, 1);
    const float z = 2 * uniform(engine) - 1, angle = 2 * kPi * uniform(engine), r = std::sqrt(1 - z * z);
    const Vec3 direction = normal + Vec3(r * std::cos(angle), r * std::sin(angle), z);
    return glm::length(direction) > 1e-3F ? glm::normalize(direction) : normal;
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

std::vector<RayKindSet> raysFor(const TestMesh& test) {
    const auto scene =
        indexInstances<Bvh2>({{.placement = {}, .geometry = indexMesh<Bvh2>(test.mesh, {})}}, {});
    const Vec3 lamp(test.eye + DVec3(3, 5, -2));
    std::mt19937 engine(2);
    const RayKindSet eye{"eye", false, eyeRays(test)};
    RayKindSet shadow{"shadow", true, {}}, mirror{"mirror", false, {}}, diffuse{"diffuse", false, {}};
    for (const Ray& ray : eye.rays) {
        const auto hit = closestHit(scene, ray);
        if (!hit) continue;
        const SurfacePoint point = surfaceAt(scene, ray, *hit);
        const bool front = glm::dot(point.geometricNormal, ray.direction) < 0;
        const Vec3 normal = front ? point.geometricNormal : -point.geometricNormal;
        const auto leave = [&](const Vec3& direction, float tMax) {
            return Ray{.origin = spawnOrigin(point, direction), .direction = direction, .tMax = tMax};
        };
        const Vec3 toLamp = lamp - point.position;
        shadow.rays.push_back(leave(glm::normalize(toLamp), glm::length(toLamp)));
        mirror.rays.push_back(leave(reflected(-ray.direction, normal), kInfinity));
        diffuse.rays.push_back(leave(overSurface(normal, engine), kInfinity));
    }
    return {eye, shadow, mirror, diffuse};
}

}
