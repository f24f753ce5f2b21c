#include "core/study/ray_traversal.h"

#include <fmt/format.h>

#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr int kMostSurfaces = 256; // of glass along a shadow ray: the tracer goes no further

/// The tracer's own questions to the index, with a log.
template <class Index>
class Questions {
public:
    Questions(const World& world, const IndexedGeometry<Index>& geometry, TraversalLog& log)
        : world_(world), geometry_(geometry), log_(log) {}

    void nearest(const RayRecord& ray) {
        closestHit(geometry_, {ray.origin, ray.direction}, RayMask::All, log_);
    }

    void shadow(const RayRecord& record, GlassShadows policy, bool inGlass) {
        const Ray ray{record.origin, record.direction, 0, record.t};
        const bool clear = !anyHit(geometry_, ray, RayMask::Objects, log_);
        if (!world_.needs.refractions || policy == GlassShadows::AllBlock) return;
        if (!clear && anyHit(geometry_, ray, RayMask::Opaque, log_)) return;
        if (policy == GlassShadows::Straight && (!clear || inGlass)) filtered(ray);
    }

private:
    void filtered(Ray ray) {
        for (int i = 0; i < kMostSurfaces; ++i) {
            const auto hit = closestHit(geometry_, ray, RayMask::Transparent, log_);
            if (!hit || isBlack(transmissionAt(*hit))) return;
            ray.origin = spawnOrigin(surfaceAt(geometry_, ray, *hit), ray.direction);
            ray.tMax -= hit->t;
        }
    }

    const Color& transmissionAt(const Hit& hit) const {
        return world_.materials[world_.objects[hit.instance].material].surface.transmission;
    }

    const World& world_;
    const IndexedGeometry<Index>& geometry_;
    TraversalLog& log_;
};

TraversalLog countingLog() {
    TraversalLog log;
    log.countsOnly = true;
    return log;
}

}

void logTraversal(const World& world, GlassShadows policy, const SampleRecord& record, int index,
                  TraversalLog& log) {
    const auto at = [&](int ray) -> const RayRecord& { return record.rays[static_cast<std::size_t>(ray)]; };
    const RayRecord& ray = at(index);
    const bool inGlass = ray.parent >= 0 && at(ray.parent).medium >= 0;
    std::visit(
        [&](const auto& geometry) {
            Questions questions(world, geometry, log);
            ray.kind == RayKind::Shadow ? questions.shadow(ray, policy, inGlass) : questions.nearest(ray);
        },
        *world.accel);
}

TraversalCounts traversalOf(const World& world, GlassShadows policy, const SampleRecord& record, int ray) {
    TraversalLog log = countingLog();
    logTraversal(world, policy, record, ray, log);
    return log.counts;
}

TraversalCounts traversalOf(const World& world, GlassShadows policy, const SampleRecord& record) {
    TraversalLog log = countingLog();
    for (int ray = 0; ray < static_cast<int>(record.rays.size()); ++ray)
        logTraversal(world, policy, record, ray, log);
    return log.counts;
}

std::string traversalText(const TraversalCounts& counts, const World& world) {
    const std::string tests =
        fmt::format("{} of {} primitives", countText(counts.primitives), countText(world.primitives));
    if (world.accelKind == AccelKind::Brute) return "no index: " + tests;
    return fmt::format("{}: {} boxes in {} nodes, then {}",
                       kAccelNames[static_cast<std::size_t>(world.accelKind)], countText(counts.boxes),
                       countText(counts.nodes), tests);
}

}
