#include "core/transport/methods.h"
#include "core/transport/physical_tree.h"
#include "core/transport/tile_loop.h"

namespace eyeray {
namespace {

constexpr int kRouletteDepth = 3;      // from which roulette may end a path
constexpr float kMostSurvival = 0.95F; // or light could go round in a white room to no end

/// One lobe of all is followed, and glass blocks shadow rays.
struct PathRule {
    static float density(const TraceSettings& settings, RayKind lobe, const BsdfValue& value) {
        return traces(settings, lobe) ? value.pdfW * value.probability : 0;
    }

    template <Features F, class Index, class Recorder>
    static void block(SampleState<Index, Recorder>& state, const PhysicalPoint& point,
                      const PhysicalRay& from, const Emitter& emitter, const Ray& ray, float distance,
                      LampTerm& term) {
        const MediumStack& media = point.mediaTowards(ray.direction, from.tree.media);
        term.visibility = detail::clearVisibility(state, ray, emitter, media, distance);
    }
};

template <Features F, class Index, class Recorder>
class PathTracer {
public:
    explicit PathTracer(SampleState<Index, Recorder>& state) : state_(state) {}

    Color trace(const PhysicalRay& ray) {
        return physicalRadiance<PathRule, F>(
            state_, ray, [&](const PhysicalPoint& point, const Bsdf& bsdf, const Color& weight, int record) {
                return onward(ray, point, bsdf, weight, record);
            });
    }

private:
    Color onward(const PhysicalRay& ray, const PhysicalPoint& point, const Bsdf& bsdf, const Color& weight,
                 int record) {
        const float choice = bsdf.single() ? 0 : random(ray.key, SamplePurpose::Lobe).x;
        const auto sample = bsdf.pick(choice, random(ray.key, SamplePurpose::Direction));
        if (!sample || !(maxComponent(sample->weight) > 0)) return Color(0);
        Color share = sample->weight / sample->probability;
        auto reason = reasonNotToTrace(state_, ray, *sample);
        // A chain of mirrors has no noise that roulette could trade for time.
        if (!reason && (ray.scattered || !sample->delta) && ray.tree.depth + 1 >= kRouletteDepth) {
            const float survival = std::min(maxComponent(weight * share), kMostSurvival);
            if (random(ray.key, SamplePurpose::Roulette).x < survival)
                share /= state_.faults().has(Fault::RouletteUnweighted) ? 1 : survival;
            else
                reason = UntracedRay::Reason::Roulette;
        }
        const Color left = weight * share;
        if (reason) {
            if constexpr (Recorder::kOn)
                state_.recorder.record.untraced.push_back(
                    {*reason, record, sample->kind, sample->wi, share, left});
            return Color(0);
        }
        PhysicalRay next = nextRay(ray, point, *sample, share, left, record);
        next.pdfW = sample->delta ? 0 : sample->pdfW * sample->probability;
        next.forLamps = ray.tree.depth >= state_.context.settings.maxDepth;
        return share * trace(next);
    }

    Vec2 random(std::uint32_t key, SamplePurpose purpose) const { return state_.random(key, purpose); }

    SampleState<Index, Recorder>& state_;
};

struct Path {
    template <Features F, class Index, class Recorder>
    static Color radiance(SampleState<Index, Recorder>& state, const Ray& eyeRay) {
        return PathTracer<F, Index, Recorder>(state).trace(firstRay(state, eyeRay));
    }
};

}

std::unique_ptr<Integrator> makePath() { return std::make_unique<TiledIntegrator<Path>>(); }

}
