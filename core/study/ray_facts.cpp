#include "core/study/ray_facts.h"

#include <algorithm>

namespace eyeray {

float incidenceDegrees(const RayRecord& ray) {
    if (ray.end != RayEnd::Hit) return 0;
    const double cosine = -glm::dot(DVec3(ray.direction), DVec3(ray.hit.normal));
    return static_cast<float>(degrees(std::acos(std::clamp(cosine, 0.0, 1.0))));
}

Color contribution(const RayRecord& ray) { return ray.weight * ray.radiance; }

SharesAtHit sharesAtHit(const SampleRecord& record, const Family& family, int ray) {
    SharesAtHit shares;
    const auto note = [&](RayKind kind, const Color& share) {
        (kind == RayKind::Refraction ? shares.refracted : shares.reflected) = share;
    };
    for (const int next : family.nextRays[ray]) {
        const RayRecord& r = record.rays[static_cast<std::size_t>(next)];
        note(r.kind, r.share);
        shares.totalReflection |= r.totalReflection;
        shares.eta = r.eta;
    }
    for (const int missing : family.untraced[ray]) {
        const UntracedRay& r = record.untraced[static_cast<std::size_t>(missing)];
        note(r.kind, r.share);
    }
    return shares;
}

}
