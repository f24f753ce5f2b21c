#include "app/rayview/arrows.h"

#include <algorithm>
#include <functional>

#include "core/geometry/accel.h"

namespace eyeray {
namespace {

/// The first thing on the way to a lamp: opaque if there is one, else the glass that let nothing through.
Vec3 blockerOf(const World& world, const RayRecord& record) {
    const Ray ray{record.origin, record.direction, 0, record.t};
    return std::visit(
        [&](const auto& geometry) {
            for (const RayMask mask : {RayMask::Opaque, RayMask::Objects})
                if (const auto hit = closestHit(geometry, ray, mask)) return ray.at(hit->t);
            return ray.origin;
        },
        *world.accel);
}

}

std::vector<Arrow> arrowsOf(const SampleRecord& record, const World& world, int sample, float reach) {
    std::vector<Arrow> arrows;
    arrows.reserve(record.rays.size());
    for (std::size_t i = 0; i < record.rays.size(); ++i) {
        const RayRecord& ray = record.rays[i];
        Arrow arrow{.sample = sample,
                    .ray = static_cast<int>(i),
                    .kind = ray.kind,
                    .end = ray.end,
                    .endless = !std::isfinite(ray.t),
                    .from = ray.origin,
                    .to = ray.origin + (std::isfinite(ray.t) ? ray.t : reach) * ray.direction,
                    .weight = maxComponent(ray.weight)};
        if (ray.end == RayEnd::Hit) arrow.to = ray.hit.position;
        if (ray.end == RayEnd::Blocked) arrow.blocker = blockerOf(world, ray);
        arrows.push_back(arrow);
    }
    return arrows;
}

std::vector<Arrow> weightiest(std::vector<Arrow> arrows, std::size_t most, int kept) {
    if (arrows.size() <= most) return arrows;
    std::vector<float> weights;
    weights.reserve(arrows.size());
    for (const Arrow& arrow : arrows) weights.push_back(arrow.weight);
    const auto least = weights.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(weights.begin(), least, weights.end(), std::greater<>());
    std::size_t room = most; // for those of just the least weight
    for (const Arrow& arrow : arrows) room -= arrow.weight > *least ? 1U : 0U;
    std::erase_if(arrows, [&](const Arrow& arrow) {
        if (arrow.weight > *least || (arrow.sample == 0 && arrow.ray == kept)) return false;
        if (arrow.weight < *least || room == 0) return true;
        --room;
        return false;
    });
    return arrows;
}

}
