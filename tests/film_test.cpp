// labels: unit
// The film: exact means, passes done again, what readers see, the error estimate.

#include <gtest/gtest.h>

#include "core/render/film.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

constexpr int kWidth = 70, kHeight = 40; // two whole tiles, and four cut ones

/// A result for a tile of the film, each pixel of which is value(x, y).
template <class Value>
TileResult result(const Film& film, int index, Value&& value) {
    TileResult tile{.tile = film.tile(index), .radiance = {}, .counts = {}, .complete = true};
    for (int y = tile.tile.y0; y < tile.tile.y1; ++y)
        for (int x = tile.tile.x0; x < tile.tile.x1; ++x) tile.radiance.push_back(value(x, y));
    return tile;
}

template <class Value>
void addPass(Film& film, int pass, Value&& value) {
    for (int i = 0; i < film.tiles(); ++i) film.add(i, result(film, i, value), pass);
}

/// Sample `pass` of a pixel: any number, the same for the same arguments.
Color sampleOf(int x, int y, int pass) {
    cases::Random random(static_cast<std::uint32_t>((pass * kHeight + y) * kWidth + x));
    return {random.uniform(0, 10), random.uniform(0, 1), random.uniform(0, 0.1)};
}

TEST(Film, TilesCoverEachPixelOnce) {
    const Film film(kWidth, kHeight);
    Pixels<int> covered(kWidth, kHeight, 0);
    for (int i = 0; i < film.tiles(); ++i) {
        const Tile tile = film.tile(i);
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) ++covered.at(x, y);
    }
    EXPECT_EQ(covered, Pixels<int>(kWidth, kHeight, 1));
}

TEST(Film, MeanIsTheMeanOfTheSamplesInDouble) {
    Film film(kWidth, kHeight);
    Picture picture;
    for (int passes = 1; passes <= 5; ++passes) {
        addPass(film, passes - 1, [&](int x, int y) { return sampleOf(x, y, passes - 1); });
        const ColorImage mean = film.mean(passes);
        film.read(picture);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                DVec3 sum(0);
                for (int pass = 0; pass < passes; ++pass) sum += DVec3(sampleOf(x, y, pass));
                ASSERT_EQ(mean.at(x, y), Color(sum / static_cast<double>(passes)));
                ASSERT_EQ(picture.radiance.at(x, y), mean.at(x, y));
            }
    }
}

TEST(Film, MeanThatIsTakenIsTheSameAndTheFilmCanBeUsedAgain) {
    Film film(kWidth, kHeight);
    for (const bool brokenOff : {false, true, false}) {
        film.reset();
        for (int pass = 0; pass < 2; ++pass)
            addPass(film, pass, [&](int x, int y) { return sampleOf(x, y, pass); });
        if (brokenOff) film.add(0, result(film, 0, [](int x, int y) { return sampleOf(x, y, 2); }), 2);
        const ColorImage mean = film.mean(2);
        EXPECT_EQ(film.takeMean(2), mean);
    }
}

TEST(Film, MeanOfWholePassesStaysReadableDuringTheNextOne) {
    Film film(kWidth, kHeight);
    for (int pass = 0; pass < 3; ++pass)
        addPass(film, pass, [&](int x, int y) { return sampleOf(x, y, pass); });
    const ColorImage whole = film.mean(3);
    for (const int begun : {0, 3, 1})
        film.add(begun, result(film, begun, [](int, int) { return Color(1000); }), 3);
    EXPECT_EQ(film.mean(3), whole);
    EXPECT_EQ(film.passes(3), 4);
    EXPECT_EQ(film.passes(2), 3);
}

TEST(Film, PassDoneAgainChangesNothing) {
    Film film(kWidth, kHeight);
    for (int pass = 0; pass < 4; ++pass) {
        addPass(film, pass, [&](int x, int y) { return sampleOf(x, y, pass); });
        const ColorImage once = film.mean(pass + 1);
        addPass(film, pass, [&](int x, int y) { return sampleOf(x, y, pass); });
        EXPECT_EQ(film.mean(pass + 1), once);
    }
}

