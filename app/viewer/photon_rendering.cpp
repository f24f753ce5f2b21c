#include "app/viewer/photon_rendering.h"

#include <algorithm>
#include <chrono>

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kRound = 1.0 / 30;       // seconds that a round of photons is to take
constexpr double kLongestRound = 1 << 20; // of a round
constexpr double kFirstPhotons = 2048;    // of the first, before it is known how fast they are
constexpr double kPathsShown = 0.4;       // seconds: else they flicker
constexpr double kLensShare = 0.01;       // of the way to the target

}

double lensRadius(const PhotonSettings& settings, const Camera& camera) {
    constexpr double kLeast = 1e-6; // metres: an eye may stand on its target
    for (const double radius : {settings.radius, camera.lensRadius})
        if (radius > 0) return radius;
    return std::max(kLensShare * camera.distance(), kLeast);
}

struct PhotonRendering::Run {
    std::mutex mutex; // of all below
    std::condition_variable_any changed;
    double perSecond = kMostPhotonsPerSecond;
    std::uint64_t most = 0;
    bool paused = false;
    bool done = false; // all that were asked for have been sent
    std::shared_ptr<const PhotonPicture> picture;

    bool standsStill(std::uint64_t sent) const { return paused || (most > 0 && sent >= most); }
};

/// The job's side.
class PhotonRendering::Sender {
public:
    Sender(Run& run, const PhotonRequest& request, std::stop_token stop)
        : run_(run), stop_(std::move(stop)),
          pixels_(static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height)),
          walk_(request.world, request.camera,
                lensOf(request.camera, request.world->origin,
                       static_cast<double>(request.width) / request.height, request.radius),
                request.seed),
          film_(blocks(request.width), blocks(request.height)), pool_(request.threads) {}

    /// True when there is nothing to send; else it ends when it is stopped.
    bool run() {
        lowerThreadPriority();
        publish(0);
        if (walk_.lamps().empty()) return true;
        while (const auto round = nextRound()) {
            const auto start = Clock::now();
            if (!film_.add(walk_, round->photons, pool_, stop_)) break;
            const Seconds took = Clock::now() - start;
            fastest_ = std::max(1.0, round->photons / std::max(took.count(), 1e-6));
            publish(seconds_ + took.count());
            if (round->perSecond < kMostPhotonsPerSecond) rest(*round, took);
            seconds_ += Seconds(Clock::now() - start).count();
        }
        return false;
    }

private:
    struct Round {
        int photons;
        double perSecond;
    };

    static int blocks(int pixels) { return (pixels + kPhotonBlock - 1) / kPhotonBlock; }

    /// Waits while nothing is to be sent; nothing when it is stopped.
    std::optional<Round> nextRound() {
        std::unique_lock lock(run_.mutex);
        const std::uint64_t sent = film_.tally().emitted;
        if (!run_.changed.wait(lock, stop_, [&] { return !run_.standsStill(sent); })) return std::nullopt;
        const bool unbounded = run_.perSecond >= kMostPhotonsPerSecond;
        const double rate = unbounded ? fastest_ : std::min(run_.perSecond, fastest_);
        double count = std::clamp(std::round(rate * kRound), 1.0, kLongestRound);
        if (run_.most > 0) count = std::min(count, static_cast<double>(run_.most - sent));
        return Round{static_cast<int>(count), run_.perSecond};
    }

    /// Until the next photons are due.
    void rest(const Round& round, Seconds took) {
        std::unique_lock lock(run_.mutex);
        run_.changed.wait_for(lock, stop_, Seconds(round.photons / round.perSecond) - took,
                              [&] { return run_.perSecond != round.perSecond || run_.paused; });
    }

    void publish(double seconds) {
        if (paths_.empty() || seconds >= pathsSince_ + kPathsShown ||
            film_.tally().emitted <= film_.latest().size()) {
            paths_ = film_.latest();
            paths_.insert(paths_.end(), film_.latestSeen().begin(), film_.latestSeen().end());
            pathsSince_ = seconds;
        }
        auto picture =
            std::make_shared<const PhotonPicture>(PhotonPicture{.lens = walk_.lens(),
                                                                .tally = film_.tally(),
                                                                .pixels = pixels_,
                                                                .seconds = seconds,
                                                                .radiance = film_.radiance(),
                                                                .paths = paths_,
                                                                .lamps = !walk_.lamps().empty(),
                                                                .replaced = walk_.lamps().replaced()});
        const std::scoped_lock lock(run_.mutex);
        run_.done = !picture->lamps || (run_.most > 0 && picture->tally.emitted >= run_.most);
        run_.picture = std::move(picture);
    }

    Run& run_;
    std::stop_token stop_;
    std::uint64_t pixels_;
    PhotonWalk walk_;
    PhotonFilm film_;
    ThreadPool pool_;
    double seconds_ = 0, fastest_ = kFirstPhotons / kRound; // photons a second, as measured
    std::vector<PhotonPath> paths_;
    double pathsSince_ = 0;
};

void PhotonRendering::show(const PhotonRequest& request, const PhotonSettings& settings) {
    const bool same = request_ == request;
    if (!same) {
        request_ = request;
        run_ = std::make_shared<Run>();
    }
    {
        const std::scoped_lock lock(run_->mutex);
        if (run_->most != settings.most) run_->done = false;
        run_->perSecond = settings.perSecond;
        run_->most = settings.most;
        run_->paused = paused_;
    }
    run_->changed.notify_all();
    if (same) return;
    job_.start(
        [run = run_, request](const std::stop_token& stop) { return Sender(*run, request, stop).run(); });
}

void PhotonRendering::clear() {
    job_.cancel();
    request_.reset();
    run_ = nullptr;
    shown_ = nullptr;
}

void PhotonRendering::setPaused(bool paused) {
    paused_ = paused;
    if (!run_) return;
    const std::scoped_lock lock(run_->mutex);
    run_->paused = paused;
    run_->changed.notify_all();
}

bool PhotonRendering::update() {
    job_.take();
    if (!run_) return false;
    const std::scoped_lock lock(run_->mutex);
    const bool fresh = run_->picture && shown_ != run_->picture;
    if (run_->picture) shown_ = run_->picture;
    return fresh || (job_.running() && !run_->done && !run_->paused);
}

bool PhotonRendering::ends() const {
    if (!run_ || !job_.running()) return false;
    const std::scoped_lock lock(run_->mutex);
    return run_->most > 0 && !run_->done && !run_->paused;
}

}
