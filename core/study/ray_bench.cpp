#include "core/study/ray_bench.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/base/errors.h"
#include "core/base/sampling.h"
#include "core/transport/optics.h"

namespace eyeray {
namespace {

constexpr int kBlock = 8, kPart = 4; // pixels a side
constexpr int kPartRays = kPart * kPart;
constexpr std::size_t kBlockRays = 64;
constexpr std::size_t kRaysAtOnce = 16 * kBlockRays; // for a thread

std::vector<Ray> eyeRaysOf(const EyeRays& eyeRays, int side) {
    ENSURE(side > 0 && side % kBlock == 0);
    std::vector<Ray> rays;
    for (int top = 0; top < side; top += kBlock)
        for (int left = 0; left < side; left += kBlock)
            for (int i = 0; i < static_cast<int>(kBlockRays); ++i) {
                const int part = i / kPartRays, x = part % 2 * kPart + i % kPart,
                          y = part / 2 * kPart + i % kPartRays / kPart;
                rays.push_back(eyeRays.through(left + x, top + y, Vec2(0.5F)));
            }
    return rays;
}

Vec3 overSurface(const Vec3& normal, std::uint32_t number) { // cosine distributed
    const std::uint32_t first = hash32(number);
    const float z = 2 * toUnitFloat(first) - 1, angle = 2 * kPi * toUnitFloat(hash32(first));
    const float r = std::sqrt(1 - z * z);
    const Vec3 direction = normal + Vec3(r * std::cos(angle), r * std::sin(angle), z);
    return glm::length(direction) > 1e-3F ? glm::normalize(direction) : normal;
}

std::vector<Vec3> lampsOf(const World& world, const Camera& camera) {
    constexpr float kFar = 8; // radii of the scene
    const Vec3 eye(camera.eye - world.origin);
    std::vector<Vec3> lamps;
    for (const WorldLight& light : world.lights) {
        if (light.followsCamera) continue;
        const bool near = light.kind != WorldLight::Kind::Directional;
        lamps.push_back(near ? light.position : -kFar * world.radius * light.direction);
    }
    if (lamps.empty()) lamps.push_back(eye + Vec3(0, world.radius, 0));
    return lamps;
}

bool found(const auto& geometry, const Ray& ray, bool any) {
    return any ? anyHit(geometry, ray) : closestHit(geometry, ray).has_value();
}

}

double percentile(std::span<const double> ascending, double share) {
    const double rank = std::ceil(share * static_cast<double>(ascending.size()));
    return ascending[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

Series seriesOf(std::vector<double> values) {
    std::ranges::sort(values);
    return {percentile(values, 0.5), 0.5 * (percentile(values, 0.75) - percentile(values, 0.25))};
}

template <class Index>
std::vector<RaySet> raySets(const IndexedGeometry<Index>& geometry, const EyeRays& eyeRays, int side,
                            std::span<const Vec3> lamps) {
    ENSURE(!lamps.empty());
    const FloatEnvironment environment;
    const RaySet eye{RayKind::Eye, false, eyeRaysOf(eyeRays, side)};
    RaySet shadow{RayKind::Shadow, true, {}}, mirror{RayKind::Reflection, false, {}},
        diffuse{RayKind::Diffuse, false, {}};
    std::uint32_t number = 0;
    for (const Ray& ray : eye.rays) {
        const auto hit = closestHit(geometry, ray);
        if (!hit) continue;
        const SurfacePoint point = surfaceAt(geometry, ray, *hit);
        const bool front = glm::dot(point.geometricNormal, ray.direction) < 0;
        const Vec3 normal = front ? point.geometricNormal : -point.geometricNormal;
        const auto leave = [&](const Vec3& direction, float tMax) {
            return Ray{.origin = spawnOrigin(point, direction), .direction = direction, .tMax = tMax};
        };
        const Vec3 toLamp = lamps[number % lamps.size()] - point.position;
        shadow.rays.push_back(leave(glm::normalize(toLamp), glm::length(toLamp)));
        mirror.rays.push_back(leave(reflected(-ray.direction, normal), kInfinity));
        diffuse.rays.push_back(leave(overSurface(normal, number++), kInfinity));
    }
    return {eye, std::move(shadow), std::move(mirror), std::move(diffuse)};
}

template std::vector<RaySet> raySets(const IndexedGeometry<Bvh2>&, const EyeRays&, int,
                                     std::span<const Vec3>);

std::vector<RaySet> raySets(const World& world, const Camera& camera, int side) {
    return std::visit(
        [&](const auto& geometry) {
            return raySets(geometry, EyeRays(camera, world.origin, side, side), side, lampsOf(world, camera));
        },
        *world.accel);
}

std::vector<Ray> thinned(std::span<const Ray> rays, std::size_t count) {
    const std::size_t blocks = (rays.size() + kBlockRays - 1) / kBlockRays;
    const std::size_t wanted = std::clamp<std::size_t>((count + kBlockRays - 1) / kBlockRays, 1, blocks);
    std::vector<Ray> result;
    result.reserve(wanted * kBlockRays);
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t jitter = hash32(static_cast<std::uint32_t>(i)) % blocks; // else all in one column
        const auto block = rays.subspan((i * blocks + jitter) / wanted * kBlockRays);
        const auto part = block.first(std::min(kBlockRays, block.size()));
        result.insert(result.end(), part.begin(), part.end());
    }
    return result;
}

TracedSet trace(const Accel& accel, const RaySet& set, ThreadPool& pool) {
    const std::span<const Ray> rays(set.rays);
    const int parts = static_cast<int>((rays.size() + kRaysAtOnce - 1) / kRaysAtOnce);
    std::atomic<std::size_t> hits = 0;
    const auto start = std::chrono::steady_clock::now();
    std::visit(
        [&](const auto& geometry) {
            pool.forEach(parts, {}, [&](int part) {
                const auto rest = rays.subspan(static_cast<std::size_t>(part) * kRaysAtOnce);
                std::size_t count = 0;
                for (const Ray& ray : rest.first(std::min(kRaysAtOnce, rest.size())))
                    count += found(geometry, ray, set.anyHit) ? 1 : 0;
                hits += count;
            });
        },
        accel);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), hits};
}

TraversalCounts countTraversal(const Accel& accel, const RaySet& set) {
    const FloatEnvironment environment;
    TraversalLog log;
    log.countsOnly = true;
    std::visit(
        [&](const auto& geometry) {
            for (const Ray& ray : set.rays)
                if (set.anyHit)
                    anyHit(geometry, ray, RayMask::All, log);
                else
                    closestHit(geometry, ray, RayMask::All, log);
        },
        accel);
    return log.counts;
}

}
