// labels: unit
// The addressed sampler: stratification of the (0,2)-sequence, independence of neighbours, range.

#include <gtest/gtest.h>

#include "core/base/sampling.h"

namespace eyeray {
namespace {

constexpr auto kPurpose = SamplePurpose::PixelFilter;

TEST(ToUnitFloat, IsNeverOne) {
    EXPECT_EQ(toUnitFloat(0), 0.0F);
    EXPECT_EQ(toUnitFloat(0x80000000U), 0.5F);
    EXPECT_EQ(toUnitFloat(0xffffffffU), 1.0F - 0x1p-24F);
    EXPECT_LT(toUnitFloat(0xffffffffU), 1.0F);
}

TEST(Sobol2, StaysInTheUnitSquare) {
    for (std::uint32_t pass = 0; pass < 100'000; ++pass) {
        const Vec2 p = sobol2({pass % 7, pass * 13, pass * 29, pass}, pass % 5, kPurpose);
        ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << pass;
    }
}

/// Whether 2^k points hit each of the 2^k cells of every way to divide the square into 2^i × 2^(k−i) once.
bool isNetInBaseTwo(const std::vector<Vec2>& points, int k) {
    for (int i = 0; i <= k; ++i) {
        const auto columns = static_cast<float>(1 << i), rows = static_cast<float>(1 << (k - i));
        std::vector<bool> taken(points.size(), false);
        for (const Vec2& p : points) {
            const auto cell =
                static_cast<std::size_t>(std::floor(p.y * rows) * columns + std::floor(p.x * columns));
            if (taken[cell]) return false;
            taken[cell] = true;
        }
    }
    return true;
}

TEST(Sobol2, EveryAlignedRunOfAPowerOfTwoIsStratifiedInEveryWay) {
    for (int k = 0; k <= 10; ++k)
        for (std::uint32_t run = 0; run < 3; ++run)
            for (std::uint32_t pixel = 0; pixel < 4; ++pixel) {
                const std::uint32_t first = run << static_cast<std::uint32_t>(k);
                std::vector<Vec2> points(std::size_t{1} << static_cast<std::size_t>(k));
                for (std::uint32_t i = 0; i < points.size(); ++i)
                    points[i] = sobol2({pixel, 17 * pixel, 3, first + i}, 0, kPurpose);
                EXPECT_TRUE(isNetInBaseTwo(points, k)) << "2^" << k << " from " << first;
            }
}

/// Pearson's correlation of two equally long series.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sa += a[i];
        sb += b[i];
        saa += a[i] * a[i];
        sbb += b[i] * b[i];
        sab += a[i] * b[i];
    }
    const auto n = static_cast<double>(a.size());
    return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

/// Correlation of dimension 0 with dimension `other` of the sample whose address `change` makes.
template <class Change>
double correlationAcrossPixels(std::uint32_t pass, int other, Change&& change) {
    std::vector<double> here, there;
    for (std::uint32_t y = 0; y < 400; ++y)
        for (std::uint32_t x = 0; x < 400; ++x) {
            SampleAddress address{1, x, y, pass};
            here.push_back(sobol2(address, 0, kPurpose).x);
            change(address);
            there.push_back(sobol2(address, 0, kPurpose)[other]);
        }
    return correlation(here, there);
}

TEST(Sobol2, NeighbouringPixelsAndSeedsAreUncorrelated) {
    for (const std::uint32_t pass : {0U, 1U, 2U, 100U})
        for (const int other : {0, 1}) {
            const auto across = [&](auto&& change) { return correlationAcrossPixels(pass, other, change); };
            EXPECT_LT(std::fabs(across([](SampleAddress& a) { ++a.x; })), 0.01) << pass << other;
            EXPECT_LT(std::fabs(across([](SampleAddress& a) { ++a.y; })), 0.01) << pass << other;
            EXPECT_LT(std::fabs(across([](SampleAddress& a) {
                          std::swap(a.x, a.y);
                          ++a.x;
                      })),
                      0.01);
            EXPECT_LT(std::fabs(across([](SampleAddress& a) { ++a.seed; })), 0.01) << pass << other;
        }
}

TEST(Sobol2, NodesOfTheRayTreeAreUncorrelated) {
    std::vector<double> first, second;
    for (std::uint32_t x = 0; x < 160'000; ++x) {
        first.push_back(sobol2({1, x, 0, 0}, 1, kPurpose).x);
        second.push_back(sobol2({1, x, 0, 0}, 2, kPurpose).x);
    }
    EXPECT_LT(std::fabs(correlation(first, second)), 0.01);
}

TEST(PixelSample, FirstIsTheExactCentre) {
    for (std::uint32_t x = 0; x < 100; ++x) EXPECT_EQ(pixelSample({x, x, 2 * x, 0}), Vec2(0.5F));
}

TEST(PixelSample, LaterOnesAverageToTheCentreWithTheVarianceOfABox) {
    constexpr int kPasses = 4096;
    for (std::uint32_t x = 0; x < 8; ++x) {
        DVec2 sum(0), squares(0);
        for (std::uint32_t pass = 1; pass <= kPasses; ++pass) {
            const DVec2 p(pixelSample({0, x, 5, pass}));
            sum += p;
            squares += (p - 0.5) * (p - 0.5);
        }
        EXPECT_NEAR(sum.x / kPasses, 0.5, 5e-4);
        EXPECT_NEAR(sum.y / kPasses, 0.5, 5e-4);
        EXPECT_NEAR(squares.x / kPasses, 1.0 / 12, 2e-4);
        EXPECT_NEAR(squares.y / kPasses, 1.0 / 12, 2e-4);
    }
}

TEST(Samplers, StayInTheUnitSquareAndAreUniform) {
    for (const Sampler sampler : {Sampler::Independent, Sampler::Stratified, Sampler::Sobol}) {
        DVec2 sum(0), squares(0);
        double products = 0;
        constexpr int n = 100'000;
        for (std::uint32_t i = 0; i < n; ++i) {
            const Vec2 p = sample2(sampler, {3, i % 317, i / 317, i % 16}, i % 5, SamplePurpose::Lamp);
            ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << i;
            sum += DVec2(p);
            squares += DVec2(p * p);
            products += static_cast<double>(p.x) * p.y;
        }
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(sum[axis] / n, 0.5, 0.004);
            EXPECT_NEAR(squares[axis] / n, 1.0 / 3, 0.004);
        }
        EXPECT_NEAR(products / n, 0.25, 0.004);
    }
}

