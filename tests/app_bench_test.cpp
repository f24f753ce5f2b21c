// labels: unit
// `eyeray bench` as a program; no test asks how fast anything is.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app_process.h"

namespace eyeray {
namespace {

class Bench : public testing::Test {
protected:
    Process start(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "bench");
        return {EYERAY_BINARY_DIR "/eyeray",
                std::move(arguments),
                folder.path(),
                {"HOME=" + folder.path().string()}};
    }

    TemporaryFolder folder;
};

TEST_F(Bench, TellsEachIndexKindAndNumberOfThreadsInJson) {
    Process bench = start({"homage", "--json", "--seconds", "0.1"});
    ASSERT_EQ(bench.wait(), 0) << bench.err();
    const auto list = nlohmann::json::parse(bench.out());
    std::set<std::string> kinds, indices;
    std::set<int> threads;
    for (const auto& figure : list) {
        for (const char* key : {"scene", "width", "height", "samples", "threads", "method", "seconds", "rays",
                                "mrays_per_second", "accelerator", "invalid_samples", "peak_rss_bytes"})
            EXPECT_TRUE(figure.contains(key)) << key;
        for (const char* key : {"load", "build", "first_image", "render", "spread"})
            EXPECT_TRUE(figure["seconds"].contains(key)) << key;
        const std::string kind = figure["kind"];
        for (const auto& [name, count] : figure["rays"].items())
            EXPECT_EQ(count.get<int>() > 0, name == kind) << name;
        EXPECT_GT(figure["mrays_per_second"], 0);
        for (const char* key : {"nodes", "boxes", "primitives"})
            EXPECT_GE(figure["per_ray"].at(key).get<double>(), 0) << key;
        EXPECT_EQ(figure["accelerator"]["primitives"], 4);
        kinds.insert(kind);
        indices.insert(figure["accelerator"]["kind"].get<std::string>());
        threads.insert(figure["threads"].get<int>());
    }
    EXPECT_EQ(kinds, (std::set<std::string>{"eye", "shadow", "reflection", "diffuse"}));
    EXPECT_EQ(indices, (std::set<std::string>{"brute", "bvh2", "bvh8"}));
    EXPECT_TRUE(threads.contains(1));
    EXPECT_EQ(list.size(), kinds.size() * indices.size() * threads.size());
}

TEST_F(Bench, TellsOnlyTheIndexAndThreadsThatAreAskedForAsATable) {
    Process bench = start({"homage", "--accel", "bvh2", "--threads", "2", "--seconds", "0.1"});
    ASSERT_EQ(bench.wait(), 0) << bench.err();
    EXPECT_EQ(bench.err(), "");
    EXPECT_EQ(bench.out().rfind("homage: 4 primitives", 0), 0U) << bench.out();
    EXPECT_NE(bench.out().find("\nbvh2           2 "), std::string::npos) << bench.out();
    EXPECT_EQ(bench.out().find("\nbvh8"), std::string::npos);
    EXPECT_EQ(bench.out().find("\nbrute"), std::string::npos);
}

TEST_F(Bench, EndsInOrderWhenInterrupted) {
    Process bench = start({"homage", "--json", "--seconds", "3000"});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    bench.interrupt();
    const int code = bench.wait();
    if (code == 128 + SIGINT) GTEST_SKIP() << "interrupted before it had begun";
    EXPECT_EQ(code, 0);
    EXPECT_TRUE(nlohmann::json::parse(bench.out()).is_array());
    EXPECT_EQ(std::ranges::count(bench.err(), '\n'), 1) << bench.err();
}

TEST_F(Bench, OfAWrongSceneOrOptionIsRefused) {
    EXPECT_EQ(start({"no-such-scene"}).wait(), 2);
    EXPECT_EQ(start({"homage", "--accel", "auto"}).wait(), 2);
    EXPECT_EQ(start({"homage", "--seconds", "-1"}).wait(), 2);
    EXPECT_EQ(start({"homage", "--threads", "0"}).wait(), 2);
}

}
}
