#include "core/study/ray_traversal.h"

#include <fmt/format.h>

#include <algorithm>

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

    /// The shadow ray of this number.
    void shadow(const SampleRecord& record, int index, const TraceSettings& settings) {
        const RayRecord& r = record.rays[static_cast<std::size_t>(index)];
        const Ray ray{r.origin, r.direction, 0, r.t};
        if (isPhysical(settings.method)) {
            const bool clear =
                !anyHit(geometry_, ray, hasExtent(r.light) ? RayMask::All : RayMask::Objects, log_);
            const bool tinted = settings.method == Method::Distributed && bringsDiffuse(record, index);
            if (clear || !tinted || !world_.needs.refractions) return;
        }
        const bool inGlass = r.parent >= 0 && record.rays[static_cast<std::size_t>(r.parent)].medium >= 0;
        taught(ray, settings.glassShadows, inGlass);
    }

private:
    void taught(const Ray& ray, GlassShadows policy, bool inGlass) {
        const bool clear = !anyHit(geometry_, ray, RayMask::Objects, log_);
        if (!world_.needs.refractions || policy == GlassShadows::AllBlock) return;
        if (!clear && anyHit(geometry_, ray, RayMask::Opaque, log_)) return;
        if (policy == GlassShadows::Straight && (!clear || inGlass)) filtered(ray);
    }

    /// True for a lamp with a surface, and for the sky.
    bool hasExtent(int light) const {
        if (light < 0) return true;
        return hasSurface(world_.scene->lights[static_cast<std::size_t>(light)].shape);
    }

    static bool bringsDiffuse(const SampleRecord& record, int shadowRay) {
        return std::ranges::any_of(record.lamps, [&](const LampTerm& term) {
            return term.shadowRay == shadowRay && !isBlack(term.diffuse);
        });
    }

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

void logTraversal(const World& world, const TraceSettings& settings, const SampleRecord& record, int index,
                  TraversalLog& log) {
    const RayRecord& ray = record.rays[static_cast<std::size_t>(index)];
    std::visit(
        [&](const auto& geometry) {
            Questions questions(world, geometry, log);
            ray.kind == RayKind::Shadow ? questions.shadow(record, index, settings) : questions.nearest(ray);
        },
        *world.accel);
}

TraversalCounts traversalOf(const World& world, const TraceSettings& settings, const SampleRecord& record,
                            int ray) {
    TraversalLog log = countingLog();
    logTraversal(world, settings, record, ray, log);
    return log.counts;
}

TraversalCounts traversalOf(const World& world, const TraceSettings& settings, const SampleRecord& record) {
    TraversalLog log = countingLog();
    for (int ray = 0; ray < static_cast<int>(record.rays.size()); ++ray)
        logTraversal(world, settings, record, ray, log);
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
