#include "app/viewer/comparison_rendering.h"

#include <algorithm>

#include "core/image/metrics.h"

namespace eyeray {
namespace {

constexpr int kEvenStep = 8; // from it on; where a RenderSession looks at its error too
constexpr int kNeverBySamples = 1 << 30;

int following(int samples) { return samples < kEvenStep ? 2 * samples : samples + kEvenStep; }

/// `there` may be of the picture before, in another size.
std::optional<PictureChange> changeBetween(const RenderSession& here, const RenderSession& there,
                                           const DisplaySettings& display,
                                           const DisplaySettings& otherDisplay) {
    const ColorImage ours = here.image(), theirs = there.image();
    if (ours.width() != theirs.width() || ours.height() != theirs.height()) return std::nullopt;
    PictureChange change;
    change.samples = here.status().samples;
    change.pixels = ours.values().size();
    change.changed =
        countDifferingPixels(eyeray::display(ours, display), eyeray::display(theirs, otherDisplay));
    change.here = here.status().counts;
    change.there = there.status().counts;
    change.difference = ColorImage(ours.width(), ours.height());
    std::transform(ours.values().begin(), ours.values().end(), theirs.values().begin(),
                   change.difference.values().begin(),
                   [](const Color& a, const Color& b) { return glm::abs(a - b); });
    return change;
}

}

void ComparisonRendering::start(std::shared_ptr<const World> world, const Camera& camera,
                                RenderSettings settings, int threads, int mostSamples, RenderSession& here) {
    if (!session_ || threads_ != threads) session_ = std::make_unique<RenderSession>(threads);
    threads_ = threads;
    mostSamples_ = mostSamples;
    active_ = true;
    change_.reset();
    setPaused(paused_);
    hold(here, 1);
    settings.stop = {.samples = kNeverBySamples, .seconds = 0, .error = 0}; // this side says when to stop
    session_->start(std::move(world), camera, settings);
}

void ComparisonRendering::stop(RenderSession& here) {
    here.holdAt(0);
    active_ = false;
    change_.reset();
    if (session_) session_->stop();
}

void ComparisonRendering::setPaused(bool paused) {
    paused_ = paused;
    if (session_) paused ? session_->pause() : session_->resume();
}

void ComparisonRendering::hold(RenderSession& here, int samples) {
    target_ = samples;
    here.holdAt(samples);
    session_->holdAt(samples);
}

bool ComparisonRendering::update(RenderSession& here, const DisplaySettings& display,
                                 const DisplaySettings& otherDisplay) {
    if (!active_) return false;
    const RenderStatus ours = here.status(), theirs = session_->status();
    const bool finished = ours.phase == RenderStatus::Phase::Finished;
    if (finished && ours.samples < target_) hold(here, ours.samples); // its time was up
    const bool apart = finished && theirs.samples > ours.samples;
    if (ours.samples != target_ || theirs.samples != target_) {
        active_ = !apart && ours.phase != RenderStatus::Phase::Failed &&
                  theirs.phase != RenderStatus::Phase::Failed;
        return false;
    }
    change_ = changeBetween(here, *session_, display, otherDisplay);
    active_ = !finished && target_ < mostSamples_;
    hold(here, active_ ? std::min(following(target_), mostSamples_) : target_);
    if (!active_) here.holdAt(0);
    return change_.has_value();
}

}
