#include "core/scene/touching_glass.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/sampling.h"

namespace eyeray {
namespace {

constexpr std::uint32_t kLines = 256;
constexpr int kPairs = 64;
constexpr int kMostHits = 32; // of a line with one solid
constexpr float kReach = 16 * std::numeric_limits<float>::epsilon();
constexpr float kParallel = 0.999F; // cosine between faces that lie in the same place

Bounds common(const Bounds& a, const Bounds& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }

/// More than rounding moves a face, per axis: a turned object mixes the axes' errors.
template <class Index>
Vec3 reachOf(const Instance<Index>& instance) {
    const Bounds box = boundsOf(instance);
    const Vec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    return kReach * (instance.placement.translates() ? farthest : Vec3(maxComponent(farthest)));
}

Vec3 onUnitSphere(std::uint32_t line, std::uint32_t end) {
    const float y = 1 - 2 * toUnitFloat(hashCombine(line, 2 * end));
    const float angle = 2 * kPi * toUnitFloat(hashCombine(line, 2 * end + 1));
    const float radius = std::sqrt(std::max(0.0F, 1 - y * y));
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

/// A line between two random points of a ball's surface: such lines meet any surface in it as often as it has
/// area.
Ray lineThrough(const Bounds& box, std::uint32_t line) {
    const float radius = 0.5F * glm::length(box.extent());
    const Vec3 begin = box.center() + radius * onUnitSphere(line, 0);
    const Vec3 end = box.center() + radius * onUnitSphere(line, 1);
    const float length = glm::length(end - begin);
    return {begin, length > 0 ? (end - begin) / length : Vec3(1, 0, 0), 0, length};
}

/// Whether the faces of two solids lie in the same place somewhere in the box.
template <class Index>
bool touch(const Instance<Index>& one, const Instance<Index>& other, const Bounds& box, const Vec3& reaches) {
    const auto a = indexInstances<Index>({one}, {}), b = indexInstances<Index>({other}, {});
    for (std::uint32_t line = 0; line < kLines; ++line) {
        Ray ray = lineThrough(box, line);
        for (int i = 0; i < kMostHits; ++i) {
            const auto hit = closestHit(a, ray);
            if (!hit) break;
            const SurfacePoint point = surfaceAt(a, ray, *hit);
            const Vec3& normal = point.geometricNormal;
            const float reach = glm::dot(glm::abs(normal), reaches);
            const Ray across{point.position + reach * normal, -normal, 0, 2 * reach};
            if (const auto near = closestHit(b, across)) {
                const Vec3 otherNormal = surfaceAt(b, across, *near).geometricNormal;
                if (std::fabs(glm::dot(normal, otherNormal)) > kParallel) return true;
            }
            ray.tMin = hit->t;
        }
    }
    return false;
}

template <class Index>
void grow(Instance<Index>& instance, const DMat4& toWorld, const Vec3& reaches) {
    const Bounds box = boundsOf(instance);
    const DVec3 center(box.center());
    const DVec3 scale = DVec3(1) + 2.0 * DVec3(reaches) / DVec3(box.extent());
    DMat4 growth = glm::translate(DMat4(1), center);
    growth = glm::translate(glm::scale(growth, scale), -center);
    instance.placement = Placement(growth * toWorld);
}

}

template <class Index>
void joinTouchingGlass(std::vector<Instance<Index>>& instances, const std::vector<GlassSolid>& solids,
                       const std::stop_token& stop) {
    struct Candidate {
        const GlassSolid* solid;
        Bounds box;
    };
    std::vector<Candidate> candidates;
    for (const GlassSolid& solid : solids) {
        const Bounds box = boundsOf(instances[solid.instance]);
        const Vec3 reach = reachOf(instances[solid.instance]);
        const Vec3 extent = box.extent();
        if (box.finite() && extent.x > 0 && extent.y > 0 && extent.z > 0)
            candidates.push_back({&solid, {box.lo - reach, box.hi + reach}});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.box.lo.x, a.solid->instance) < std::pair(b.box.lo.x, b.solid->instance);
    });
    int pairs = 0;
    for (auto a = candidates.begin(); a != candidates.end(); ++a)
        for (auto b = a + 1; b != candidates.end() && b->box.lo.x <= a->box.hi.x; ++b) {
            const Bounds box = common(a->box, b->box);
            if (box.empty()) continue;
            if (++pairs > kPairs || stop.stop_requested()) return;
            Instance<Index>&one = instances[a->solid->instance], &other = instances[b->solid->instance];
            const Vec3 reaches = glm::max(reachOf(one), reachOf(other));
            if (!touch(one, other, box, reaches)) continue;
            const bool first = a->box.halfArea() < b->box.halfArea();
            grow(first ? one : other, (first ? a : b)->solid->toWorld, reaches);
        }
}

template void joinTouchingGlass(std::vector<Instance<BruteForce>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);
template void joinTouchingGlass(std::vector<Instance<Bvh2>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);
template void joinTouchingGlass(std::vector<Instance<Bvh8>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);

}
