// labels: unit
// Packets of rays against single rays, with every instruction set: same hits, same bits, however the rays of
// a packet lie.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/packet_test.cpp"
#include <hwy/foreach_target.h>

#include <span>
#include <vector>

#include "core/geometry/bvh8_any_packet.h"
#include "core/geometry/bvh8_packet.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {
namespace {

RayLanes inLanes(std::span<const Ray> rays) {
    Spread3 origin, direction;
    Spread tMin, tMax;
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        origin.set(lane, rays[lane].origin), direction.set(lane, rays[lane].direction);
        tMin.lane[lane] = rays[lane].tMin, tMax.lane[lane] = rays[lane].tMax;
    }
    return {gathered(origin), gathered(direction), gathered(tMin), gathered(tMax)};
}

/// In packets of up to `mostRows` registers. A miss has an infinite t.
std::vector<Hit> hitsOfPackets(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays,
                               std::size_t mostRows) {
    std::vector<Hit> hits;
    while (!rays.empty()) {
        PacketRays packet;
        std::size_t next = 0;
        while (next < rays.size() && packet.count < std::min(mostRows, kMostRows)) {
            const auto row = rays.subspan(next, std::min(kLanes, rays.size() - next));
            packet.add(inLanes(row), bitsOf(hn::FirstN(FloatTag(), row.size())));
            next += row.size();
        }
        const Packet found(geometry, packet, RayMask::All);
        for (std::size_t i = 0; i < next; ++i)
            hits.push_back(HitSpread(found.hits(i / kLanes)).at(i % kLanes));
        rays = rays.subspan(next);
    }
    return hits;
}

