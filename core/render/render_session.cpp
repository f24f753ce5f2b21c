#include "core/render/render_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/render/adaptive.h"

namespace eyeray {
namespace {

using Clock = std::chrono::steady_clock;
using Phase = RenderStatus::Phase;

constexpr double kCoarseSeconds = 0.012;      // what a coarse picture may take, to fit a frame with all else
constexpr double kLeastCoarseSeconds = 0.003; // after a build that fills the frame
constexpr int kErrorInterval = 8;             // passes between looks at the error

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<int> tilesFrom(const Film& film, const DVec2& focus) {
    std::vector<int> order(static_cast<std::size_t>(film.tiles()));
    std::iota(order.begin(), order.end(), 0);
    const auto distance = [&](int index) {
        const Tile tile = film.tile(index);
        return std::pair(glm::length(DVec2(tile.x0 + tile.x1, tile.y0 + tile.y1) * 0.5 - focus), index);
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return distance(a) < distance(b); });
    return order;
}

}

struct RenderSession::Job {
    RenderSettings settings;
    std::shared_ptr<const TraceContext> context; // never stopped: for retracing
    std::unique_ptr<const Integrator> integrator;
    std::shared_ptr<Film> film;
    DVec2 focus;
    Clock::time_point asked = Clock::now();

    std::mutex betweenPasses; // held while the sums of whole passes may change
    std::vector<int> order;   // of tiles
    std::stop_source stop;    // of the loop under way; a new one for each
    bool cancelled = false, inPass = false;
    std::atomic<int> tilesDone = 0, tilesInAll = 1;
    RenderStatus status; // guarded by the session's mutex
    int passes = 0;      // whole ones; guarded by betweenPasses
};

double RenderStatus::mraysPerSecond() const {
    return seconds > 0 ? static_cast<double>(counts.total() - knownHits) / seconds * 1e-6 : 0;
}

RenderSession::RenderSession(int threads)
    : pool_(threads), coordinator_([this](const std::stop_token& end) { coordinate(end); }) {}

RenderSession::~RenderSession() {
    stop();
    coordinator_.request_stop();
}

void RenderSession::start(std::shared_ptr<const World> world, const Camera& camera,
                          const RenderSettings& settings) {
    auto job = std::make_shared<Job>();
    job->settings = settings;
    job->integrator = makeIntegrator(settings.trace.method);
    job->context =
        std::make_shared<const TraceContext>(std::move(world), camera, settings.trace, settings.width,
                                             settings.height, settings.seed, std::stop_token{});
    job->focus = focus_.x >= 0 ? focus_ : DVec2(settings.width, settings.height) * 0.5;
    job->status.phase = Phase::Coarse;
    job->status.threads = pool_.threads();
    const std::scoped_lock lock(mutex_);
    if (running_) {
        running_->cancelled = true;
        running_->stop.request_stop();
    }
    pending_ = std::move(job);
    givesWay_ = false;
    changed_.notify_all();
}

void RenderSession::stop() {
    std::unique_lock lock(mutex_);
    pending_ = nullptr;
    if (running_) {
        running_->cancelled = true;
        running_->stop.request_stop();
    }
    changed_.notify_all();
    changed_.wait(lock, [&] { return running_ == nullptr; });
}

void RenderSession::pause() {
    const std::scoped_lock lock(mutex_);
    paused_ = true;
    if (running_ && running_->status.phase == Phase::Refining) running_->stop.request_stop();
}

void RenderSession::resume() {
    const std::scoped_lock lock(mutex_);
    paused_ = false;
    changed_.notify_all();
}

void RenderSession::giveWay() {
    const std::scoped_lock lock(mutex_);
    givesWay_ = true;
    if (running_ && running_->inPass) running_->stop.request_stop();
}

void RenderSession::goOn() {
    const std::scoped_lock lock(mutex_);
    givesWay_ = false;
    changed_.notify_all();
}

void RenderSession::holdAt(int samples) {
    const std::scoped_lock lock(mutex_);
    holdAt_ = samples;
    changed_.notify_all();
}

RenderStatus RenderSession::status() const {
    const std::scoped_lock lock(mutex_);
    const auto& job = pending_ ? pending_ : (running_ ? running_ : last_);
    if (!job) return {};
    RenderStatus status = job->status;
    status.samplesPerPixel = static_cast<double>(status.counts[RayKind::Eye]) /
                             (static_cast<double>(job->settings.width) * job->settings.height);
    status.passProgress = status.phase == Phase::Finished
                              ? 1.0
                              : static_cast<double>(job->tilesDone) / static_cast<double>(job->tilesInAll);
    return status;
}

RenderStatus RenderSession::wait(std::chrono::milliseconds timeout) {
    {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, timeout, [&] { return !pending_ && !running_; });
    }
    return status();
}

std::vector<Tile> RenderSession::read(Picture& picture) const {
    std::shared_ptr<Film> film;
    {
        const std::scoped_lock lock(mutex_);
        if (!shown_) return {};
        film = shown_->film;
    }
    std::vector<Tile> tiles;
    for (const int index : film->read(picture)) tiles.push_back(film->tile(index));
    return tiles;
}

