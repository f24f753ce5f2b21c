// labels: unit threads
// Coarse pictures: the block size by the time there is.

#include "core/render/coarse_picture.h"

#include <gtest/gtest.h>

#include <mutex>
#include <numeric>
#include <thread>

#include "core/base/math.h"

namespace eyeray {
namespace {

constexpr std::size_t kTiles = 100;

/// The step with which each tile was traced last, 0 if it was not.
class Traced {
public:
    std::optional<int> trace(double seconds) {
        return trace(seconds, [](int) {});
    }
    std::optional<int> trace(double seconds, const std::function<void(int step)>& tile) {
        last_.assign(kTiles, 0);
        calls_ = 0;
        std::vector<int> tiles(kTiles);
        std::iota(tiles.begin(), tiles.end(), 0);
        return coarse_.trace(pool_, tiles, seconds, stop.get_token(), [&](int index, int step) {
            tile(step);
            const std::scoped_lock lock(mutex_);
            last_[static_cast<std::size_t>(index)] = step;
            ++calls_;
        });
    }
    const std::vector<int>& last() const { return last_; }
    std::size_t calls() const { return calls_; }

    std::stop_source stop;

private:
    ThreadPool pool_{2};
    CoarsePicture coarse_;
    std::mutex mutex_;
    std::vector<int> last_;
    std::size_t calls_ = 0;
};

std::vector<int> allOf(int step) { return std::vector<int>(kTiles, step); }

TEST(CoarsePicture, WithTimeEnoughHasTheFinestBlocks) {
    Traced traced;
    const std::optional<int> first = traced.trace(kInfinity), second = traced.trace(kInfinity);
    EXPECT_EQ(first, CoarsePicture::kFinestStep);
    EXPECT_EQ(second, CoarsePicture::kFinestStep);
    EXPECT_EQ(traced.last(), allOf(CoarsePicture::kFinestStep));
    EXPECT_EQ(traced.calls(), kTiles) << "no tile twice";
}

TEST(CoarsePicture, WithNoTimeLeftHasTheCoarsestBlocks) {
    Traced traced;
    const std::optional<int> first = traced.trace(-1), second = traced.trace(-1);
    EXPECT_EQ(first, CoarsePicture::kCoarsestStep);
    EXPECT_EQ(second, CoarsePicture::kCoarsestStep);
    EXPECT_EQ(traced.last(), allOf(CoarsePicture::kCoarsestStep));
}

TEST(CoarsePicture, ThatIsSuddenlySlowIsCoarserAtOnce) {
    Traced traced;
    const std::optional<int> fast = traced.trace(10);
    ASSERT_EQ(fast, CoarsePicture::kFinestStep);
    // 800 ms by two threads with the finest blocks, if the tiles take as long as this at least
    const auto slow = [](int step) {
        std::this_thread::sleep_for(std::chrono::milliseconds(256 / (step * step)));
    };
    const std::optional<int> step = traced.trace(0.2, slow);
    ASSERT_TRUE(step.has_value());
    EXPECT_GT(*step, CoarsePicture::kFinestStep);
    EXPECT_EQ(traced.last(), allOf(*step));
}

TEST(CoarsePicture, ThatIsBrokenOffHasNoStep) {
    Traced traced;
    EXPECT_FALSE(traced.trace(kInfinity, [&](int) { traced.stop.request_stop(); }).has_value());
}

}
}
