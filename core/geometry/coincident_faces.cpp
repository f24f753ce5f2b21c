#include "core/geometry/coincident_faces.h"

#include <algorithm>

#include "core/base/sampling.h"

namespace eyeray {
namespace {

constexpr std::uint32_t kLines = 256;
constexpr int kMostHits = 32; // of a line with one object
constexpr float kReach = 16 * std::numeric_limits<float>::epsilon();
constexpr float kLeastShare = 1.0F / 128;
constexpr float kParallel = 0.999F; // cosine between faces that lie in the same place

Bounds common(const Bounds& a, const Bounds& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }

/// A turned object mixes the axes' errors.
template <class Index>
Vec3 reachOf(const Instance<Index>& instance) {
    const Bounds box = boundsOf(instance);
    const Vec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const float most = maxComponent(farthest);
    const Vec3 least(kLeastShare * most); // a face at 0 is not moved by rounding, but is looked for too
    return kReach * (instance.placement.translates() ? glm::max(farthest, least) : Vec3(most));
}

template <class Index>
Bounds reachedBy(const Instance<Index>& instance) {
    const Bounds box = boundsOf(instance);
    const Vec3 reach = reachOf(instance);
    return {box.lo - reach, box.hi + reach};
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

}

template <class Index>
SharedFaces sharedFaces(const Instance<Index>& one, const Instance<Index>& other) {
    const auto a = indexInstances<Index>({one}, {}), b = indexInstances<Index>({other}, {});
    const Bounds box = common(reachedBy(one), reachedBy(other));
    const Vec3 reaches = roundingReach(one, other);
    SharedFaces found = SharedFaces::None;
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
                const float cosine = glm::dot(normal, surfaceAt(b, across, *near).geometricNormal);
                if (cosine > kParallel) return SharedFaces::Alike;
                if (cosine < -kParallel) found = SharedFaces::Opposed;
            }
            ray.tMin = hit->t;
        }
    }
    return found;
}

template <class Index>
Vec3 roundingReach(const Instance<Index>& a, const Instance<Index>& b) {
    return glm::max(reachOf(a), reachOf(b));
}

template <class Index>
std::vector<std::pair<std::uint32_t, std::uint32_t>>
meetingPairs(const std::vector<Instance<Index>>& instances, std::span<const std::uint32_t> ids,
             std::size_t most) {
    struct Boxed {
        std::uint32_t id;
        Bounds box;
    };
    std::vector<Boxed> boxed;
    for (const std::uint32_t id : ids)
        if (const Bounds box = reachedBy(instances[id]); box.finite() && !box.empty())
            boxed.push_back({id, box});
    std::sort(boxed.begin(), boxed.end(), [](const Boxed& a, const Boxed& b) {
        return std::pair(a.box.lo.x, a.id) < std::pair(b.box.lo.x, b.id);
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (auto a = boxed.begin(); a != boxed.end(); ++a)
        for (auto b = a + 1; b != boxed.end() && b->box.lo.x <= a->box.hi.x; ++b) {
            if (common(a->box, b->box).empty()) continue;
            if (pairs.size() == most) return pairs;
            pairs.emplace_back(std::min(a->id, b->id), std::max(a->id, b->id));
        }
    return pairs;
}

template SharedFaces sharedFaces(const Instance<BruteForce>&, const Instance<BruteForce>&);
template SharedFaces sharedFaces(const Instance<Bvh2>&, const Instance<Bvh2>&);
template SharedFaces sharedFaces(const Instance<Bvh8>&, const Instance<Bvh8>&);
template Vec3 roundingReach(const Instance<BruteForce>&, const Instance<BruteForce>&);
template Vec3 roundingReach(const Instance<Bvh2>&, const Instance<Bvh2>&);
template Vec3 roundingReach(const Instance<Bvh8>&, const Instance<Bvh8>&);
template std::vector<std::pair<std::uint32_t, std::uint32_t>>
meetingPairs(const std::vector<Instance<BruteForce>>&, std::span<const std::uint32_t>, std::size_t);
template std::vector<std::pair<std::uint32_t, std::uint32_t>>
meetingPairs(const std::vector<Instance<Bvh2>>&, std::span<const std::uint32_t>, std::size_t);
template std::vector<std::pair<std::uint32_t, std::uint32_t>>
meetingPairs(const std::vector<Instance<Bvh8>>&, std::span<const std::uint32_t>, std::size_t);

}
