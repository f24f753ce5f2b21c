#pragma once
// One picture, pass after pass on the caller's time: for measuring.

#include <memory>
#include <stop_token>

#include "core/base/thread_pool.h"
#include "core/render/film.h"
#include "core/transport/integrator.h"

namespace eyeray {

class PassLoop {
public:
    /// The context's own stop is not heeded.
    PassLoop(std::shared_ptr<const Integrator>, const TraceContext&, ThreadPool&);

    /// Traces one sample more of every pixel. False, and nothing is added, if it is broken off: because
    /// tracing has taken `limitSeconds` in all, or by `stop`.
    bool pass(double limitSeconds, const std::stop_token& stop);

    int passes() const { return passes_; }
    /// Spent tracing.
    double seconds() const { return seconds_; }
    const RayCounts& counts() const { return counts_; }
    /// Mean over the passes; there is at least one.
    ColorImage picture() const { return film_.mean(passes_); }

private:
    std::shared_ptr<const Integrator> integrator_;
    TraceContext context_;
    ThreadPool& pool_;
    Film film_;
    int passes_ = 0;
    double seconds_ = 0;
    RayCounts counts_;
};

}