TEST(Samplers, StratifiedHasOneOfEachSixteenSamplesInEachCell) {
    for (std::uint32_t x = 0; x < 50; ++x)
        for (std::uint32_t round = 0; round < 3; ++round) {
            std::array<int, 16> cells{};
            for (std::uint32_t pass = 16 * round; pass < 16 * round + 16; ++pass) {
                const Vec2 p = sample2(Sampler::Stratified, {0, x, 9, pass}, 1, SamplePurpose::Direction);
                ++cells[static_cast<std::size_t>(p.x * 4) * 4 + static_cast<std::size_t>(p.y * 4)];
            }
            for (const int samples : cells) ASSERT_EQ(samples, 1) << x << " " << round;
        }
}

TEST(Samplers, StratifiedTakesTheCellsInManyOrders) {
    std::array<int, 16> firstCell{};
    for (std::uint32_t x = 0; x < 1600; ++x) {
        const Vec2 p = sample2(Sampler::Stratified, {0, x, 0, 0}, 1, SamplePurpose::Direction);
        ++firstCell[static_cast<std::size_t>(p.x * 4) * 4 + static_cast<std::size_t>(p.y * 4)];
    }
    for (const int count : firstCell) EXPECT_NEAR(count, 100, 45);
}

TEST(Sobol2, HasTheBitsOfItsDefinition) {
    // As first computed, with a loop over the direction numbers: pictures are to keep their bits.
    const Vec2 first = sobol2({0, 0, 0, 0}, 0, kPurpose), later = sobol2({7, 123, 45, 6789}, 99, kPurpose);
    EXPECT_EQ(first, Vec2(0x1.c33ebep-1F, 0x1.65cc04p-2F));
    EXPECT_EQ(later, Vec2(0x1.13f188p-3F, 0x1.0cf394p-1F));
}

TEST(Samplers, SobolIsTheSequenceOfThePixelFilter) {
    const SampleAddress address{1, 2, 3, 77};
    EXPECT_EQ(sample2(Sampler::Sobol, address, 0, SamplePurpose::PixelFilter), pixelSample(address));
}

}
}
