// labels: unit
// What is said of photons.

#include <gtest/gtest.h>

#include "core/study/photon_text.h"

namespace eyeray {
namespace {

constexpr std::uint64_t kPixels = 640ULL * 480;

TEST(PhotonText, TellsTimesInUnitsThatPeopleUse) {
    EXPECT_EQ(durationText(0.42), "0.42 s");
    EXPECT_EQ(durationText(90), "90 s");
    EXPECT_EQ(durationText(120), "2 minutes");
    EXPECT_EQ(durationText(5 * 3600.0), "5 hours");
    EXPECT_EQ(durationText(41.2 * 86400), "41 days");
    EXPECT_EQ(durationText(365.25 * 86400 * 2345), "2 300 years");
    EXPECT_EQ(durationText(365.25 * 86400 * 4.7e6), "4.7 million years");
    EXPECT_EQ(durationText(0), "0 s");
}

TEST(PhotonText, TellsHowRareItIsToReachTheLens) {
    EXPECT_EQ(rarityText(3, 250000), "1 in 83 000");
    EXPECT_EQ(rarityText(0, 1200), "none of 1 200");
    EXPECT_EQ(rarityText(1, 2), "1 in 2");
}

// The lectures' numbers: a lens of 1 mm at 1 m takes 2.5e-7; one photon a pixel at 640x480 needs 1.2e12.
TEST(PhotonText, ForetellsTheTimeOfOnePhotonAPixel) {
    PhotonTally tally;
    EXPECT_EQ(forecastText(tally, kPixels, 0), "no photon has left yet");
    tally.emitted = 40'000'000;
    tally.reached = 10;
    EXPECT_EQ(forecastText(tally, kPixels, 40),
              "not one has come into the picture yet: one photon a pixel takes more than 140 days");
    tally.onPicture = 10; // a million a second: 1.2e12 photons take 1.2e6 s
    EXPECT_EQ(forecastText(tally, kPixels, 40),
              "at this rate a picture with one photon a pixel takes 14 days");
}

}
}
