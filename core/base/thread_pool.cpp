#include "core/base/thread_pool.h"

#include <sys/resource.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <exception>

#include "core/base/errors.h"

namespace eyeray {
namespace {
constexpr int kTracingNice = 5; // above the UI thread's
constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040, kRoundingMask = 0x6000;
}

void lowerThreadPriority() {
    const int own = getpriority(PRIO_PROCESS, 0); // on Linux this means the calling thread
    setpriority(PRIO_PROCESS, 0, own + kTracingNice);
}

FloatEnvironment::FloatEnvironment() : saved_(_mm_getcsr()) {
    _mm_setcsr((saved_ & ~kRoundingMask) | kFlushToZero | kDenormalsAreZero);
}
FloatEnvironment::~FloatEnvironment() { _mm_setcsr(saved_); }

struct ThreadPool::Loop {
    int count;
    const std::stop_token& stop;
    const std::function<void(int)>& body;
    std::atomic<int> next = 0;
    std::atomic<int> ended = 0;
    std::atomic<bool> failed = false;
    std::exception_ptr error;

    void run() {
        while (!stop.stop_requested() && !failed.load(std::memory_order_relaxed)) {
            const int index = next.fetch_add(1, std::memory_order_relaxed);
            if (index >= count) return;
            try {
                body(index);
            } catch (...) {
                if (!failed.exchange(true)) error = std::current_exception();
                return;
            }
            ended.fetch_add(1, std::memory_order_relaxed);
        }
    }
};

ThreadPool::ThreadPool(int threads) {
    ENSURE(threads >= 0 && threads <= 1024);
    const int count =
        threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (int i = 1; i < count; ++i) workers_.emplace_back([this](const std::stop_token& end) { work(end); });
}

ThreadPool::~ThreadPool() {
    for (auto& worker : workers_) worker.request_stop();
}

void ThreadPool::work(const std::stop_token& end) {
    lowerThreadPriority();
    const FloatEnvironment environment;
    std::uint64_t seen = 0;
    while (true) {
        Loop* loop = nullptr;
        {
            std::unique_lock lock(mutex_);
            if (!wake_.wait(lock, end, [&] { return loop_ != nullptr && loops_ != seen; })) return;
            seen = loops_;
            loop = loop_;
            ++busy_;
        }
        loop->run();
        const std::scoped_lock lock(mutex_);
        if (--busy_ == 0) done_.notify_all();
    }
}

bool ThreadPool::forEach(int count, const std::stop_token& stop, const std::function<void(int)>& body) {
    Loop loop{.count = count, .stop = stop, .body = body, .error = {}};
    {
        const std::scoped_lock lock(mutex_);
        loop_ = &loop;
        ++loops_;
    }
    wake_.notify_all();
    {
        const FloatEnvironment environment;
        loop.run();
    }
    {
        std::unique_lock lock(mutex_);
        loop_ = nullptr;
        done_.wait(lock, [&] { return busy_ == 0; });
    }
    if (loop.error) std::rethrow_exception(loop.error);
    return loop.ended == count;
}

}