/// Whether they hit anything of the mask.
std::vector<bool> anyHitsOfPackets(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays,
                                   RayMask mask) {
    std::vector<bool> hit;
    while (!rays.empty()) {
        const auto row = rays.first(std::min(kLanes, rays.size()));
        const AnyPacket packet(geometry, inLanes(row), hn::FirstN(FloatTag(), row.size()), mask);
        for (std::size_t lane = 0; lane < row.size(); ++lane)
            hit.push_back((packet.open() >> lane & 1U) == 0);
        rays = rays.subspan(row.size());
    }
    return hit;
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

HWY_EXPORT(hitsOfPackets);
HWY_EXPORT(anyHitsOfPackets);

using cases::place;
using cases::Random;
using cases::ray;

using Geometry = IndexedGeometry<Bvh8>;
using Mesh = std::shared_ptr<const IndexedMesh<Bvh8>>;

Mesh indexed(TriangleMesh mesh) { return indexMesh<Bvh8>(cases::shared(std::move(mesh)), {}); }

/// Meshes closed, open, one-sided and twice in the same place; as they are, turned and stretched; and shapes.
Geometry mixedScene(Random& random) {
    TriangleMesh oneSided = cases::closedMesh(9, 11, 0.5);
    oneSided.doubleSided = false;
    TriangleMesh twice = cases::closedMesh(6, 8, 0.4);
    const auto once = twice.triangles;
    twice.triangles.insert(twice.triangles.end(), once.begin(), once.end());
    std::vector<Instance<Bvh8>> instances;
    for (const Mesh& mesh : {indexed(cases::closedMesh(12, 16, 0.5, 0.3)), indexed(oneSided), indexed(twice),
                             indexed(cases::triangleSoup(random, 300, 0.5))}) {
        instances.push_back(place<Bvh8>(glm::translate(DMat4(1), random.inCube(2)), mesh));
        instances.push_back(place<Bvh8>(cases::randomPlacement(random, 1), mesh));
    }
    for (const Shape& shape : {Shape(Sphere{0.5F}), Shape(Box{Vec3(1, 0.5F, 0.7F)}),
                               Shape(Cylinder{1, 0.3F, 0.2F}), Shape(Plane{2, 2, true})})
        instances.push_back(place<Bvh8>(cases::randomPlacement(random, 1), shape));
    for (std::size_t i = 0; i < instances.size(); i += 3) instances[i].mask = RayMask::Transparent;
    return indexInstances<Bvh8>(std::move(instances), {});
}

/// One object, which has no level of instances above it.
Geometry alone(TriangleMesh mesh, const DVec3& at = DVec3(0)) {
    return indexInstances<Bvh8>({place<Bvh8>(glm::translate(DMat4(1), at), indexed(std::move(mesh)))}, {});
}

/// Towards points of a square around `target`, row by row.
std::vector<Ray> square(const Vec3& from, const Vec3& target, float width, float spreadOfOrigins = 0) {
    const Frame frame = Frame::around(glm::normalize(target - from));
    std::vector<Ray> rays;
    for (int y = 0; y < 16; ++y) // 128 rays: eight registers of sixteen
        for (int x = 0; x < 8; ++x) {
            const Vec3 offset = (static_cast<float>(x) / 8 - 0.5F) * frame.tangent +
                                (static_cast<float>(y) / 16 - 0.5F) * frame.bitangent;
            const Vec3 origin = from + spreadOfOrigins * offset;
            rays.push_back({.origin = origin, .direction = glm::normalize(target + width * offset - origin)});
        }
    return rays;
}

/// How many hits there are.
int expectTheHitsOfSingleRays(const Geometry& geometry, std::span<const Ray> rays) {
    int met = 0;
    for (const std::size_t rows : {8U, 5U, 1U}) {
        const std::vector<Hit> hits = HWY_DYNAMIC_DISPATCH(hitsOfPackets)(geometry, rays, rows);
        EXPECT_EQ(hits.size(), rays.size());
        for (std::size_t i = 0; i < rays.size() && !testing::Test::HasFailure(); ++i) {
            const auto one = closestHit(geometry, rays[i]);
            EXPECT_EQ(hits[i].t < kInfinity, one.has_value()) << i;
            if (!one) continue;
            EXPECT_EQ(hits[i].t, one->t) << i;
            EXPECT_EQ(hits[i].u, one->u) << i;
            EXPECT_EQ(hits[i].v, one->v) << i;
            EXPECT_EQ(hits[i].primitive, one->primitive) << i;
            EXPECT_EQ(hits[i].instance, one->instance) << i;
            ++met;
        }
    }
    for (const RayMask mask : {RayMask::All, RayMask::Opaque, RayMask::Transparent}) {
        const std::vector<bool> hit = HWY_DYNAMIC_DISPATCH(anyHitsOfPackets)(geometry, rays, mask);
        for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(hit[i], anyHit(geometry, rays[i], mask)) << i;
    }
    return met;
}

TEST(Packet, FindsTheHitsOfSingleRays) {
    withEachInstructionSet([] {
        Random random(1);
        const Geometry scene = mixedScene(random);
        int met = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec3 from(random.inCube(6)), target(random.inCube(2));
            for (const float width : {0.01F, 0.1F, 0.5F}) {
                met += expectTheHitsOfSingleRays(scene, square(from, target, width));
                met += expectTheHitsOfSingleRays(scene, square(from, target, width, 0.05F));
            }
            if (testing::Test::HasFailure()) FAIL() << "packet " << i;
        }
        EXPECT_GT(met, 50'000);
    });
}

TEST(Packet, FindsThemOfOneMesh) {
    withEachInstructionSet([] {
        Random random(2);
        for (const DVec3& at : {DVec3(0), DVec3(100, -7, 3), DVec3(148376, 1234, -223423)}) {
            const Geometry scene = alone(cases::closedMesh(40, 60, 0.5, 0.3), at);
            int met = 0;
            for (int i = 0; i < 200; ++i) {
                const Vec3 from(at + random.inCube(3)), target(at + random.inCube(1));
                for (const float spreadOfOrigins : {0.0F, 0.02F})
                    met += expectTheHitsOfSingleRays(scene, square(from, target, 0.1F, spreadOfOrigins));
                if (testing::Test::HasFailure()) FAIL() << "packet " << i << " at " << at.x;
            }
            EXPECT_GT(met, 20'000);
        }
    });
}

TEST(Packet, FindsThemAmongTrianglesSmallerThanTheGapsBetweenRays) {
    withEachInstructionSet([] {
        Random random(6);
        const Geometry scene = alone(cases::closedMesh(80, 120, 0.5, 0.3));
        int met = 0;
        for (int i = 0; i < 100; ++i) {
            const Vec3 target(random.inCube(0.5));
            // Half of them with rays that are longest along different axes.
            const Vec3 along =
                i % 2 == 0 ? Vec3(random.inCube(1)) : Vec3(1, -1, 1) + Vec3(random.inCube(0.02));
            for (const float spreadOfOrigins : {0.0F, 0.02F})
                met += expectTheHitsOfSingleRays(
                    scene, square(target + 50.0F * glm::normalize(along), target, 1, spreadOfOrigins));
            if (testing::Test::HasFailure()) FAIL() << "packet " << i;
        }
        EXPECT_GT(met, 10'000);
    });
}

TEST(Packet, FindsThemAtVerticesAndEdgesAndAlongAxes) {
    withEachInstructionSet([] {
        Random random(3);
        const TriangleMesh mesh = cases::closedMesh(8, 12, 0.5, 0.3);
        const Geometry scene = alone(mesh);
        int met = 0;
        for (int i = 0; i < 100; ++i) {
            const Vec3 from = i % 2 == 0 ? Vec3(0, 0, 3) : Vec3(random.inCube(3));
            const std::size_t first =
                static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size())));
            std::vector<Ray> aimed, along;
            for (std::size_t k = 0; k < 64; ++k) {
                const auto& [a, b, c] = mesh.triangles[(first + k / 3) % mesh.triangles.size()];
                const DVec3 p(mesh.positions[k % 3 == 0 ? a : b]), q(mesh.positions[k % 3 == 2 ? c : b]);
                aimed.push_back(ray(DVec3(from), 0.5 * (p + q) - DVec3(from)));
                along.push_back({.origin = mesh.positions[a] + Vec3(0, 0, 2), .direction = Vec3(0, 0, -1)});
            }
            met += expectTheHitsOfSingleRays(scene, aimed);
            met += expectTheHitsOfSingleRays(scene, along);
            if (testing::Test::HasFailure()) FAIL() << "packet " << i;
        }
        EXPECT_GT(met, 10'000);
    });
}

TEST(Packet, FindsThemFromASurfaceAndBetweenLimits) {
    withEachInstructionSet([] {
        Random random(4);
        const Geometry scene = alone(cases::closedMesh(30, 40, 0.5, 0.3));
        int met = 0;
        for (int i = 0; i < 200; ++i) {
            std::vector<Ray> rays = square(Vec3(random.inCube(3)), Vec3(random.inCube(1)), 0.05F);
            for (Ray& r : rays) {
                const auto hit = closestHit(scene, r);
                if (!hit) continue;
                if (i % 2 == 0)
                    r.origin += hit->t * r.direction; // on the surface or near it, on either side
                else
                    r.tMin = hit->t, r.tMax = hit->t * 1.5F;
            }
            met += expectTheHitsOfSingleRays(scene, rays);
            if (testing::Test::HasFailure()) FAIL() << "packet " << i;
        }
        EXPECT_GT(met, 5'000);
    });
}

TEST(Packet, OfFewerRaysThanLanesFindsThem) {
    withEachInstructionSet([] {
        Random random(5);
        const Geometry scene = mixedScene(random);
        int met = 0;
        for (std::size_t count = 1; count <= 64; ++count) {
            const std::vector<Ray> rays = square(Vec3(random.inCube(5)), Vec3(random.inCube(1)), 0.1F);
            met += expectTheHitsOfSingleRays(scene, std::span(rays).first(count));
        }
        EXPECT_GT(met, 500);
    });
}

}
}

#endif
