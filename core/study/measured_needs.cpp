#include "core/study/measured_needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr double kFewerRays = 0.99;            // share that is a saving
constexpr double kFasterIndex = 0.93;          // share of the time below which another index is worth it
constexpr std::size_t kMostForBruteForce = 64; // primitives; with more it has never been faster
constexpr std::string_view kIndexStep = "index", kSamplesStep = "samples", kScene = "scene";

int stepsOf(double tolerance) { return static_cast<int>(std::floor(255 * tolerance + 1e-9)); }

std::string samplesText(int most, double mean) {
    return most - mean < 0.5 ? fmt::format("{}", most) : fmt::format("{} (mean {:.3g})", most, mean);
}

/// What measuring and checking share.
class Needs {
public:
    Needs(const NeedsPlan& plan, bool part, const NeedsStep& step, const std::stop_token& stop)
        : plan_(plan), step_(step),
          studio_(plan.settings, part, isPhysical(plan.settings.trace.method), plan.threads, stop) {
        result_.asSet = result_.needed = {plan.scene, plan.camera, plan.settings.trace, plan.accel,
                                          plan.settings.stop.samples};
        const int width = result_.width = plan.settings.width;
        const int height = result_.height = plan.settings.height;
        result_.tiles = studio_.tiles();
        result_.ofTiles = mosaicOf(width, height, width).tiles.size();
        result_.comparedSamples = std::min(studio_.comparedSamples(), plan.settings.stop.samples);
        result_.inBlocks = isPhysical(plan.settings.trace.method);
        result_.tolerance = plan.tolerance;
    }

    MeasuredNeeds measure() {
        begin();
        for (const NeedSubject& subject : needSubjects()) {
            step_(subject.name);
            for (const NeedLadder& ladder : subject.ladders(result_.needed)) climb(ladder);
        }
        return finish();
    }

    MeasuredNeeds check(const MeasuredNeeds& measured) {
        begin();
        leastSamples_ = measured.needed.samples;
        for (const MeasuredNeeds::Taken& taken : measured.taken) {
            step_(taken.ladder.what);
            descend(taken.ladder, taken.rung, measured.items[taken.item]);
        }
        return finish();
    }

private:
    /// The picture as set, and what is proved.
    void begin() {
        step_(std::string(kScene));
        asSet_ = studio_.shoot(result_.asSet);
        if (plan_.meterExposure) studio_.meterBy(asSet_);
        result_.display = studio_.display();
        for (const ProvedNeed& proved : provedNeeds(result_.asSet)) {
            for (const NeedLadder::Rung& rung : proved.ladder.rungs) rung.climb(result_.needed);
            NeedItem item{.what = proved.ladder.what,
                          .from = proved.ladder.from,
                          .to = proved.to,
                          .reason = proved.reason,
                          .proved = true,
                          .takenBack = {}};
            if (proved.force) item.saving = savingOf(studio_.shoot(result_.asSet, proved.force), asSet_);
            result_.items.push_back(std::move(item));
        }
        now_ = asSet_;
    }

    static double savingOf(const ModelShot& before, const ModelShot& after) {
        return std::max(0.0, 1 - after.secondsPerSample / before.secondsPerSample);
    }

    bool within(const ModelError& error) const {
        return error.steps <= stepsOf(plan_.tolerance) && error.flip <= plan_.tolerance;
    }

    /// The model on a rung; its picture, if it is still within the tolerance.
    std::optional<ModelShot> tried(const NeedLadder& ladder, std::size_t rung) {
        PictureModel model = result_.needed;
        ladder.rungs[rung].climb(model);
        ModelShot shot = studio_.shoot(model);
        if (!within(studio_.compare(asSet_, shot))) return std::nullopt;
        return shot;
    }

    struct Held {
        std::size_t rung;
        ModelShot shot;
    };
    /// The smallest rung from `first` on that is within the tolerance, by halving: those after it are taken
    /// to be, too.
    std::optional<Held> smallest(const NeedLadder& ladder, std::size_t first) {
        std::size_t end = ladder.rungs.size();
        std::optional<Held> held;
        while (first < end) {
            const std::size_t middle = (first + end) / 2;
            if (auto shot = tried(ladder, middle)) {
                held = {middle, std::move(*shot)};
                end = middle;
            } else {
                first = middle + 1;
            }
        }
        return held;
    }

    void climb(const NeedLadder& ladder) {
        auto held = smallest(ladder, 0);
        if (!held) return;
        const bool fewer = static_cast<double>(held->shot.rays) < kFewerRays * static_cast<double>(now_.rays);
        if (fewer || (ladder.evenIfFree && studio_.compare(now_, held->shot).steps == 0))
            take(ladder, held->rung, std::move(held->shot));
    }

