#include "core/study/experiment_run.h"

#include <fmt/format.h>

#include <map>

#include "core/base/errors.h"
#include "core/scene/choose_index.h"
#include "core/study/pass_loop.h"

namespace eyeray {
namespace {

constexpr std::uint32_t kReferenceSeed = 0x7eff0000; // far from those of the repeats
constexpr double kNoLimit = 1e12;                    // seconds

class ExperimentRun {
public:
    ExperimentRun(const ExperimentPlan& plan, const ReferenceStore& store, ExperimentProgress& progress,
                  const std::stop_token& stop)
        : plan_(plan), store_(store), progress_(progress), stop_(stop), pool_(plan.threads) {
        ENSURE(plan.referenceSamples >= 2 && plan.referenceSamples % 2 == 0 && plan.repeats >= 1);
    }

    std::optional<Experiment> run() {
        for (const ExperimentSetting& setting : combinations(plan_.grid, plan_.base))
            result_.curves.push_back({setting, labelOf(setting, plan_.grid), {}, 0, {}});
        makePoints();
        pilot();
        if (!makeReferences()) return std::nullopt;
        result_.display = plan_.display;
        if (plan_.meterExposure) result_.display.exposure = meteredExposure(result_.fullest.picture);
        for (int repeat = 0; repeat < plan_.repeats; ++repeat)
            for (std::size_t curve = 0; curve < result_.curves.size(); ++curve)
                guarded(curve, [&] { measure(curve, repeat); });
        for (ExperimentPoint& point : result_.points)
            if (point.repeats.empty() && point.failure.empty()) point.failure = "interrupted";
        return std::move(result_);
    }

private:
    void makePoints() {
        for (std::size_t curve = 0; curve < result_.curves.size(); ++curve)
            for (const int samples : plan_.grid.samples) result_.points.push_back({curve, samples, {}, {}});
    }

    std::span<ExperimentPoint> pointsOf(std::size_t curve) {
        const std::size_t each = plan_.grid.samples.size();
        return std::span(result_.points).subspan(curve * each, each);
    }

    void fail(std::size_t curve, const std::string& why) {
        for (ExperimentPoint& point : pointsOf(curve))
            if (point.repeats.empty() && point.failure.empty()) point.failure = why;
    }

    /// What goes wrong is the curve's failure alone.
    void guarded(std::size_t curve, const std::function<void()>& body) {
        try {
            if (!stop_.stop_requested()) body();
        } catch (const std::bad_alloc&) {
            fail(curve, "not enough memory");
        } catch (const std::exception& error) {
            fail(curve, error.what());
        }
    }

    /// Built once for each kind of index.
    std::shared_ptr<const World> world(const ExperimentSetting& setting) {
        const AccelKind kind = chooseIndex(*plan_.scene, {setting.accel, isByStreams(setting.trace.method)});
        auto& built = worlds_[kind];
        if (!built) built = buildWorld(plan_.scene, {kind});
        return built;
    }

    PassLoop loop(const ExperimentSetting& setting, std::uint32_t seed) {
        return {
            makeIntegrator(setting.trace.method),
            TraceContext(world(setting), plan_.camera, setting.trace, plan_.width, plan_.height, seed, {}),
            pool_};
    }

    std::string tooSlow() const { return fmt::format("takes longer than {:g} s", plan_.limitSeconds); }

    /// One pass of everything says how long all will take.
    void pilot() {
        progress_.begin("one sample of each");
        passSeconds_.resize(result_.curves.size());
        for (std::size_t curve = 0; curve < result_.curves.size(); ++curve)
            guarded(curve, [&] {
                PassLoop once = loop(result_.curves[curve].setting, plan_.seed);
                if (!once.pass(plan_.limitSeconds, stop_)) fail(curve, tooSlow());
                passSeconds_[curve] = once.seconds();
                result_.curves[curve].buildSeconds = world(result_.curves[curve].setting)->buildSeconds;
            });
        for (std::size_t curve = 0; curve < result_.curves.size(); ++curve)
            if (!failed(curve))
                progress_.expect(passSeconds_[curve] * plan_.grid.samples.back() * plan_.repeats);
    }

    bool failed(std::size_t curve) { return !pointsOf(curve).back().failure.empty(); }

