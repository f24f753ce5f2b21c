#include "core/study/pass_loop.h"

#include <chrono>
#include <vector>

namespace eyeray {

PassLoop::PassLoop(std::shared_ptr<const Integrator> integrator, const TraceContext& context,
                   ThreadPool& pool)
    : integrator_(std::move(integrator)), context_(context), pool_(pool),
      film_(context.width, context.height) {}

bool PassLoop::pass(double limitSeconds, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [&] {
        return seconds_ + std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::stop_source broken;
    const std::stop_callback forward(stop, [&] { broken.request_stop(); });
    context_.stop = broken.get_token();
    std::vector<TileResult> results(static_cast<std::size_t>(film_.tiles()));
    const bool started = pool_.forEach(film_.tiles(), context_.stop, [&](int i) {
        if (elapsed() > limitSeconds) broken.request_stop();
        results[static_cast<std::size_t>(i)] = integrator_->renderTile(context_, film_.tile(i), passes_);
    });
    seconds_ = elapsed();
    if (!started || broken.stop_requested()) return false;
    for (int i = 0; i < film_.tiles(); ++i) {
        const TileResult& result = results[static_cast<std::size_t>(i)];
        film_.add(i, result, passes_);
        counts_ += result.counts;
    }
    ++passes_;
    return true;
}

}
