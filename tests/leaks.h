#pragma once
// Rays made to slip through closed meshes, and rays that leave surfaces: shared by the tests, which send a
// million, and the benchmark, which sends a hundred.

#include <string>

#include "core/base/thread_pool.h"
#include "core/transport/optics.h"
#include "tests/geometry_cases.h"

namespace eyeray::leaks {

/// A closed mesh as a scene may hold it, and where its inside is.
struct ClosedMesh {
    std::string name;
    std::shared_ptr<const TriangleMesh> mesh;
    DMat4 placement{1};
    DVec3 inside{0};
    double spread = 0.3; // origins lie within this of `inside`, per axis
};

inline TriangleMesh mapped(TriangleMesh mesh, const DMat4& map) {
    for (Vec3& p : mesh.positions) p = Vec3(transformPoint(map, DVec3(p)));
    return mesh;
}

/// At the scales and the place that scenes come in, by their vertices and by a node.
inline std::vector<ClosedMesh> closedMeshes() {
    const TriangleMesh ball = cases::closedMesh(120, 160, 1), star = cases::closedMesh(120, 160, 1, 0.3);
    const DVec3 far(148376, 1234, -223423);
    const DMat4 turned = glm::rotate(DMat4(1), 0.7, glm::normalize(DVec3(1, 2, 3)));
    std::vector<ClosedMesh> meshes;
    for (const double scale : {1e-3, 1.0, 1e4}) {
        const DMat4 map = glm::scale(turned, DVec3(scale));
        meshes.push_back({"ball, vertices times " + std::to_string(scale), cases::shared(mapped(ball, map)),
                          DMat4(1), DVec3(0), 0.3 * scale});
        meshes.push_back(
            {"star, node times " + std::to_string(scale), cases::shared(star), map, DVec3(0), 0.3 * scale});
    }
    meshes.push_back({"ball far away, by its vertices",
                      cases::shared(mapped(ball, glm::translate(DMat4(1), far))), DMat4(1), far, 0.3});
    meshes.push_back(
        {"star far away, by its node", cases::shared(star), glm::translate(DMat4(1), far) * turned, far});
    return meshes;
}

/// From inside towards a random vertex, or a random place on a random edge.
inline Ray aimed(cases::Random& random, const ClosedMesh& closed) {
    const TriangleMesh& mesh = *closed.mesh;
    const auto& triangle = random.oneOf(mesh.triangles);
    const auto corner = static_cast<std::size_t>(random.below(3));
    const DVec3 a(mesh.positions[triangle[corner]]), b(mesh.positions[triangle[(corner + 1) % 3]]);
    const double share = random.below(2) == 0 ? 0.0 : random.uniform(0, 1);
    const Vec3 origin(closed.inside + random.inCube(closed.spread));
    return cases::ray(DVec3(origin), transformPoint(closed.placement, a + share * (b - a)) - DVec3(origin));
}

/// How many of `rays` aimed rays get out, by their closest hit or by any.
template <class Index>
int leaksOf(const ClosedMesh& closed, const IndexedGeometry<Index>& geometry, int rays, std::uint32_t seed) {
    const FloatEnvironment environment;
    cases::Random random(seed);
    int count = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = aimed(random, closed);
        const bool held = i % 2 == 0 ? closestHit(geometry, ray).has_value() : anyHit(geometry, ray);
        count += held ? 0 : 1;
    }
    return count;
}

template <class Index>
IndexedGeometry<Index> indexed(const ClosedMesh& closed) {
    return indexInstances<Index>({cases::place<Index>(closed.placement, indexMesh<Index>(closed.mesh, {}))},
                                 {});
}

/// What leaves the surfaces of one object under random placements.
struct Spawned {
    std::int64_t rays = 0, back = 0; // mirrored and refracted ones; those that met their own face at once
    Spawned& operator+=(const Spawned& other) {
        rays += other.rays;
        back += other.back;
        return *this;
    }
};

/// `placed(map)` is an instance of an object about the origin under a map, which gives it `size` up to a
/// factor of a few.
template <class Placed>
Spawned spawnFrom(const Placed& placed, double size, int rays, std::uint32_t seed) {
    const FloatEnvironment environment;
    cases::Random random(seed);
    Spawned result;
    IndexedGeometry<Bvh8> scene;
    DMat4 map(1);
    for (int i = 0; i < rays; ++i) {
        if (i % 500 == 0) {
            map = cases::randomPlacement(random, size, 0.1, 2);
            scene = indexInstances<Bvh8>({placed(map)}, {});
        }
        const DVec3 target = transformPoint(map, random.inCube(0.4));
        const double distance = size * std::pow(10, random.uniform(0.5, 4));
        const Vec3 origin(target + distance * random.direction());
        const Ray ray = cases::ray(DVec3(origin), glm::normalize(target - DVec3(origin)));
        const auto hit = closestHit(scene, ray);
        if (!hit) continue;
        const SurfacePoint point = surfaceAt(scene, ray, *hit);
        const bool front = glm::dot(point.geometricNormal, ray.direction) < 0;
        const Vec3 normal = front ? point.geometricNormal : -point.geometricNormal;
        const auto leave = [&](const Vec3& direction) {
            const auto again = closestHit(scene, {spawnOrigin(point, direction), direction});
            ++result.rays;
            result.back += again && again->primitive == hit->primitive && again->t < 1e-4 * size ? 1 : 0;
        };
        leave(reflected(-ray.direction, normal));
        if (const auto inward = refracted(-ray.direction, normal, 1 / 1.5F)) leave(*inward);
    }
    return result;
}

/// Spheres, boxes, cylinders, cones, planes and a mesh in turn, each placed unevenly, and the mesh by its own
/// vertices as well, at sizes over twelve decades.
inline Spawned spawnAtAllScales(int raysEach, std::uint32_t seed) {
    const std::vector<Shape> shapes = {
        Sphere{0.5F},         Box{Vec3(1, 0.7F, 1.3F)}, Cylinder{1, 0.5F, 0.5F},
        Cylinder{1, 0, 0.7F}, Cylinder{1, 0.3F, 0.7F},  Plane{2, 2, true}};
    const TriangleMesh ball = cases::closedMesh(24, 32, 0.5);
    const auto mesh = indexMesh<Bvh8>(cases::shared(ball), {});
    const auto byNode = [](const auto& object) {
        return [&](const DMat4& map) { return cases::place<Bvh8>(map, object); };
    };
    const auto byVertices = [&](const DMat4& map) {
        return cases::place<Bvh8>(DMat4(1), indexMesh<Bvh8>(cases::shared(mapped(ball, map)), {}));
    };
    Spawned result;
    for (int decade = -6; decade <= 6; ++decade) {
        const double size = std::pow(10, decade);
        for (const Shape& shape : shapes) result += spawnFrom(byNode(shape), size, raysEach, seed++);
        result += spawnFrom(byNode(mesh), size, raysEach, seed++);
        result += spawnFrom(byVertices, size, raysEach, seed++);
    }
    return result;
}

}