    /// False if stopped.
    bool makeReferences() {
        struct Wanted {
            TraceSettings model;
            double passSeconds;
            Reference* into;
        };
        const TraceSettings fullest = fullestModel(plan_.base);
        PassLoop once = loop({fullest, AccelKind::Auto}, plan_.seed);
        if (!once.pass(kNoLimit, stop_)) return false;
        std::vector<Wanted> wanted = {{fullest, once.seconds(), &result_.fullest}};
        for (std::size_t curve = 0; curve < result_.curves.size(); ++curve)
            if (!failed(curve))
                wanted.push_back({modelOf(result_.curves[curve].setting), passSeconds_[curve],
                                  &result_.curves[curve].limit});
        std::vector<Wanted> toTrace;
        for (const Wanted& each : wanted) {
            const auto same = std::ranges::find(toTrace, each.model, &Wanted::model);
            if (same != toTrace.end()) continue;
            if (const auto kept = store_.find(each.model)) {
                known_.emplace_back(each.model, referenceOf(*kept, plan_.referenceSamples));
                continue;
            }
            progress_.expect(each.passSeconds * plan_.referenceSamples);
            toTrace.push_back(each);
        }
        for (const Wanted& each : toTrace) {
            const auto halves = trace(each.model, each.passSeconds);
            if (!halves) return false;
            store_.keep(each.model, *halves);
            known_.emplace_back(each.model, referenceOf(*halves, plan_.referenceSamples));
        }
        for (const Wanted& each : wanted)
            *each.into = std::ranges::find(known_, each.model, &Known::first)->second;
        return true;
    }

    /// One half after the other.
    std::optional<ReferenceHalves> trace(const TraceSettings& model, double passSeconds) {
        ReferenceHalves halves;
        for (std::uint32_t i = 0; i < 2; ++i) {
            PassLoop passes = loop({model, AccelKind::Auto}, plan_.seed ^ (kReferenceSeed + i));
            progress_.begin(fmt::format("reference for {} to depth {}",
                                        kMethodNames[static_cast<std::size_t>(model.method)],
                                        model.maxDepth));
            while (passes.passes() < plan_.referenceSamples / 2) {
                if (!passes.pass(kNoLimit, stop_)) return std::nullopt;
                progress_.did(passSeconds);
            }
            halves[i] = passes.picture();
        }
        return halves;
    }

    void measure(std::size_t curve, int repeat) {
        ExperimentCurve& measured = result_.curves[curve];
        progress_.begin(measured.label);
        PassLoop passes = loop(measured.setting, plan_.seed + static_cast<std::uint32_t>(repeat));
        if (measured.setting.adaptive) passes.sampleAdaptively(plan_.adaptiveError, result_.display);
        for (ExperimentPoint& point : pointsOf(curve)) {
            if (!point.failure.empty()) return;
            while (passes.passes() < point.samples) {
                if (!passes.pass(plan_.limitSeconds, stop_)) {
                    if (!stop_.stop_requested()) fail(curve, tooSlow());
                    return;
                }
                progress_.did(passSeconds_[curve]);
            }
            ColorImage picture = passes.picture();
            point.repeats.push_back({passes.seconds(), passes.samplesPerPixel(),
                                     errorsOf(measured.limit.picture, picture, result_.display),
                                     errorsOf(result_.fullest.picture, picture, result_.display)});
            if (repeat == 0) measured.picture = std::move(picture);
        }
    }

    using Known = std::pair<TraceSettings, Reference>;

    const ExperimentPlan& plan_;
    const ReferenceStore& store_;
    ExperimentProgress& progress_;
    const std::stop_token stop_;
    ThreadPool pool_;
    std::map<AccelKind, std::shared_ptr<const World>> worlds_;
    std::vector<double> passSeconds_; // of each curve
    std::vector<Known> known_;
    Experiment result_;
};

}

void ExperimentProgress::expect(double seconds) {
    const std::scoped_lock lock(mutex_);
    state_.expected += seconds;
}

void ExperimentProgress::begin(std::string what) {
    const std::scoped_lock lock(mutex_);
    state_.doing = std::move(what);
}

void ExperimentProgress::did(double seconds) {
    const std::scoped_lock lock(mutex_);
    state_.done += seconds;
}

ExperimentProgress::State ExperimentProgress::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

std::optional<Experiment> runExperiment(const ExperimentPlan& plan, const ReferenceStore& store,
                                        ExperimentProgress& progress, const std::stop_token& stop) {
    return ExperimentRun(plan, store, progress, stop).run();
}

}
