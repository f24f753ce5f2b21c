#pragma once
// Plays the tracing of the picked sample.

#include <chrono>
#include <optional>

#include "core/study/playback.h"

namespace eyeray {

class Player {
public:
    using Clock = std::chrono::steady_clock;

    /// Shows all rays at once again.
    void reset() { traced_.reset(), running_ = false; }
    /// The first step forward begins with the eye ray.
    void go(const SampleRecord&, PlayTo);
    /// Runs by itself, from the start if it stands at the end; or stands still.
    void run(const SampleRecord&, bool on, Clock::time_point now = Clock::now());
    bool running() const { return running_; }
    bool begun() const { return traced_.has_value(); }
    /// Takes the next step if it is time for it; true if it was.
    bool update(const SampleRecord&, Clock::time_point now = Clock::now());

    /// How many of the sample's rays are shown: all, until something is played.
    int shown(const SampleRecord&) const;

private:
    std::optional<int> traced_;
    bool running_ = false;
    Clock::time_point lastStep_;
};

}
