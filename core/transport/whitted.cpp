#include "core/transport/methods.h"
#include "core/transport/next_rays.h"
#include "core/transport/ray_tree.h"
#include "core/transport/tile_loop.h"

namespace eyeray {
namespace {

template <Features F, class Index, class Recorder>
class RayTree {
public:
    explicit RayTree(SampleState<Index, Recorder>& state) : state_(state) {}

    Color trace(const TreeRay& ray) {
        state_.counts.deepest = std::max(state_.counts.deepest, ray.depth);
        return radianceAlong<F>(state_, ray, [&](const ShadingPoint& p, const Color& weight, int record) {
            return onward(ray, p, weight, record);
        });
    }

private:
    Color onward(const TreeRay& ray, const ShadingPoint& p, const Color& weight, int record) {
        const TraceSettings& settings = state_.context.settings;
        const bool goesOn = p.surface->reflects() || p.surface->transmits();
        if (!goesOn || (!Recorder::kOn && ray.depth >= settings.maxDepth)) return Color(0);
        const NextRays next = nextRays(*state_.context.world, settings, p, ray.media, state_.faults());
        const float cosine = glm::dot(p.normal, p.wo);
        Color radiance(0);
        const Color reflected = weight * next.reflectedShare;
        if (worthTracing(ray, RayKind::Reflection, settings.reflections, next.reflection, next.reflectedShare,
                         reflected, record))
            radiance +=
                next.reflectedShare * trace({.ray = {spawnOrigin(p.at, next.reflection), next.reflection},
                                             .kind = RayKind::Reflection,
                                             .depth = ray.depth + 1,
                                             .parent = record,
                                             .share = next.reflectedShare,
                                             .weight = reflected,
                                             .media = ray.media,
                                             .totalReflection = next.totalReflection,
                                             .eta = next.eta,
                                             .cosine = cosine});
        if constexpr (F.transparent) {
            const Color refracted = weight * next.refractedShare;
            if (worthTracing(ray, RayKind::Refraction, settings.refractions, next.refraction,
                             next.refractedShare, refracted, record))
                radiance +=
                    next.refractedShare * trace({.ray = {spawnOrigin(p.at, next.refraction), next.refraction},
                                                 .kind = RayKind::Refraction,
                                                 .depth = ray.depth + 1,
                                                 .parent = record,
                                                 .share = next.refractedShare,
                                                 .weight = refracted,
                                                 .media = next.refractedMedia,
                                                 .eta = next.eta,
                                                 .cosine = cosine});
        }
        return radiance;
    }

    // Whether a next ray of this share and weight is to be traced.
    bool worthTracing(const TreeRay& ray, RayKind kind, bool on, const Vec3& direction, const Color& share,
                      const Color& weight, int record) {
        using Reason = UntracedRay::Reason;
        const float largest = maxComponent(weight);
        if (!(largest > 0)) return false;
        std::optional<Reason> reason;
        if (!on)
            reason = Reason::SwitchedOff;
        else if (ray.depth >= state_.context.settings.maxDepth)
            reason = Reason::DepthLimit;
        else if (largest < state_.context.settings.cutoff)
            reason = Reason::Cutoff;
        else if (state_.treeNodes > kMaxTreeNodes || state_.context.stop.stop_requested())
            reason = Reason::TreeLimit;
        if constexpr (Recorder::kOn)
            if (reason)
                state_.recorder.record.untraced.push_back({*reason, record, kind, direction, share, weight});
        return !reason;
    }

    SampleState<Index, Recorder>& state_;
};

struct Whitted {
    static constexpr bool kByStreams = true;

    template <Features F, class Index, class Recorder>
    static Color radiance(SampleState<Index, Recorder>& state, const Ray& eyeRay) {
        return RayTree<F, Index, Recorder>(state).trace({.ray = eyeRay, .media = state.context.eyeMedia});
    }
};

}

std::unique_ptr<Integrator> makeWhitted() { return std::make_unique<TiledIntegrator<Whitted>>(); }

}