ColorImage RenderSession::image() const {
    std::shared_ptr<Job> job;
    {
        const std::scoped_lock lock(mutex_);
        job = shown_;
    }
    if (!job) return {};
    const std::scoped_lock lock(job->betweenPasses);
    return job->passes > 0 ? job->film->mean(job->passes) : ColorImage{};
}

ColorImage RenderSession::takeImage() {
    std::shared_ptr<Job> job;
    {
        const std::scoped_lock lock(mutex_);
        ENSURE(!pending_ && !running_);
        job = std::exchange(shown_, nullptr);
    }
    return job && job->passes > 0 ? job->film->takeMean(job->passes) : ColorImage{};
}

ColorImage RenderSession::sampleCounts() const {
    std::shared_ptr<Job> job;
    {
        const std::scoped_lock lock(mutex_);
        job = shown_;
    }
    if (!job) return {};
    const std::scoped_lock lock(job->betweenPasses);
    if (job->passes == 0) return {};
    ColorImage counts(job->settings.width, job->settings.height);
    std::ranges::transform(job->film->samples(job->passes), counts.values().begin(),
                           [](int samples) { return Color(static_cast<float>(samples)); });
    return counts;
}

/// The job whose picture is shown, if the pixel is in it.
std::shared_ptr<RenderSession::Job> RenderSession::shownAt(int x, int y) const {
    const std::scoped_lock lock(mutex_);
    const bool inside =
        shown_ && x >= 0 && y >= 0 && x < shown_->settings.width && y < shown_->settings.height;
    return inside ? shown_ : nullptr;
}

std::optional<FilmPixel> RenderSession::pixel(int x, int y) const {
    const auto job = shownAt(x, y);
    return job ? std::optional(job->film->pixel(x, y)) : std::nullopt;
}

std::shared_ptr<const World> RenderSession::shownWorld() const {
    const std::scoped_lock lock(mutex_);
    return shown_ ? shown_->context->world : nullptr;
}

std::optional<Retrace> RenderSession::retrace(int x, int y, int pass) const {
    const auto job = shownAt(x, y);
    if (!job) return std::nullopt;
    const FloatEnvironment environment;
    return job->integrator->retrace(*job->context, x, y, job->settings.firstPass + pass);
}

/// A film that no picture uses any more, or a new one.
std::shared_ptr<Film> RenderSession::freeFilm(int width, int height, bool eightBit) {
    std::erase_if(films_,
                  [&](const auto& film) { return film->width() != width || film->height() != height; });
    for (const auto& film : films_)
        if (film.use_count() == 1) {
            film->reset(eightBit);
            return film;
        }
    films_.push_back(std::make_shared<Film>(width, height));
    films_.back()->reset(eightBit);
    return films_.back();
}

void RenderSession::coordinate(const std::stop_token& end) {
    lowerThreadPriority();
    while (true) {
        std::shared_ptr<Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, end, [&] { return pending_ != nullptr; })) return;
            job = running_ = std::move(pending_);
            pending_ = nullptr;
        }
        std::string failure;
        try {
            run(job);
        } catch (const std::bad_alloc&) {
            failure = "rendering: there is not enough memory: choose a smaller picture or scene";
        } catch (const std::exception& error) {
            failure = error.what();
        }
        const std::scoped_lock lock(mutex_);
        if (!failure.empty()) {
            job->status.phase = Phase::Failed;
            job->status.failure = printable(failure, 400);
        } else if (job->cancelled) {
            job->status.phase = Phase::Idle;
        }
        last_ = std::move(running_);
        running_ = nullptr;
        changed_.notify_all();
    }
}

void RenderSession::run(const std::shared_ptr<Job>& job) {
    job->film =
        freeFilm(job->settings.width, job->settings.height, job->settings.trace.faults.has(Fault::EightBit));
    job->order = tilesFrom(*job->film, job->focus);
    job->tilesInAll = job->film->tiles();
    eyeHits_.begin(*job->context, job->settings, *job->film);
    const double seconds = secondsForCoarse(*job->context->world);
    traced_ = job->context->world;
    const bool fine = !job->settings.coarse || traceCoarse(*job, seconds) == CoarsePicture::kFinestStep;
    {
        const std::scoped_lock lock(mutex_);
        if (job->cancelled) return;
        shown_ = job;
        job->status.phase = Phase::Refining;
        job->status.secondsToCoarse = secondsSince(job->asked);
    }
    if (!fine) traceCoarse(*job, kInfinity);
    int pass = 0;
    while (!finished(*job) && waitWhileHeld(*job))
        if (tracePass(*job, pass)) ++pass;
}

/// What a coarse picture may take, beside the building of a new World.
double RenderSession::secondsForCoarse(const World& world) const {
    const double built = &world == traced_.get() ? 0 : world.buildSeconds;
    return std::max(kCoarseSeconds - built, kLeastCoarseSeconds);
}

