#include "core/transport/methods.h"
#include "core/transport/physical_tree.h"
#include "core/transport/tile_loop.h"

namespace eyeray {
namespace {

/// Mirror image and glass are both followed, diffuse light is not; glass does to shadow rays what is asked
/// for.
struct DistributedRule {
    static float density(const TraceSettings& settings, RayKind lobe, const BsdfValue& value) {
        return lobe != RayKind::Diffuse && traces(settings, lobe) ? value.pdfW : 0;
    }

    /// Light that shadow rays bring straight through glass is for diffuse surfaces: the rays that go on from
    /// others find their lamps through glass themselves.
    template <Features F, class Index, class Recorder>
    static void block(SampleState<Index, Recorder>& state, const PhysicalPoint& point,
                      const PhysicalRay& from, const Emitter& emitter, const Ray& ray, float distance,
                      LampTerm& term) {
        const MediumStack& media = point.mediaTowards(ray.direction, from.tree.media);
        term.visibility = detail::clearVisibility(state, ray, emitter, media, distance);
        if (!F.transparent || !isBlack(term.visibility)) return;
        term.specular = Color(0);
        if (!isBlack(term.diffuse)) term.visibility = detail::visibility<F>(state, ray, media);
    }
};

template <Features F, class Index, class Recorder>
class DistributedTree {
public:
    explicit DistributedTree(SampleState<Index, Recorder>& state) : state_(state) {}

    Color trace(const PhysicalRay& ray) {
        return physicalRadiance<DistributedRule, F>(
            state_, ray, [&](const PhysicalPoint& point, const Bsdf& bsdf, const Color& weight, int record) {
                Color radiance(0);
                radiance += sent(RayKind::Reflection, ray, point, bsdf, weight, record);
                if constexpr (F.transparent)
                    radiance += sent(RayKind::Refraction, ray, point, bsdf, weight, record);
                return radiance;
            });
    }

private:
    Color sent(RayKind lobe, const PhysicalRay& ray, const PhysicalPoint& point, const Bsdf& bsdf,
               const Color& weight, int record) {
        const auto sample = bsdf.sample(lobe, state_.random(keyOfNext(ray, lobe), SamplePurpose::Direction));
        if (!sample || !(maxComponent(sample->weight) > 0)) return Color(0);
        const Color left = weight * sample->weight;
        auto reason = reasonNotToTrace(state_, ray, *sample);
        if (!reason && maxComponent(left) < state_.context.settings.cutoff)
            reason = UntracedRay::Reason::Cutoff;
        if (reason) {
            if constexpr (Recorder::kOn)
                state_.recorder.record.untraced.push_back(
                    {*reason, record, lobe, sample->wi, sample->weight, left});
            return Color(0);
        }
        PhysicalRay next = nextRay(ray, point, *sample, sample->weight, left, record);
        next.pdfW = sample->pdfW;
        next.forLamps = ray.tree.depth >= state_.context.settings.maxDepth;
        return sample->weight * trace(next);
    }

    SampleState<Index, Recorder>& state_;
};

struct Distributed {
    template <Features F, class Index, class Recorder>
    static Color radiance(SampleState<Index, Recorder>& state, const Ray& eyeRay) {
        return DistributedTree<F, Index, Recorder>(state).trace(firstRay(state, eyeRay));
    }
};

}

std::unique_ptr<Integrator> makeDistributed() { return std::make_unique<TiledIntegrator<Distributed>>(); }

}
