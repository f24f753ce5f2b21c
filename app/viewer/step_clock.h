#pragma once
// Says when the next steps of something that is played are due.

#include <algorithm>
#include <chrono>
#include <cmath>

namespace eyeray {

class StepClock {
public:
    using Clock = std::chrono::steady_clock;

    /// One step in so many seconds at speed 1.
    explicit StepClock(double secondsPerStep) : secondsPerStep_(secondsPerStep) {}

    void run(bool on, Clock::time_point now = Clock::now()) { running_ = on, last_ = now; }
    bool running() const { return running_; }
    void setSpeed(double factor) { speed_ = factor; }
    double speed() const { return speed_; }

    /// Steps that are due since it last named any; not many at once after a wait.
    int due(Clock::time_point now) {
        constexpr double kLongest = 0.1; // seconds between two frames that are caught up with
        const double step = secondsPerStep_ / speed_;
        const double passed =
            std::min(std::chrono::duration<double>(now - last_).count(), std::max(step, kLongest));
        if (!running_ || passed < step) return 0;
        last_ = now;
        return static_cast<int>(passed / step);
    }

private:
    double secondsPerStep_, speed_ = 1;
    bool running_ = false;
    Clock::time_point last_;
};

}
