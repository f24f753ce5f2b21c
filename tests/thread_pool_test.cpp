// labels: unit threads
// The thread pool: each index once, stops, exceptions, storms, the float environment.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <xmmintrin.h>

#include <atomic>
#include <barrier>
#include <cfenv>
#include <numeric>
#include <set>

#include "core/base/errors.h"
#include "core/base/thread_pool.h"

namespace eyeray {
namespace {

class ThreadPools : public testing::TestWithParam<int> {
protected:
    ThreadPool pool_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Threads, ThreadPools, testing::Values(1, 2, 8));

TEST_P(ThreadPools, HaveTheirNumberOfThreads) { EXPECT_EQ(pool_.threads(), GetParam()); }

TEST_P(ThreadPools, RunEveryIndexOnce) {
    for (const int count : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
        EXPECT_TRUE(pool_.forEach(count, {}, [&](int i) { ++calls[static_cast<std::size_t>(i)]; }));
        for (const auto& n : calls) EXPECT_EQ(n, 1);
    }
}

TEST_P(ThreadPools, RunOneIndexOnEachThreadAtATime) {
    const int threads = GetParam();
    std::barrier allAreHere(threads); // would wait for ever if a thread stayed away
    std::mutex mutex;
    std::set<std::thread::id> ids;
    pool_.forEach(threads, {}, [&](int) {
        allAreHere.arrive_and_wait();
        const std::scoped_lock lock(mutex);
        ids.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(static_cast<int>(ids.size()), threads);
    EXPECT_TRUE(ids.contains(std::this_thread::get_id())) << "the caller works too";
}

TEST_P(ThreadPools, StartNothingOnceStopIsRequested) {
    const std::stop_source stop;
    stop.request_stop();
    std::atomic<int> calls = 0;
    EXPECT_FALSE(pool_.forEach(100, stop.get_token(), [&](int) { ++calls; }));
    EXPECT_EQ(calls, 0);
}

TEST_P(ThreadPools, AreWholeWhenTheLastIndexAsksForTheStop) {
    std::stop_source stop;
    EXPECT_TRUE(pool_.forEach(1, stop.get_token(), [&](int) { stop.request_stop(); }));
}

TEST_P(ThreadPools, RethrowAnExceptionAndGoOn) {
    for (int i = 0; i < 20; ++i)
        EXPECT_THROW(pool_.forEach(50, {},
                                   [](int index) {
                                       if (index % 10 == 3) throw Failure("a", "b", "c");
                                   }),
                     Failure);
    std::atomic<int> calls = 0;
    EXPECT_TRUE(pool_.forEach(10, {}, [&](int) { ++calls; }));
    EXPECT_EQ(calls, 10);
}

TEST_P(ThreadPools, SurviveAStormOfSmallLoops) {
    for (int loop = 0; loop < 5000; ++loop) {
        std::array<int, 3> values{}; // written by the threads, read by this one
        pool_.forEach(3, {}, [&](int i) {
            values[static_cast<std::size_t>(i)] = loop + i;
            std::this_thread::yield(); // lets the others in
        });
        ASSERT_EQ(std::accumulate(values.begin(), values.end(), 0), 3 * loop + 3);
    }
}

TEST_P(ThreadPools, CanBeStoppedAtAnyTime) {
    for (int round = 0; round < 200; ++round) {
        std::stop_source stop;
        std::atomic<int> calls = 0;
        const bool whole = pool_.forEach(100, stop.get_token(), [&](int i) {
            ++calls;
            if (i == round % 100) stop.request_stop();
        });
        EXPECT_EQ(whole, calls == 100);
        EXPECT_GT(calls, round % 100) << "indices start in order";
    }
}

TEST_P(ThreadPools, StandBehindTheCallerInPriority) {
    const std::thread::id caller = std::this_thread::get_id();
    const int callers = getpriority(PRIO_PROCESS, 0);
    std::barrier allAreHere(GetParam());
    std::atomic<int> wrong = 0;
    pool_.forEach(GetParam(), {}, [&](int) {
        allAreHere.arrive_and_wait();
        const int priority = getpriority(PRIO_PROCESS, 0), least = std::max(callers, 1);
        if (std::this_thread::get_id() == caller ? priority != callers : priority < least) ++wrong;
    });
    EXPECT_EQ(wrong, 0);
}

TEST_P(ThreadPools, TraceInOneFloatEnvironmentAndGiveTheCallersBack) {
    const unsigned before = _mm_getcsr();
    std::fesetround(FE_DOWNWARD);
    const unsigned callers = _mm_getcsr();
    std::barrier allAreHere(GetParam());
    std::atomic<int> wrong = 0;
    pool_.forEach(GetParam(), {}, [&](int) {
        allAreHere.arrive_and_wait();
        const volatile float smallest = std::numeric_limits<float>::min(), half = 0.5F, one = 1, third = 3;
        if (smallest * half != 0) ++wrong;          // flushed to zero
        if (one / third != 0x1.555556p-2F) ++wrong; // rounded to nearest; downwards it ends in …554
        const volatile float denormal = std::numeric_limits<float>::denorm_min(), large = 0x1p120F;
        if (denormal * large != 0) ++wrong; // read as zero
    });
    EXPECT_EQ(_mm_getcsr() & ~0x3fU, callers & ~0x3fU); // the lowest bits are sticky flags
    _mm_setcsr(before);
    EXPECT_EQ(wrong, 0);
}

TEST(ThreadPool, OneThreadRunsInOrderAndStopsAtOnce) {
    ThreadPool pool(1);
    std::vector<int> order;
    std::stop_source stop;
    EXPECT_FALSE(pool.forEach(100, stop.get_token(), [&](int i) {
        order.push_back(i);
        if (i == 5) stop.request_stop();
    }));
    EXPECT_EQ(order, (std::vector{0, 1, 2, 3, 4, 5}));
}

TEST(ThreadPool, OneThreadStopsAtTheFirstException) {
    ThreadPool pool(1);
    int calls = 0;
    EXPECT_THROW(pool.forEach(100, {},
                              [&](int i) {
                                  ++calls;
                                  if (i == 3) throw std::runtime_error("here");
                              }),
                 std::runtime_error);
    EXPECT_EQ(calls, 4);
}

TEST(ThreadPool, OfNoNumberHasOneThreadPerCore) {
    EXPECT_EQ(ThreadPool(0).threads(), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ThreadPool, RefusesSenselessNumbers) {
    EXPECT_THROW(ThreadPool(-1), InternalError);
    EXPECT_THROW(ThreadPool(1'000'000), InternalError);
}

TEST(FloatEnvironment, LastsForItsScope) {
    const unsigned before = _mm_getcsr();
    const volatile float smallest = std::numeric_limits<float>::min(), half = 0.5F;
    {
        const FloatEnvironment environment;
        EXPECT_EQ(smallest * half, 0.0F);
    }
    EXPECT_EQ(_mm_getcsr() & ~0x3fU, before & ~0x3fU);
    EXPECT_GT(smallest * half, 0.0F);
}

}
}
