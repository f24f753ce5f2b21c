#pragma once
// Random numbers, meshes and placements for the tests of geometry.

#include <cmath>
#include <memory>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/accel.h"

namespace eyeray::cases {

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    double uniform(double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(engine_()) * 0x1p-32);
    }
    int below(int end) { return static_cast<int>(uniform(0, end)); }
    template <class T>
    const T& oneOf(const std::vector<T>& values) {
        return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
    }
    DVec3 inCube(double half) {
        const double x = uniform(-half, half), y = uniform(-half, half);
        return {x, y, uniform(-half, half)};
    }
    DVec3 direction() {
        const double z = uniform(-1, 1), phi = uniform(0, 2 * kPiD), r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

private:
    std::mt19937 engine_;
};

inline Ray ray(const DVec3& origin, const DVec3& direction) {
    return {.origin = Vec3(origin), .direction = Vec3(direction)};
}

/// Rotation, scale per axis in [least, most] times `size`, translation of the order of `size`.
inline DMat4 randomPlacement(Random& random, double size, double least = 0.3, double most = 1.5) {
    DMat4 map = glm::translate(DMat4(1), 2.0 * random.inCube(size));
    map = glm::rotate(map, random.uniform(0, 2 * kPiD), random.direction());
    const double x = random.uniform(least, most), y = random.uniform(least, most);
    return glm::scale(map, size * DVec3(x, y, random.uniform(least, most)));
}

template <class Index, class Geometry>
Instance<Index> place(const DMat4& objectToWorld, Geometry geometry) {
    return {.placement = Placement(objectToWorld), .geometry = std::move(geometry)};
}

/// A closed mesh around the origin: a sphere, or with `bumps` a star-shaped body. Every edge has two
/// triangles.
inline TriangleMesh closedMesh(int rings, int sectors, double radius, double bumps = 0) {
    TriangleMesh mesh;
    const auto vertex = [&](int ring, int sector) {
        if (ring == 0) return 0U;
        if (ring == rings) return 1U;
        return static_cast<std::uint32_t>(2 + (ring - 1) * sectors + sector % sectors);
    };
    mesh.positions = {Vec3(0, radius, 0), Vec3(0, -radius, 0)};
    for (int ring = 1; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            const double theta = kPiD * ring / rings, phi = 2 * kPiD * sector / sectors;
            const double r = radius * (1 + bumps * std::sin(7 * theta) * std::sin(theta) * std::cos(5 * phi));
            mesh.positions.emplace_back(r * std::sin(theta) * std::sin(phi), r * std::cos(theta),
                                        r * std::sin(theta) * std::cos(phi));
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            const std::uint32_t a = vertex(ring, sector), b = vertex(ring + 1, sector),
                                c = vertex(ring + 1, sector + 1), d = vertex(ring, sector + 1);
            if (ring + 1 < rings) mesh.triangles.push_back({a, b, c});
            if (ring > 0) mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// Triangles of random size and place in a cube.
inline TriangleMesh triangleSoup(Random& random, int count, double half) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const DVec3 center = random.inCube(half);
        const double size = half * random.uniform(0.01, 0.3);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(center + random.inCube(size));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

inline std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh) {
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// One mesh at the origin.
template <class Index>
IndexedGeometry<Index> geometryOf(const std::shared_ptr<const TriangleMesh>& mesh) {
    return indexInstances<Index>({place<Index>(DMat4(1), indexMesh<Index>(mesh, {}))}, {});
}

}
