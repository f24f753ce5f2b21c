#include "app/viewer/comparison_rendering.h"

#include <algorithm>

#include "core/image/metrics.h"

namespace eyeray {
namespace {

constexpr int kEvenStep = 8; // from it on; where a RenderSession looks at its error too
constexpr int kNeverBySamples = 1 << 30;

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
                                RenderSettings settings, int threads, int mostSamples, RenderSession& here) {
    if (!session_ || threads_ != threads) session_ = std::make_unique<RenderSession>(threads);
    threads_ = threads;
    still_ = nullptr;
    setPaused(paused_);
    begin(here, mostSamples);
    settings.stop = {.samples = kNeverBySamples, .seconds = 0, .error = 0}; // this side says when to stop
    session_->start(std::move(world), camera, settings);
}

void ComparisonRendering::start(std::shared_ptr<const ColorImage> still, int mostSamples,
                                RenderSession& here) {
    if (session_) session_->stop();
    still_ = std::move(still);
    begin(here, mostSamples);
}

void ComparisonRendering::begin(RenderSession& here, int mostSamples) {
    mostSamples_ = mostSamples;
    active_ = true;
    measuring_.cancel();
    change_.reset();
    hold(here, 1);
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
    const RenderStatus ours = here.status();
    const bool shownOtherwise = change_ && (display != display_ || otherDisplay != otherDisplay_);
    if (!active_ && !(shownOtherwise && ours.samples == target_ && otherReady())) return false;
    active_ = true;
    const bool finished = ours.phase == RenderStatus::Phase::Finished;
    if (auto measured = measuring_.take()) {
        change_ = std::make_shared<const PictureChange>(std::move(*measured));
        active_ = !finished && target_ < mostSamples_;
        if (active_) hold(here, std::min(following(target_), mostSamples_));
        if (!active_) here.holdAt(0);
        return true;
    }
    if (finished && ours.samples < target_) hold(here, ours.samples); // its time was up
    if (still_ && ours.samples > target_) hold(here, ours.samples);   // it had begun before
    if (ours.samples == target_ && otherReady()) {
        if (!measuring_.running() && !measure(here, display, otherDisplay)) stop(here);
        return false;
    }
    active_ = ours.phase != RenderStatus::Phase::Failed && !otherIsLost(ours);
    return false;
}

/// Whether the other side has failed, or gone on without this one.
bool ComparisonRendering::otherIsLost(const RenderStatus& ours) const {
    if (still_) return false;
    const RenderStatus theirs = session_->status();
    const bool apart = ours.phase == RenderStatus::Phase::Finished && theirs.samples > ours.samples;
    return apart || theirs.phase == RenderStatus::Phase::Failed;
}

/// Takes both pictures as they are while they are held, and compares them in the background. False if they
/// have not the same size: the still one is then of the window before, and another will come.
bool ComparisonRendering::measure(const RenderSession& here, const DisplaySettings& display,
                                  const DisplaySettings& otherDisplay) {
    ColorImage ours = here.image(), theirs = still_ ? *still_ : session_->image();
    if (ours.width() != theirs.width() || ours.height() != theirs.height()) return false;
    display_ = display;
    otherDisplay_ = otherDisplay;
    PictureChange change;
    change.samples = target_;
    const RenderStatus ownStatus = here.status();
    change.here = ownStatus.counts;
    change.secondsHere = ownStatus.seconds;
    if (!still_) {
        const RenderStatus otherStatus = session_->status();
        change.there = otherStatus.counts;
        change.secondsThere = otherStatus.seconds;
    }
    measuring_.start([change, ours = std::move(ours), theirs = std::move(theirs), display,
                      otherDisplay](const std::stop_token&) mutable {
        compare(change, ours, display, theirs, otherDisplay);
        return std::move(change);
    });
    return true;
}

}
