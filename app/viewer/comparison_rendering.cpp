#include "app/viewer/comparison_rendering.h"

#include <algorithm>

#include "core/image/metrics.h"

namespace eyeray {
namespace {

constexpr int kEvenStep = 8; // from it on; where a RenderSession looks at its error too
constexpr int kNeverBySamples = 1 << 30;

int following(int samples) { return samples < kEvenStep ? 2 * samples : samples + kEvenStep; }

void compare(PictureChange& change, const ColorImage& ours, const DisplaySettings& display,
             const ColorImage& theirs, const DisplaySettings& otherDisplay) {
    change.pixels = ours.values().size();
    change.changed =
        countDifferingPixels(eyeray::display(ours, display), eyeray::display(theirs, otherDisplay));
    change.difference = ColorImage(ours.width(), ours.height());
    std::transform(ours.values().begin(), ours.values().end(), theirs.values().begin(),
                   change.difference.values().begin(),
                   [](const Color& a, const Color& b) { return glm::abs(a - b); });
}

}

void ComparisonRendering::start(std::shared_ptr<const World> world, const Camera& camera,
                                RenderSettings settings, int threads, int mostSamples, RenderSession& here) {
    if (!session_ || threads_ != threads) session_ = std::make_unique<RenderSession>(threads);
    threads_ = threads;
    mostSamples_ = mostSamples;
    active_ = true;
    measuring_.cancel();
    change_.reset();
    setPaused(paused_);
    hold(here, 1);
    settings.stop = {.samples = kNeverBySamples, .seconds = 0, .error = 0}; // this side says when to stop
    session_->start(std::move(world), camera, settings);
}

void ComparisonRendering::stop(RenderSession& here) {
    here.holdAt(0);
    active_ = false;
    measuring_.cancel();
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
    if (auto measured = measuring_.take()) {
        change_ = std::move(measured);
        active_ = !finished && target_ < mostSamples_;
        if (active_) hold(here, std::min(following(target_), mostSamples_));
        if (!active_) here.holdAt(0);
        return true;
    }
    if (finished && ours.samples < target_) hold(here, ours.samples); // its time was up
    if (ours.samples == target_ && theirs.samples == target_) {
        if (!measuring_.running()) measure(here, display, otherDisplay);
        return false;
    }
    const bool apart = finished && theirs.samples > ours.samples;
    active_ =
        !apart && ours.phase != RenderStatus::Phase::Failed && theirs.phase != RenderStatus::Phase::Failed;
    return false;
}

/// Takes both pictures as they are while they are held, and compares them in the background.
void ComparisonRendering::measure(const RenderSession& here, const DisplaySettings& display,
                                  const DisplaySettings& otherDisplay) {
    PictureChange change;
    change.samples = target_;
    change.here = here.status().counts;
    change.there = session_->status().counts;
    measuring_.start([change, ours = here.image(), theirs = session_->image(), display,
                      otherDisplay](const std::stop_token&) mutable {
        compare(change, ours, display, theirs, otherDisplay);
        return std::move(change);
    });
}

}
