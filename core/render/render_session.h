#pragma once
// A picture that refines in the background until it is good enough, and starts anew at every change.

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/thread_pool.h"
#include "core/render/coarse_picture.h"
#include "core/render/eye_hits.h"
#include "core/render/film.h"
#include "core/render/render_settings.h"
#include "core/scene/camera.h"
#include "core/scene/world.h"
#include "core/transport/integrator.h"

namespace eyeray {

struct RenderStatus {
    enum class Phase : std::uint8_t { Idle, Coarse, Refining, Paused, Finished, Failed } phase = Phase::Idle;
    int samples = 0;               // whole passes: the most samples of a pixel
    double samplesPerPixel = 0;    // on average, with those of the pass under way
    double passProgress = 0;       // of the pass under way, 0 to 1
    double seconds = 0;            // spent tracing this picture, pauses left out
    double secondsToCoarse = 0;    // from start() to a whole coarse picture; 0 until there is one
    double secondsToFirstPass = 0; // from start() to one sample in every pixel
    double estimatedError = -1;    // Film::estimatedError when last looked at; −1: not yet
    RayCounts counts;              // of the passes, the coarse picture left out
    std::uint64_t knownHits = 0;   // of the eye rays in `counts`: EyeHits had them, and none was traced
    std::string finishedBy;        // which of the stop conditions ended it: "256 samples"
    std::string failure;           // one line, when it has failed
    int threads = 1;

    bool active() const { return phase == Phase::Coarse || phase == Phase::Refining; }
    double mraysPerSecond() const; // of those that were traced
};

/// All functions are called by one thread (the user interface) and never wait for tracing, unless they say
/// so.
class RenderSession {
public:
    /// `threads` that trace; 0: one per core.
    explicit RenderSession(int threads = 0);
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    /// Drops what is being traced and starts a new picture: coarse blocks, then one sample per pixel and
    /// pass. What read() shows stays until the coarse picture is whole.
    void start(std::shared_ptr<const World>, const Camera&, const RenderSettings&);

    /// Stops tracing and waits until the threads are idle: a few milliseconds. The picture stays, with its
    /// whole passes.
    void stop();

    void pause();
    void resume();

    /// Waits at `samples` whole passes, of this picture and those to come, until told otherwise; 0: nowhere.
    /// Two sessions that are to be compared are led from number to number so.
    void holdAt(int samples);

    /// Leaves all cores to others, as to the building of a World, until goOn() or the next start(). The
    /// picture shown stays; coarse ones are still traced.
    void giveWay();
    void goOn();

    /// Tiles near this pixel come first, from the next picture on; by default those in the middle.
    void setFocus(DVec2 pixel) { focus_ = pixel; }
    void clearFocus() { focus_ = DVec2(-1); }

    RenderStatus status() const;

    /// Waits until tracing has ended or for `timeout`.
    RenderStatus wait(std::chrono::milliseconds timeout);

    /// Brings `picture` up to date; returns the tiles that changed.
    std::vector<Tile> read(Picture& picture) const;

    /// What the picture that read() shows is of; null if there is none.
    std::shared_ptr<const World> shownWorld() const;

    /// Mean of the whole passes; empty if there is none.
    ColorImage image() const;

    /// The same without a copy, once the session has been stopped: it has no picture from then on.
    ColorImage takeImage();

    /// How many samples each pixel has after the whole passes, in all channels; empty if there is none.
    ColorImage sampleCounts() const;

    /// What the film of the picture shown holds for a pixel. Nothing if there is no picture or the pixel is
    /// outside.
    std::optional<FilmPixel> pixel(int x, int y) const;

    /// One sample of the picture shown, traced again with its rays on record. Nothing if there is no picture
    /// or the pixel is outside.
    std::optional<Retrace> retrace(int x, int y, int pass) const;

private:
    struct Job;
    std::shared_ptr<Job> shownAt(int x, int y) const;
    void coordinate(const std::stop_token& end);
    void run(const std::shared_ptr<Job>&);
    double secondsForCoarse(const World&) const;
    std::optional<int> traceCoarse(Job&, double seconds);
    bool tracePass(Job&, int pass);
    bool waitWhileHeld(Job&);
    bool finished(Job&);
    bool accurate(Job&);
    std::shared_ptr<Film> freeFilm(int width, int height, bool eightBit);

    ThreadPool pool_;
    DVec2 focus_{-1};

    std::vector<std::shared_ptr<Film>> films_; // of the coordinator alone
    std::shared_ptr<const World> traced_;      // likewise: of the picture before
    EyeHits eyeHits_;                          // likewise, but for hits of tiles under way
    CoarsePicture coarse_;                     // likewise

    mutable std::mutex mutex_; // of all below
    std::condition_variable_any changed_;
    std::shared_ptr<Job> pending_, running_; // to be traced next, being traced
    std::shared_ptr<Job> shown_, last_;      // whose picture read() shows; the last that ended
    bool paused_ = false, givesWay_ = false;
    int holdAt_ = 0;

    std::jthread coordinator_;
};

}
