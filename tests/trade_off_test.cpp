// labels: unit
// Pareto front, slopes and values read off measured curves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/study/log_fit.h"
#include "core/study/pareto.h"

using namespace eyeray;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool beats(const Cost& a, const Cost& b) {
    return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
}

}

TEST(ParetoFront, IsWhatBruteForceFindsThatNothingBeats) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        std::uniform_int_distribution<int> value(1, round % 2 == 0 ? 8 : 1000); // with ties, and hardly any
        std::vector<Cost> costs;
        costs.reserve(42);
        for (int i = 0; i < 40; ++i) costs.push_back({value(random) * 0.5, value(random) * 0.25});
        costs.push_back({kNan, 0});
        costs.push_back({0, std::numeric_limits<double>::infinity()});
        const std::vector<std::size_t> front = paretoFront(costs);
        for (std::size_t i = 0; i < costs.size(); ++i) {
            bool expected = std::isfinite(costs[i].time) && std::isfinite(costs[i].error);
            for (std::size_t k = 0; k < costs.size(); ++k) {
                expected = expected && !beats(costs[k], costs[i]);
                const bool twin = costs[k].time == costs[i].time && costs[k].error == costs[i].error;
                expected = expected && !(twin && k < i);
            }
            EXPECT_EQ(std::ranges::find(front, i) != front.end(), expected) << i;
        }
        for (std::size_t i = 1; i < front.size(); ++i)
            EXPECT_LT(costs[front[i - 1]].time, costs[front[i]].time);
    }
}

TEST(ParetoFront, OfNothingIsEmpty) { EXPECT_TRUE(paretoFront({}).empty()); }

TEST(FittedSlope, IsThePowerOfAPowerLaw) {
    const std::vector<double> x = {1, 4, 16, 64}, y = {0.8, 0.4, 0.2, 0.1};
    EXPECT_NEAR(*fittedSlope(x, y), -0.5, 1e-12);
    const std::vector<double> withGap = {0.8, kNan, 0.2, 0};
    EXPECT_NEAR(*fittedSlope(x, withGap), -0.5, 1e-12);
    EXPECT_FALSE(fittedSlope(std::vector{1.0, 1.0}, std::vector{2.0, 3.0}));
    EXPECT_FALSE(fittedSlope(std::vector{1.0, 2.0}, std::vector{0.0, 3.0}));
}

TEST(Interpolated, FollowsAPowerLawBetweenWhatWasMeasuredAndNotBeyond) {
    const std::vector<double> x = {1, 4, 100}, y = {1, 0.5, 0.1};
    for (const double at : {1.0, 1.7, 4.0, 33.0, 100.0})
        EXPECT_NEAR(*interpolated(x, y, at), 1 / std::sqrt(at), 1e-12);
    EXPECT_FALSE(interpolated(x, y, 0.9));
    EXPECT_FALSE(interpolated(x, y, 101));
}

TEST(FirstReach, IsWhereACurveComesDownToALevel) {
    const std::vector<double> x = {1, 4, 100}, y = {1, 0.5, 0.1};
    for (const double level : {1.0, 0.7, 0.5, 0.2, 0.1})
        EXPECT_NEAR(*firstReach(x, y, level), 1 / (level * level), 1e-9);
    EXPECT_FALSE(firstReach(x, y, 0.09));
    EXPECT_FALSE(firstReach(x, y, 2)) << "it may have been there before";
}