TEST(Film, SmallSamplesAreNotLostAfterALargeOne) {
    Film film(1, 1);
    addPass(film, 0, [](int, int) { return Color(1e6F); });
    for (int pass = 1; pass <= 100'000; ++pass) addPass(film, pass, [](int, int) { return Color(0.01F); });
    EXPECT_NEAR(film.mean(100'001).at(0, 0).g, (1e6 + 1000) / 100'001, 1e-5);
}

TEST(Film, ReadingTellsWhatChanged) {
    Film film(kWidth, kHeight);
    Picture picture;
    EXPECT_EQ(static_cast<int>(film.read(picture).size()), film.tiles()) << "all is new to a new reader";
    EXPECT_TRUE(film.read(picture).empty());
    film.add(4, result(film, 4, [](int, int) { return Color(2); }), 0);
    EXPECT_EQ(film.read(picture), std::vector{4});
    EXPECT_EQ(picture.radiance.at(film.tile(4).x0, film.tile(4).y0), Color(2));
    EXPECT_TRUE(film.read(picture).empty());

    const Film other(kWidth, kHeight);
    EXPECT_EQ(static_cast<int>(other.read(picture).size()), other.tiles()) << "another film is all new";
    const Film wider(kWidth + 1, kHeight);
    wider.read(picture);
    EXPECT_EQ(picture.radiance.width(), kWidth + 1);
}

TEST(Film, PreviewFillsBlocksUntilTheFirstPass) {
    Film film(kWidth, kHeight);
    const int index = film.tiles() - 1; // 6 x 8 pixels: cut blocks of 4
    TileResult coarse{.tile = film.tile(index), .radiance = {}, .counts = {}};
    coarse.tile.step = 4;
    for (int block = 0; block < 4; ++block) coarse.radiance.emplace_back(block + 1);
    film.preview(index, coarse);
    Picture picture;
    film.read(picture);
    for (int y = coarse.tile.y0; y < coarse.tile.y1; ++y)
        for (int x = coarse.tile.x0; x < coarse.tile.x1; ++x) {
            const int block = (x - coarse.tile.x0) / 4 + 2 * ((y - coarse.tile.y0) / 4);
            EXPECT_EQ(picture.radiance.at(x, y), coarse.radiance[static_cast<std::size_t>(block)]);
        }

    film.add(index, result(film, index, [](int, int) { return Color(9); }), 0);
    film.preview(index, coarse);
    film.read(picture);
    EXPECT_EQ(picture.radiance.at(kWidth - 1, kHeight - 1), Color(9)) << "a late preview hides nothing";
    EXPECT_EQ(film.mean(1).at(kWidth - 1, kHeight - 1), Color(9)) << "nor is it counted";
}

TEST(Film, ResetForgetsAllPassesAndPictures) {
    Film film(kWidth, kHeight), fresh(kWidth, kHeight);
    for (int pass = 0; pass < 2; ++pass)
        addPass(film, pass, [&](int x, int y) { return sampleOf(x, y, pass); });
    Picture picture, blank;
    film.read(picture);
    film.reset();
    EXPECT_EQ(film.passes(0), 0);
    EXPECT_EQ(static_cast<int>(film.read(picture).size()), film.tiles());
    fresh.read(blank);
    EXPECT_EQ(picture.radiance, blank.radiance);
    addPass(film, 0, [](int x, int y) { return sampleOf(x, y, 0); });
    addPass(fresh, 0, [](int x, int y) { return sampleOf(x, y, 0); });
    EXPECT_EQ(film.mean(1), fresh.mean(1));
}

constexpr double kGrey = 0.3;
const DisplaySettings kLinear{.exposure = 0, .toneMap = ToneMap::None}; // its slope is 1

/// Grey samples around kGrey that alternate between −spread(tile) and +spread(tile).
template <class Spread>
void addAlternating(Film& film, int passes, Spread&& spread) {
    for (int pass = 0; pass < passes; ++pass)
        for (int i = 0; i < film.tiles(); ++i) {
            const double value = kGrey + (pass % 2 == 0 ? -1 : 1) * spread(i);
            film.add(i, result(film, i, [&](int, int) { return Color(static_cast<float>(value)); }), pass);
        }
}

TEST(EstimatedError, IsTheStandardErrorOfTheWorstTile) {
    constexpr int kPasses = 16;
    Film film(kWidth, kHeight);
    addAlternating(film, kPasses, [](int tile) { return 0.01 * (tile == 2 ? 3 : 1); });
    // Sample variance of ±s is s²·n/(n − 1); the mean's is that over n.
    EXPECT_NEAR(film.estimatedError(kPasses, kLinear), 0.03 / std::sqrt(kPasses - 1.0), 1e-6);
}

TEST(EstimatedError, IsAnAverageOverTheTile) {
    constexpr int kPasses = 16;
    Film film(kTileSize, kTileSize); // half of its pixels know their value
    for (int pass = 0; pass < kPasses; ++pass)
        addPass(film, pass,
                [&](int x, int) { return Color(x % 2 == 0 ? 0.25F : (pass % 2 == 0 ? 0.2F : 0.3F)); });
    EXPECT_NEAR(film.estimatedError(kPasses, kLinear), 0.05 / std::sqrt(2.0 * (kPasses - 1)), 1e-6);
}

TEST(EstimatedError, CountsAsMuchAsTheScreenShows) {
    constexpr int kPasses = 20;
    Film film(kWidth, kHeight);
    addAlternating(film, kPasses, [](int) { return 0.01; });
    const DisplaySettings srgb;
    const double slope = displaySlope(static_cast<float>(kGrey), srgb);
    EXPECT_NEAR(film.estimatedError(kPasses, srgb), slope * 0.01 / std::sqrt(kPasses - 1.0), 1e-6);
    EXPECT_EQ(film.estimatedError(kPasses, {.exposure = 4, .toneMap = ToneMap::Clamp}), 0)
        << "white is white";
}

TEST(EstimatedError, OfAPictureWithoutNoiseIsZero) {
    for (const float value : {0.1F, 0.7F, 3.3F, 1e4F}) {
        Film film(kTileSize, kTileSize);
        for (int pass = 0; pass < 64; ++pass)
            addPass(film, pass, [&](int, int) { return Color(value, 1, 0.3F); });
        for (const double exposure : {0.0, -12.0})
            EXPECT_EQ(film.estimatedError(64, {.exposure = exposure}), 0) << value;
    }
}

TEST(EstimatedError, SeesNoiseInTheLastDigits) {
    constexpr int kPasses = 16;
    Film film(kTileSize, kTileSize);
    addAlternating(film, kPasses, [](int) { return 0x1p-16; });
    EXPECT_NEAR(film.estimatedError(kPasses, kLinear), 0x1p-16 / std::sqrt(kPasses - 1.0), 1e-9);
}

TEST(EstimatedError, OfRandomSamplesAgreesWithManyTrials) {
    constexpr int kPasses = 64;
    Film film(kTileSize, kTileSize); // each pixel is a trial
    for (int pass = 0; pass < kPasses; ++pass)
        addPass(film, pass, [&](int x, int y) { return Color(0.5F * sampleOf(x, y, pass).g); });
    const ColorImage mean = film.mean(kPasses);
    double squares = 0;
    for (const Color& c : mean.values()) squares += (c.g - 0.25) * (c.g - 0.25);
    const double observed = std::sqrt(squares / static_cast<double>(mean.values().size()));
    EXPECT_NEAR(film.estimatedError(kPasses, kLinear), observed, 0.07 * observed);
    EXPECT_NEAR(observed, 0.5 / std::sqrt(12.0 * kPasses), 0.07 * observed);
}

}
}
