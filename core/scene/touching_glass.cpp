#include "core/scene/touching_glass.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/coincident_faces.h"

namespace eyeray {
namespace {

constexpr std::size_t kPairs = 64;

template <class Index>
void grow(Instance<Index>& instance, const DMat4& toWorld, const Vec3& reach) {
    const Bounds box = boundsOf(instance);
    const DVec3 center(box.center());
    const DVec3 scale = DVec3(1) + 2.0 * DVec3(reach) / DVec3(box.extent());
    DMat4 growth = glm::translate(DMat4(1), center);
    growth = glm::translate(glm::scale(growth, scale), -center);
    instance.placement = Placement(growth * toWorld);
}

}

template <class Index>
void joinTouchingGlass(std::vector<Instance<Index>>& instances, const std::vector<GlassSolid>& solids,
                       const std::stop_token& stop) {
    std::vector<std::uint32_t> ids;
    for (const GlassSolid& solid : solids) {
        const Vec3 extent = boundsOf(instances[solid.instance]).extent();
        if (extent.x > 0 && extent.y > 0 && extent.z > 0) ids.push_back(solid.instance);
    }
    for (const auto& [a, b] : meetingPairs<Index>(instances, ids, kPairs)) {
        if (stop.stop_requested()) return;
        if (sharedFaces(instances[a], instances[b]) == SharedFaces::None) continue;
        const Vec3 reach = roundingReach(instances[a], instances[b]);
        const bool first = boundsOf(instances[a]).halfArea() < boundsOf(instances[b]).halfArea();
        const std::uint32_t smaller = first ? a : b;
        const auto solid = std::find_if(solids.begin(), solids.end(),
                                        [&](const GlassSolid& s) { return s.instance == smaller; });
        grow(instances[smaller], solid->toWorld, reach);
    }
}

template void joinTouchingGlass(std::vector<Instance<BruteForce>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);
template void joinTouchingGlass(std::vector<Instance<Bvh2>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);
template void joinTouchingGlass(std::vector<Instance<Bvh8>>&, const std::vector<GlassSolid>&,
                                const std::stop_token&);

}
