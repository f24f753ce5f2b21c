#pragma once
// Plays the tracing of the picked sample.

#include <optional>

#include "app/viewer/step_clock.h"
#include "core/study/playback.h"

namespace eyeray {

class Player {
public:
    using Clock = StepClock::Clock;

    /// Shows all rays at once again.
    void reset() { traced_.reset(), clock_.run(false); }
    /// The first step forward begins with the eye ray.
    void go(const SampleRecord&, PlayTo);
    /// Runs by itself, from the start if it stands at the end; or stands still.
    void run(const SampleRecord&, bool on, Clock::time_point now = Clock::now());
    bool running() const { return clock_.running(); }
    bool begun() const { return traced_.has_value(); }
    void setSpeed(double factor) { clock_.setSpeed(factor); }
    /// Takes the steps that it is time for; true if there was one.
    bool update(const SampleRecord&, Clock::time_point now = Clock::now());

    /// How many of the sample's rays are shown: all, until something is played.
    int shown(const SampleRecord&) const;

private:
    std::optional<int> traced_;
    StepClock clock_{0.7}; // time to see where a ray goes, and to say it
};

}
