#pragma once
// One piece of work off the calling thread; a new one replaces the old.

#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace eyeray {

/// Used by one thread. Work that is replaced is told to stop and its result dropped; nobody waits for it but
/// the destructor.
template <class Result>
class BackgroundJob {
public:
    /// `work(std::stop_token)` gives the Result or throws.
    template <class Work>
    void start(Work work) {
        cancel();
        std::promise<Result> promise;
        current_.result = promise.get_future();
        current_.thread = std::jthread(
            [work = std::move(work), promise = std::move(promise)](const std::stop_token& stop) mutable {
                try {
                    promise.set_value(work(stop));
                } catch (...) {
                    promise.set_exception(std::current_exception());
                }
            });
    }

    /// Forgets the work under way.
    void cancel() {
        std::erase_if(dropped_, [](const Run& run) { return ready(run); });
        if (!running()) return;
        current_.thread.request_stop();
        dropped_.push_back(std::move(current_));
        current_ = {};
    }

    bool running() const { return current_.result.valid(); }
    void wait() const {
        if (running()) current_.result.wait();
    }

    /// The result, once it is there: nothing until then. Rethrows what the work has thrown.
    std::optional<Result> take() {
        if (!running() || !ready(current_)) return std::nullopt;
        return current_.result.get();
    }

private:
    struct Run {
        std::future<Result> result;
        std::jthread thread;
    };
    static bool ready(const Run& run) {
        return run.result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }

    Run current_;
    std::vector<Run> dropped_;
};

}