    /// Takes the rung if it holds here, too; else the smallest after it that does.
    void descend(const NeedLadder& ladder, std::size_t rung, const NeedItem& measured) {
        if (auto shot = tried(ladder, rung)) return take(ladder, rung, std::move(*shot));
        if (auto held = smallest(ladder, rung + 1)) {
            take(ladder, held->rung, std::move(held->shot));
        } else {
            result_.items.push_back({.what = ladder.what,
                                     .from = ladder.from,
                                     .to = ladder.from,
                                     .reason = "stays as it is",
                                     .takenBack = {}});
        }
        result_.items.back().takenBack = inWhole(measured.to);
    }

    static std::string inWhole(const std::string& to) {
        return fmt::format("{} is too little for the whole picture", to);
    }

    void take(const NeedLadder& ladder, std::size_t rung, ModelShot shot) {
        const ModelError error = studio_.compare(now_, shot);
        const std::string& to = ladder.rungs[rung].to;
        result_.items.push_back({.what = ladder.what,
                                 .from = ladder.from,
                                 .to = to,
                                 .reason = reasonOf(fmt::format(fmt::runtime(ladder.leftOut), to), error),
                                 .saving = savingOf(now_, shot),
                                 .error = error,
                                 .takenBack = {}});
        result_.taken.push_back({ladder, rung, result_.items.size() - 1});
        ladder.rungs[rung].climb(result_.needed);
        now_ = std::move(shot);
    }

    std::string reasonOf(const std::string& leftOut, const ModelError& error) const {
        const char* const part = result_.inBlocks ? "block" : "pixel";
        if (error.steps == 0) return fmt::format("{} change no {}", leftOut, part);
        return fmt::format("{} change no {} by more than {}/255", leftOut, part, error.steps);
    }

    /// Time alone tells: all find the same hits.
    void chooseIndex() {
        step_(std::string(kIndexStep));
        const auto world = studio_.world(result_.needed);
        std::optional<AccelKind> best;
        double bestSeconds = kFasterIndex * now_.secondsPerSample;
        for (const AccelKind kind : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8}) {
            if (kind == world->accelKind) continue;
            if (kind == AccelKind::Brute && world->primitives > kMostForBruteForce) continue;
            PictureModel model = result_.needed;
            model.accel = kind;
            const double seconds = studio_.shoot(model).secondsPerSample;
            if (seconds >= bestSeconds) continue;
            best = kind;
            bestSeconds = seconds;
        }
        if (!best) return;
        const auto nameOf = [](AccelKind kind) {
            return std::string(kAccelNames[static_cast<std::size_t>(kind)]);
        };
        result_.items.push_back({.what = "index",
                                 .from = nameOf(world->accelKind),
                                 .to = nameOf(*best),
                                 .reason = fmt::format("it finds the same hits faster: {} primitive{}",
                                                       world->primitives, world->primitives == 1 ? "" : "s"),
                                 .saving = 1 - bestSeconds / now_.secondsPerSample,
                                 .takenBack = {}});
        result_.needed.accel = *best;
        now_.secondsPerSample = bestSeconds;
    }

    void countSamples() {
        step_(std::string(kSamplesStep));
        const EnoughSamples samples =
            studio_.enoughSamples(result_.needed, plan_.tolerance - result_.error.flip, leastSamples_);
        result_.secondsAsSet = asSet_.secondsPerSample * samples.meanAsSet;
        result_.secondsNeeded = now_.secondsPerSample * samples.meanEnough;
        if (samples.enough >= samples.asSet) return;
        result_.needed.samples = samples.enough;
        result_.error.flip += samples.flip;
        result_.items.push_back({.what = "samples",
                                 .from = samplesText(samples.asSet, samples.meanAsSet),
                                 .to = samplesText(samples.enough, samples.meanEnough),
                                 .reason = "more would change too little to be seen",
                                 .saving = 1 - samples.meanEnough / samples.meanAsSet,
                                 .error = {0, samples.flip},
                                 .takenBack = {}});
    }

    MeasuredNeeds finish() {
        chooseIndex();
        result_.error = studio_.compare(asSet_, now_);
        countSamples();
        return std::move(result_);
    }

    const NeedsPlan& plan_;
    const NeedsStep& step_;
    ModelStudio studio_;
    MeasuredNeeds result_;
    int leastSamples_ = 1;
    ModelShot asSet_, now_; // the picture as set, and of the smallest model so far
};

template <class Work>
std::optional<MeasuredNeeds> unlessClosed(const Work& work) {
    try {
        return work();
    } catch (const StudioClosed&) {
        return std::nullopt;
    }
}

}

std::size_t stepsToMeasure() { return needSubjects().size() + 3; } // the scene, the index, samples
std::size_t stepsToCheck(const MeasuredNeeds& measured) { return measured.taken.size() + 3; }

std::optional<MeasuredNeeds> measureNeeds(const NeedsPlan& plan, const NeedsStep& step,
                                          const std::stop_token& stop) {
    return unlessClosed([&] { return Needs(plan, true, step, stop).measure(); });
}

std::optional<MeasuredNeeds> checkNeeds(const NeedsPlan& plan, const MeasuredNeeds& measured,
                                        const NeedsStep& step, const std::stop_token& stop) {
    return unlessClosed([&] { return Needs(plan, false, step, stop).check(measured); });
}

}
