#pragma once
// Plays how a picture of few pixels is traced, pixel by pixel.

#include <functional>
#include <optional>
#include <vector>

#include "app/viewer/step_clock.h"
#include "core/study/pixel_grid.h"
#include "core/study/playback.h"
#include "core/transport/integrator.h"

namespace eyeray {

/// One pixel of the coarse picture.
struct GridPixel {
    Color radiance{0};
    std::size_t rays = 0; // of its sample
};

/// Used by one thread.
class GridPlayer {
public:
    using Clock = StepClock::Clock;
    /// The sample of a pixel of the picture; nothing as long as there is no picture.
    using Trace = std::function<std::optional<Retrace>(int x, int y)>;

    /// Begins with no pixel traced.
    void begin(const PixelGrid&);
    void end() { on_ = false, clock_.run(false); }
    bool on() const { return on_; }

    const PixelGrid& grid() const { return grid_; }
    /// Those traced so far, in order; fewer than played for as long as there is no picture.
    const std::vector<GridPixel>& traced() const { return traced_; }
    /// The last cell played; nothing before the first.
    std::optional<int> current() const;
    std::size_t rays() const; // of all traced

    /// One pixel back or on, on to the next whose rays hit something or go to a lamp, or to either end.
    void go(PlayTo, const Trace&);
    /// Plays on, or goes back, until so many cells are played.
    void goTo(int cells, const Trace&);
    /// Traces all so far again, of another picture.
    void retrace(const PixelGrid&, const Trace&);

    /// Runs by itself, from the start if it stands at the end; or stands still.
    void run(bool on, Clock::time_point now = Clock::now());
    bool running() const { return clock_.running(); }
    void setSpeed(double factor) { clock_.setSpeed(factor); }
    double speed() const { return clock_.speed(); }
    /// Takes the steps that it is time for; true if there is a pixel more or less.
    bool update(const Trace&, Clock::time_point now = Clock::now());

private:
    std::optional<Retrace> traceNext(const Trace&);
    bool catchUp(const Trace&);

    bool on_ = false;
    PixelGrid grid_;
    int played_ = 0; // cells
    std::vector<GridPixel> traced_;
    StepClock clock_{0.125};
};

}
