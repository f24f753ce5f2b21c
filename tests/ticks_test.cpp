// labels: unit
#include "core/study/ticks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace eyeray;

namespace {

std::vector<std::string> labelsOf(const Axis& axis, int most) {
    std::vector<std::string> labels;
    for (const Tick& tick : ticksOf(axis, most))
        if (!tick.label.empty()) labels.push_back(tick.label);
    return labels;
}

using Labels = std::vector<std::string>;

}

TEST(Ticks, StandAtRoundNumbersOfALinearAxis) {
    EXPECT_EQ(labelsOf({Scale::Linear, 0, 1}, 6), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(labelsOf({Scale::Linear, -3, 47}, 6), (Labels{"0", "10", "20", "30", "40"}));
    EXPECT_EQ(labelsOf({Scale::Linear, -0.25, 0.25}, 6), (Labels{"-0.2", "-0.1", "0.0", "0.1", "0.2"}));
    EXPECT_EQ(labelsOf({Scale::Linear, 0, 3e6}, 4), (Labels{"0", "1.0·10⁶", "2.0·10⁶", "3.0·10⁶"}));
}

TEST(Ticks, StandAtPowersOfTenOfALogAxis) {
    EXPECT_EQ(labelsOf({Scale::Log, 1e-5, 10}, 8),
              (Labels{"10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1", "10"}));
    EXPECT_EQ(labelsOf({Scale::Log, 0.9, 60}, 8), (Labels{"1", "2", "5", "10", "20", "50"}));
    EXPECT_EQ(labelsOf({Scale::Log, 2.1, 2.9}, 5), (Labels{"2.2", "2.4", "2.6", "2.8"}));
    EXPECT_EQ(labelsOf({Scale::Log, 1e-12, 1e12}, 6), (Labels{"10⁻¹⁰", "10⁻⁵", "1", "10⁵", "10¹⁰"}));
}

TEST(Ticks, AreFewRoundAscendingAndOnTheAxisWhateverItIs) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-12, 12), width(-3, 3);
    for (int i = 0; i < 20000; ++i) {
        const bool log = i % 2 == 0;
        const double low = std::pow(10, exponent(random));
        const Axis axis{log ? Scale::Log : Scale::Linear, low, low * (1 + std::pow(10, width(random)))};
        const int most = 3 + i % 9;
        const std::vector<Tick> ticks = ticksOf(axis, most);
        int labelled = 0;
        for (std::size_t k = 0; k < ticks.size(); ++k) {
            labelled += ticks[k].label.empty() ? 0 : 1;
            EXPECT_GE(axis.share(ticks[k].value), -1e-6);
            EXPECT_LE(axis.share(ticks[k].value), 1 + 1e-6);
            if (k > 0) {
                EXPECT_GT(ticks[k].value, ticks[k - 1].value);
                EXPECT_TRUE(ticks[k].label.empty() || ticks[k].label != ticks[k - 1].label);
            }
        }
        ASSERT_LE(labelled, most) << axis.low << " … " << axis.high << " log " << log;
        ASSERT_GE(labelled, 1) << axis.low << " … " << axis.high << " log " << log << " most " << most;
    }
}

TEST(Axis, MapsItsEndsTo0And1AndBack) {
    const Axis log{Scale::Log, 0.01, 100}, linear{Scale::Linear, -2, 6};
    EXPECT_DOUBLE_EQ(log.share(0.01), 0);
    EXPECT_DOUBLE_EQ(log.share(1), 0.5);
    EXPECT_DOUBLE_EQ(log.share(100), 1);
    EXPECT_DOUBLE_EQ(linear.share(0), 0.25);
    for (const double share : {0.0, 0.3, 1.0}) {
        EXPECT_NEAR(log.share(log.valueAt(share)), share, 1e-12);
        EXPECT_NEAR(linear.share(linear.valueAt(share)), share, 1e-12);
    }
}

TEST(Axis, ShowsAllValuesThatItCan) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const std::vector<double> values = {0, -1, 1e-3, nan, 2, inf};
    const Axis log = axisAround(Scale::Log, values), linear = axisAround(Scale::Linear, values);
    EXPECT_GT(log.share(1e-3), 0.03);
    EXPECT_LT(log.share(2), 0.97);
    EXPECT_GT(linear.share(-1), 0.03);
    EXPECT_LT(linear.share(2), 0.97);
    for (const Scale scale : {Scale::Linear, Scale::Log})
        for (const std::vector<double>& few : {std::vector<double>{}, {5.0}, {7e-9, 7e-9}, {nan}, {0.0}}) {
            const Axis axis = axisAround(scale, few);
            ASSERT_LT(axis.low, axis.high);
            ASSERT_GE(ticksOf(axis, 6).size(), 2U);
        }
}

TEST(ShortNumber, ReadsLikeANumberInAText) {
    EXPECT_EQ(shortNumber(0), "0");
    EXPECT_EQ(shortNumber(1), "1.00");
    EXPECT_EQ(shortNumber(12.345), "12.3");
    EXPECT_EQ(shortNumber(-0.012345), "-0.0123");
    EXPECT_EQ(shortNumber(0.0099996), "0.0100");
    EXPECT_EQ(shortNumber(12345), "12300");
    EXPECT_EQ(shortNumber(123456), "1.23·10⁵");
    EXPECT_EQ(shortNumber(4.56e-7), "4.56·10⁻⁷");
    EXPECT_EQ(shortNumber(1e-12, 1), "10⁻¹²");
    EXPECT_EQ(shortNumber(std::numeric_limits<double>::infinity()), "∞");
    EXPECT_EQ(shortNumber(std::numeric_limits<double>::quiet_NaN()), "?");
}