/// The size of its blocks, or nothing if it was broken off.
std::optional<int> RenderSession::traceCoarse(Job& job, double seconds) {
    {
        const std::scoped_lock lock(mutex_);
        if (job.cancelled) return std::nullopt;
        job.stop = std::stop_source();
    }
    TraceContext context = *job.context;
    context.stop = job.stop.get_token();
    return coarse_.trace(pool_, job.order, seconds, context.stop, [&](int index, int step) {
        Tile tile = job.film->tile(index);
        tile.step = step;
        eyeHits_.lend(index, tile);
        const TileResult result = job.integrator->renderTile(context, tile, job.settings.firstPass);
        if (!result.complete) return;
        eyeHits_.takeBack(index, tile);
        job.film->preview(index, result);
    });
}

/// False if it was broken off; its finished tiles stay and need not be done again.
bool RenderSession::tracePass(Job& job, int pass) {
    const auto start = Clock::now();
    {
        const std::scoped_lock lock(mutex_);
        if (job.cancelled || paused_ || givesWay_) return false;
        job.inPass = true;
        job.stop = std::stop_source();
        job.tilesDone = 0;
    }
    TraceContext context = *job.context;
    context.stop = job.stop.get_token();
    const double before = job.status.seconds;
    const double limit = pass > 0 && job.settings.stop.seconds > 0 ? job.settings.stop.seconds : kInfinity;
    const bool whole = pool_.forEach(static_cast<int>(job.order.size()), context.stop, [&](int i) {
        const int index = job.order[static_cast<std::size_t>(i)];
        if (before + secondsSince(start) > limit) job.stop.request_stop();
        if (job.film->passes(index) <= pass) {
            const std::vector<std::uint8_t> wanted = job.film->wanted(index, pass);
            Tile tile = job.film->tile(index);
            tile.wanted = wanted;
            if (pass == 0) eyeHits_.lend(index, tile);
            const TileResult result =
                job.integrator->renderTile(context, tile, job.settings.firstPass + pass);
            if (!result.complete) return;
            if (pass == 0) eyeHits_.takeBack(index, tile);
            job.film->add(index, result, pass);
            const std::scoped_lock lock(mutex_);
            job.status.counts += result.counts;
            if (tile.hits.known) job.status.knownHits += result.radiance.size();
        }
        ++job.tilesDone;
    });
    const bool complete = whole && job.tilesDone == static_cast<int>(job.order.size());
    const std::scoped_lock between(job.betweenPasses);
    const std::scoped_lock lock(mutex_);
    job.inPass = false;
    job.status.seconds = before + secondsSince(start);
    if (complete) job.status.samples = job.passes = pass + 1;
    if (complete && pass == 0) job.status.secondsToFirstPass = secondsSince(job.asked);
    return complete;
}

/// False if the job was cancelled meanwhile.
bool RenderSession::waitWhileHeld(Job& job) {
    std::unique_lock lock(mutex_);
    while (!job.cancelled && (paused_ || givesWay_ || (holdAt_ > 0 && job.passes >= holdAt_))) {
        job.status.phase = paused_ ? Phase::Paused : Phase::Refining;
        changed_.wait(lock);
    }
    if (!job.cancelled) job.status.phase = Phase::Refining;
    return !job.cancelled;
}

bool RenderSession::finished(Job& job) {
    const StopSettings& stop = job.settings.stop;
    const int passes = job.passes;
    const auto finishedBy = [&](std::string reason) {
        const std::scoped_lock lock(mutex_);
        job.status.phase = Phase::Finished;
        job.status.finishedBy = std::move(reason);
        return true;
    };
    if (passes >= stop.samples)
        return finishedBy(fmt::format("{} sample{}", stop.samples, stop.samples == 1 ? "" : "s"));
    if (passes > 0 && stop.seconds > 0 && job.status.seconds >= stop.seconds)
        return finishedBy(fmt::format("{} s", stop.seconds));
    if (!accurate(job)) return false;
    return finishedBy(std::min(stop.error, job.status.estimatedError) <= kInvisibleError
                          ? "no visible error left"
                          : fmt::format("error below {}", stop.error));
}

/// Whether the error is what is asked; looks at it, and decides where to sample on, between some passes.
bool RenderSession::accurate(Job& job) {
    const StopSettings& stop = job.settings.stop;
    const int passes = job.passes;
    if (stop.error <= 0 || passes < kAdaptivePilot) return false;
    const bool decides = stop.adaptive && isAdaptiveStage(passes);
    if (decides) {
        const std::scoped_lock between(job.betweenPasses);
        decideSamples(*job.film, passes, stop.error, job.settings.display);
    }
    const bool ended = job.film->ended(passes);
    const bool looks =
        stop.adaptive ? decides || ended : passes >= kErrorPilot && passes % kErrorInterval == 0;
    if (!looks) return false;
    const double error = job.film->estimatedError(passes, job.settings.display);
    const std::scoped_lock lock(mutex_);
    job.status.estimatedError = error;
    return stop.adaptive ? ended : error <= stop.error;
}

}
