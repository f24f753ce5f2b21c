#include "app/viewer/comparison_rendering.h"

#include <algorithm>

#include "core/image/metrics.h"

namespace eyeray {
namespace {

constexpr int kEvenStep = 8; // from it on; where a RenderSession looks at its error too
constexpr int kNeverBySamples = 1 << 30;
constexpr double kFirstSeconds = 0.25, kSecondsGrowth = 1.5;

int following(int samples) { return samples < kEvenStep ? 2 * samples : samples + kEvenStep; }

/// Over each wrong pixel a veil in a colour that no scene has; where few are wrong, so that they are seen, a
/// blot over the neighbours of lonely ones as well.
ByteImage marksOf(const std::vector<std::pair<int, int>>& wrong, int width, int height) {
    constexpr Rgba8 kVeil{255, 0, 200, 140}, kBlot{255, 0, 200, 255};
    constexpr std::size_t kFew = 100; // one in so many pixels
    constexpr int kLonely = 3;        // wrong neighbours at most
    ByteImage marks(width, height, {0, 0, 0, 0});
    for (const auto& [x, y] : wrong) marks.at(x, y) = kVeil;
    if (wrong.size() * kFew >= static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        return marks;
    const ByteImage veils = marks;
    for (const auto& [x, y] : wrong) {
        const int left = std::max(0, x - 1), right = std::min(x + 1, width - 1);
        const int top = std::max(0, y - 1), bottom = std::min(y + 1, height - 1);
        int around = -1;
        for (int j = top; j <= bottom; ++j)
            for (int i = left; i <= right; ++i) around += veils.at(i, j).a > 0 ? 1 : 0;
        if (around > kLonely) continue;
        for (int j = top; j <= bottom; ++j)
            for (int i = left; i <= right; ++i) marks.at(i, j) = kBlot;
    }
    return marks;
}

void mark(PictureChange& change, const ByteImage& ours, const ByteImage& theirs) {
    std::vector<std::pair<int, int>> wrong;
    for (int y = 0; y < ours.height(); ++y)
        for (int x = 0; x < ours.width(); ++x)
            if (clearlyDiffers(ours.at(x, y), theirs.at(x, y))) wrong.emplace_back(x, y);
    change.changed = countDifferingPixels(ours, theirs);
    change.wrong = wrong.size();
    change.marks = marksOf(wrong, ours.width(), ours.height());
}

double meanLuminance(const ColorImage& image) {
    double sum = 0;
    for (const Color& value : image.values()) sum += luminance(DVec3(value));
    return sum / static_cast<double>(image.values().size());
}

void compare(PictureChange& change, const ColorImage& ours, const DisplaySettings& display,
             const ColorImage& theirs, const DisplaySettings& otherDisplay) {
    change.pixels = ours.values().size();
    mark(change, eyeray::display(ours, display), eyeray::display(theirs, otherDisplay));
    change.lightHere = meanLuminance(ours);
    change.lightThere = meanLuminance(theirs);
    change.difference = ColorImage(ours.width(), ours.height());
    std::transform(ours.values().begin(), ours.values().end(), theirs.values().begin(),
                   change.difference.values().begin(),
                   [](const Color& a, const Color& b) { return glm::abs(a - b); });
}

}

void ComparisonRendering::start(std::shared_ptr<const World> world, const Camera& camera,
                                RenderSettings settings, int threads, ComparedShare share,
                                RenderSession& here) {
    if (!session_ || threads_ != threads) session_ = std::make_unique<RenderSession>(threads);
    threads_ = threads;
    still_ = nullptr;
    setPaused(paused_);
    begin(here, share);
    const bool adaptive = share.equal == EqualShare::Seconds && settings.stop.adaptive;
    settings.stop = {.samples = kNeverBySamples, // this side says when to stop
                     .seconds = 0,
                     .error = adaptive ? settings.stop.error : 0,
                     .adaptive = adaptive};
    session_->start(std::move(world), camera, settings);
}

void ComparisonRendering::start(std::shared_ptr<const ColorImage> still, int mostSamples,
                                RenderSession& here) {
    if (session_) session_->stop();
    still_ = std::move(still);
    begin(here, {EqualShare::Samples, mostSamples});
}

void ComparisonRendering::begin(RenderSession& here, ComparedShare share) {
    share_ = share;
    active_ = true;
    measuring_.cancel();
    change_.reset();
    nextSeconds_ = kFirstSeconds;
    hold(here, share.equal == EqualShare::Samples ? 1 : 0);
}

void ComparisonRendering::stop(RenderSession& here) {
    here.holdAt(0);
    active_ = false;
    still_ = nullptr;
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
    if (!still_) session_->holdAt(samples);
}

bool ComparisonRendering::otherReady() const { return still_ || session_->status().samples == target_; }

bool ComparisonRendering::update(RenderSession& here, const DisplaySettings& display,
                                 const DisplaySettings& otherDisplay) {
    asked_ = {display, otherDisplay};
    if (!active_ && !(change_ && asked_ != compared_)) return false;
    return share_.equal == EqualShare::Samples ? updateBySamples(here) : updateBySeconds(here);
}

bool ComparisonRendering::updateBySamples(RenderSession& here) {
    const RenderStatus ours = here.status();
    const bool together = ours.samples == target_ && otherReady();
    if (!active_ && !together) return false;
    active_ = true;
    const bool finished = ours.phase == RenderStatus::Phase::Finished;
    if (auto measured = measuring_.take()) {
        change_ = std::make_shared<const PictureChange>(std::move(*measured));
        active_ = !finished && target_ < share_.most;
        if (active_) hold(here, std::min(following(target_), share_.most));
        if (!active_) here.holdAt(0);
        return true;
    }
    if (finished && ours.samples < target_) hold(here, ours.samples); // its time was up
    if (still_ && ours.samples > target_) hold(here, ours.samples);   // it had begun before
    if (together) {
        if (!measuring_.running() && !measure(here)) stop(here);
        return false;
    }
    active_ = ours.phase != RenderStatus::Phase::Failed && !otherIsLost(ours);
    return false;
}

bool ComparisonRendering::updateBySeconds(RenderSession& here) {
    using Phase = RenderStatus::Phase;
    const RenderStatus ours = here.status(), theirs = session_->status();
    const bool oursEnded = ours.phase == Phase::Finished, theirsEnded = theirs.phase == Phase::Finished;
    const bool last = oursEnded && (theirsEnded || theirs.seconds >= ours.seconds);
    if (last && !theirsEnded) session_->holdAt(theirs.samples);
    if (auto measured = measuring_.take()) {
        change_ = std::make_shared<const PictureChange>(std::move(*measured));
        active_ = !last || change_->samples < ours.samples || change_->samplesThere < theirs.samples;
        return true;
    }
    active_ = ours.phase != Phase::Failed && theirs.phase != Phase::Failed;
    if (!active_ || measuring_.running() || ours.samples < 1 || theirs.samples < 1) return false;
    const double seconds = theirsEnded ? ours.seconds : std::min(ours.seconds, theirs.seconds);
    if (!last && seconds < nextSeconds_) return false;
    nextSeconds_ = kSecondsGrowth * seconds;
    if (!measure(here)) stop(here);
    return false;
}

/// Whether the other side has failed, or gone on without this one.
bool ComparisonRendering::otherIsLost(const RenderStatus& ours) const {
    if (still_) return false;
    const RenderStatus theirs = session_->status();
    const bool apart = ours.phase == RenderStatus::Phase::Finished && theirs.samples > ours.samples;
    return apart || theirs.phase == RenderStatus::Phase::Failed;
}

/// Takes both pictures by their whole passes, and compares them in the background; not yet, if a pass of
/// either ends meanwhile. False if they have not the same size: the still one is then of the window before,
/// and another will come.
bool ComparisonRendering::measure(const RenderSession& here) {
    const RenderStatus ours = here.status(), theirs = still_ ? RenderStatus{} : session_->status();
    ColorImage own = here.image(), other = still_ ? *still_ : session_->image();
    if (own.width() != other.width() || own.height() != other.height()) return false;
    const bool moved =
        here.status().samples != ours.samples || (!still_ && session_->status().samples != theirs.samples);
    if (moved) return true;
    compared_ = asked_;
    PictureChange change;
    change.samples = ours.samples;
    change.samplesThere = still_ ? ours.samples : theirs.samples;
    change.here = ours.counts;
    change.there = theirs.counts;
    change.secondsHere = ours.seconds;
    change.secondsThere = theirs.seconds;
    measuring_.start([change, own = std::move(own), other = std::move(other),
                      displays = asked_](const std::stop_token&) mutable {
        compare(change, own, displays.here, other, displays.there);
        return std::move(change);
    });
    return true;
}

}
