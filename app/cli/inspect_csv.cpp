#include <fmt/format.h>

#include "app/cli/csv.h"
#include "app/cli/inspected.h"
#include "core/study/ray_facts.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr const char* kHeading =
    "ray,parent,kind,depth,origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t,end,object,light,"
    "medium,total_reflection,eta,incidence_deg,share_r,share_g,share_b,weight_r,weight_g,weight_b,"
    "transmitted_r,transmitted_g,transmitted_b,radiance_r,radiance_g,radiance_b,contribution_r,"
    "contribution_g,contribution_b,nodes,boxes,tests\n";

std::string triple(const Vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

}

std::string csvOf(const Inspected& inspected) {
    const Scene& scene = *inspected.world->scene;
    std::string text = kHeading;
    for (std::size_t i = 0; i < inspected.trace.rays.size(); ++i) {
        const RayRecord& ray = inspected.trace.rays[i];
        const DVec3 origin = inspected.inScene(ray.origin);
        const TraversalCounts& work = inspected.traversal[i];
        const bool hit = ray.end == RayEnd::Hit, shadow = ray.kind == RayKind::Shadow;
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", i,
                            ray.parent, name(ray.kind), ray.depth, origin.x, origin.y, origin.z,
                            triple(ray.direction), std::isfinite(ray.t) ? fmt::format("{}", ray.t) : "",
                            name(ray.end), hit ? quoted(objectName(scene, ray.object)) : "",
                            shadow ? quoted(lampName(scene, ray.light)) : "",
                            ray.medium >= 0 ? quoted(objectName(scene, ray.medium)) : "",
                            ray.totalReflection ? 1 : 0, ray.eta,
                            hit ? fmt::format("{}", incidenceDegrees(ray)) : "", triple(ray.share),
                            triple(ray.weight), triple(ray.transmitted), triple(ray.radiance),
                            triple(contribution(ray)), work.nodes, work.boxes, work.primitives);
    }
    return text;
}

}
