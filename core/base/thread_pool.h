#pragma once
// Threads that share one loop at a time.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace eyeray {

/// A fixed set of threads of lowered priority, all in the tracer's float environment (flush-to-zero, round to
/// nearest). `forEach` is called by one thread at a time.
class ThreadPool {
public:
    /// `threads` in all, the calling thread of forEach included; 0 means one per core.
    explicit ThreadPool(int threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return static_cast<int>(workers_.size()) + 1; }

    /// Calls body(index) once for each index in [0, count), in order of start, on all threads, and returns
    /// when all have ended. No further index starts once `stop` is requested or a call has thrown; the first
    /// exception is rethrown here. True if every index ran.
    bool forEach(int count, const std::stop_token& stop, const std::function<void(int)>& body);

private:
    struct Loop;
    void work(const std::stop_token& end);

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable done_;
    Loop* loop_ = nullptr;
    std::uint64_t loops_ = 0;
    int busy_ = 0;
    std::vector<std::jthread> workers_;
};

/// Puts this thread behind the one that made it, so that a window stays responsive.
void lowerThreadPriority();

/// Sets flush-to-zero, denormals-are-zero and round-to-nearest for this thread while it lives.
class FloatEnvironment {
public:
    FloatEnvironment();
    ~FloatEnvironment();
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
    unsigned saved_;
};

}
