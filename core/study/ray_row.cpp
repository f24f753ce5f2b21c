#include "core/study/ray_row.h"

#include <fmt/format.h>

#include "core/study/ray_facts.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

std::string tripleText(const DVec3& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z); }

std::string materialName(const Scene& scene, const RayRecord& ray) {
    const auto material = static_cast<std::size_t>(ray.hit.material);
    const bool known = ray.end == RayEnd::Hit && ray.hit.material >= 0 && material < scene.materials.size();
    return known ? scene.materials[material].name : std::string();
}

std::string shareText(const Color& share) { return isBlack(share) ? std::string() : colorText(share); }

}

RayRow rayRow(const SampleRecord& record, const Family& family, const Scene& scene, const DVec3& worldOrigin,
              int index) {
    const RayRecord& ray = record.rays[static_cast<std::size_t>(index)];
    const SharesAtHit shares = sharesAtHit(record, family, index);
    const bool hit = ray.end == RayEnd::Hit;
    return {fmt::format("{} #{}", name(ray.kind), index),
            fmt::format("{}", ray.depth),
            meeting(scene, ray),
            materialName(scene, ray),
            metresText(ray.t),
            hit ? fmt::format("{:.2f}°", incidenceDegrees(ray)) : std::string(),
            shareText(shares.reflected),
            shares.totalReflection ? std::string(kTotalReflectionText) : shareText(shares.refracted),
            shares.eta != 1 ? fmt::format("{:.4g}", shares.eta) : std::string(),
            ray.medium >= 0 ? fmt::format("{} in {}", metresText(ray.t), objectName(scene, ray.medium))
                            : std::string(),
            ray.transmitted != Color(1) ? colorText(ray.transmitted) : std::string(),
            colorText(ray.weight),
            colorText(ray.radiance),
            colorText(contribution(ray)),
            tripleText(DVec3(ray.origin) + worldOrigin),
            tripleText(DVec3(ray.direction))};
}

}
