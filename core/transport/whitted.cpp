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
        return radianceAlong<F>(state_, ray, [&](const ShadingPoint& p, const Color& weight, int record) {
            return onward(ray, p, weight, record);
        });
    }

private:
    Color onward(const TreeRay& ray, const ShadingPoint& p, const Color& weight, int record) {
        const TraceSettings& settings = state_.context.settings;
        if (ray.depth >= settings.maxDepth || !(p.surface.reflects() || p.surface.transmits()))
            return Color(0);
        const NextRays next = nextRays(*state_.context.world, settings, p, ray.media);
        Color radiance(0);
        if (settings.reflections && worthTracing(weight * next.reflectedShare))
            radiance += next.reflectedShare *
                        trace(child(ray, p, next.reflection, weight * next.reflectedShare,
                                    RayKind::Reflection, ray.media, record, next.totalReflection));
        if constexpr (F.transparent)
            if (settings.refractions && worthTracing(weight * next.refractedShare))
                radiance += next.refractedShare *
                            trace(child(ray, p, next.refraction, weight * next.refractedShare,
                                        RayKind::Refraction, next.refractedMedia, record, false));
        return radiance;
    }

    bool worthTracing(const Color& weight) const {
        const float largest = maxComponent(weight);
        return largest > 0 && largest >= state_.context.settings.cutoff &&
               state_.treeNodes <= kMaxTreeNodes && !state_.context.stop.stop_requested();
    }

    TreeRay child(const TreeRay& parent, const ShadingPoint& p, const Vec3& direction, const Color& weight,
                  RayKind kind, const MediumStack& media, int record, bool totalReflection) {
        const int depth = parent.depth + 1;
        state_.counts.deepest = std::max(state_.counts.deepest, depth);
        return {.ray = {spawnOrigin(p.at, direction), direction},
                .kind = kind,
                .depth = depth,
                .parent = record,
                .weight = weight,
                .media = media,
                .totalReflection = totalReflection};
    }

    SampleState<Index, Recorder>& state_;
};

struct Whitted {
    template <Features F, class Index, class Recorder>
    static Color radiance(SampleState<Index, Recorder>& state, const Ray& eyeRay) {
        return RayTree<F, Index, Recorder>(state).trace({.ray = eyeRay, .media = state.context.eyeMedia});
    }
};

}

std::unique_ptr<Integrator> makeWhitted() { return std::make_unique<TiledIntegrator<Whitted>>(); }

}
