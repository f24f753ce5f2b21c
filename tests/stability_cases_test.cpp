// labels: unit robustness
// The cases of `eyeray stability`: the renderer's form keeps to every mark, and the forms as taught fail by
// about as much as is known of them, which shows that each case can fail.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/study/stability.h"

namespace eyeray {

void PrintTo(const StabilityCase& subject, std::ostream* out) { *out << subject.id << " " << subject.title; }

namespace {

constexpr int kTrials = 20'000;

const StabilityCase& caseOf(std::string_view id) {
    for (const StabilityCase& subject : stabilityCases())
        if (subject.id == id) return subject;
    throw std::out_of_range(std::string(id));
}

/// One form at one value, which need not be in the sweep.
Measured measured(std::string_view id, double parameter, Form form) {
    const auto forms = caseOf(id).measure(parameter, {.trials = kTrials, .timed = false, .stop = {}});
    return forms[static_cast<std::size_t>(form)].value();
}
double failures(std::string_view id, double parameter, Form form = Form::NaiveFloat) {
    return measured(id, parameter, form).failuresPerMillion * 1e-6;
}
double error(std::string_view id, double parameter, Form form = Form::NaiveFloat) {
    return measured(id, parameter, form).error;
}

class EachStabilityCase : public testing::TestWithParam<StabilityCase> {};

TEST_P(EachStabilityCase, HasARobustFormThatKeepsToItsMark) {
    const StabilityCase& subject = GetParam();
    const StabilityResult result = measureCase(subject, {.trials = kTrials, .timed = false, .stop = {}});
    ASSERT_EQ(result.points.size(), subject.sweep.size());
    const auto robust = result.worst(Form::Robust);
    ASSERT_TRUE(robust);
    EXPECT_LE(robust->error, subject.mark.error);
    EXPECT_LE(robust->failuresPerMillion, subject.mark.failuresPerMillion);
    EXPECT_TRUE(result.passes());
}

TEST_P(EachStabilityCase, HasAFormAsTaughtThatMissesTheMark) {
    const StabilityCase& subject = GetParam();
    const auto naive =
        measureCase(subject, {.trials = kTrials, .timed = false, .stop = {}}).worst(Form::NaiveFloat);
    ASSERT_TRUE(naive);
    EXPECT_TRUE(naive->error > 10 * subject.mark.error ||
                naive->failuresPerMillion > subject.mark.failuresPerMillion + 1000);
}

TEST_P(EachStabilityCase, IsTheSameInEveryRun) {
    const StabilityCase& subject = GetParam();
    const double middle = subject.sweep[subject.sweep.size() / 2];
    const StabilityEffort effort{.trials = 1000, .timed = false, .stop = {}};
    const MeasuredForms first = subject.measure(middle, effort), second = subject.measure(middle, effort);
    for (std::size_t form = 0; form < first.size(); ++form) {
        ASSERT_EQ(first[form].has_value(), second[form].has_value());
        if (!first[form]) continue;
        EXPECT_EQ(first[form]->error, second[form]->error);
        EXPECT_EQ(first[form]->failuresPerMillion, second[form]->failuresPerMillion);
    }
}

INSTANTIATE_TEST_SUITE_P(All, EachStabilityCase, testing::ValuesIn(stabilityCases()),
                         [](const auto& named) { return std::string(named.param.id); });

TEST(StabilityCases, AreInOrderAndSayWhatTheyShow) {
    std::string_view last;
    for (const StabilityCase& subject : stabilityCases()) {
        EXPECT_LT(last, subject.id);
        last = subject.id;
        for (const std::string_view text :
             {subject.title, subject.why, subject.fix, subject.parameter, subject.error, subject.failure})
            EXPECT_FALSE(text.empty()) << subject.id;
        EXPECT_TRUE(std::ranges::is_sorted(subject.sweep)) << subject.id;
        EXPECT_GE(subject.sweep.size(), 5U) << subject.id;
    }
    EXPECT_GE(stabilityCases().size(), 60U);
}

TEST(StabilityCases, EndWhenAskedTo) {
    const std::stop_source stop;
    stop.request_stop();
    const StabilityResult result = measureCase(caseOf("F01"), {.trials = kTrials, .stop = stop.get_token()});
    EXPECT_TRUE(result.points.empty());
    EXPECT_FALSE(result.worst(Form::Robust));
}

TEST(StabilityCases, TellWhatTheRobustFormCosts) {
    const StabilityCase& subject = caseOf("F01");
    StabilityResult result{&subject, {}};
    const auto at = [&](double naive, double failing, double robust) {
        result.points.push_back({1, {Measured{0, failing, naive}, std::nullopt, Measured{0, 0, robust}}});
    };
    EXPECT_FALSE(result.cost(Form::NaiveFloat));
    at(1, 500, 9);
    EXPECT_EQ(result.cost(Form::NaiveFloat), 9) << "where it always fails";
    at(2, 0, 4), at(2, 0, 6), at(2, 0, 20);
    EXPECT_EQ(result.cost(Form::NaiveFloat), 3) << "the median of where it does not";
    EXPECT_FALSE(result.cost(Form::NaiveDouble));
    EXPECT_TRUE(result.passes());
    result.points[0].forms[2]->failuresPerMillion = 1;
    EXPECT_FALSE(result.passes());
}

// The figures of the catalogue in tests/STABILITY.md and of the papers that found them.

TEST(NaiveForm, OfAFarSphereTakesEveryMissForAHit) {
    const double misses = 1 - kPiD / (2.4 * 2.4);
    EXPECT_EQ(failures("F01", 10), 0);
    EXPECT_NEAR(failures("F01", 1000), 0.017, 0.005);
    EXPECT_NEAR(failures("F01", 4096), misses, 0.02);
    EXPECT_NEAR(failures("F01", 1e5), misses, 0.02);
    EXPECT_EQ(failures("F01", 1e5, Form::NaiveDouble), 0);
}

TEST(NaiveForm, OfAHugeSphereIsOffByPercents) {
    EXPECT_GT(error("F02", 1e6), 0.016);
    EXPECT_LT(error("F02", 1e6, Form::NaiveDouble), 1e-9);
}

TEST(NaiveForm, LeavesASurfaceThatItHitsAgain) {
    EXPECT_NEAR(failures("F04", 1), 0.45, 0.05);
    EXPECT_NEAR(failures("F04", 1, Form::NaiveDouble), 0.45, 0.05);
}

TEST(NaiveForm, HasAnEpsilonThatFitsFewScales) {
    EXPECT_EQ(failures("F05", 1e-3), 1) << "skips the shell";
    EXPECT_EQ(failures("F05", 1), 0);
    EXPECT_NEAR(failures("F05", 1000), 0.35, 0.1) << "meets itself";
}

TEST(NaiveForm, OfAnOffsetAloneFailsForFarEyes) {
    EXPECT_EQ(failures("F06", 10), 0);
    EXPECT_NEAR(failures("F06", 1e3), 0.30, 0.05);
    EXPECT_NEAR(failures("F06", 1e4), 0.51, 0.05);
}

TEST(NaiveForm, OfTrianglesLeaksAtEdgesAndCorners) {
    EXPECT_NEAR(failures("F07", 32768), 0.12, 0.02);
    EXPECT_GT(failures("F07", 32768, Form::NaiveDouble), 0);
}

TEST(NaiveForm, CullsTrianglesOfLessThanAMillimetre) {
    EXPECT_EQ(failures("F08", 0.9e-3), 1);
    EXPECT_EQ(failures("F08", 1.1e-3), 0);
}

TEST(NaiveForm, LosesEveryRayAtAFlatBox) {
    EXPECT_EQ(failures("F13", 1e-18), 1);
    EXPECT_EQ(failures("F13", 1e-18, Form::NaiveDouble), 1);
    EXPECT_EQ(failures("F13", 1e-5), 0);
}

TEST(NaiveForm, OfSlabsRejectsRaysAtEdges) { EXPECT_NEAR(failures("F14", 10), 0.035, 0.015); }

TEST(NaiveForm, OfCoplanarTrianglesLeavesTheChoiceToRounding) {
    for (const Form form : {Form::NaiveFloat, Form::NaiveDouble})
        for (const double tilt : {20.0, 40.0}) EXPECT_NEAR(failures("F17", tilt, form), 0.35, 0.1) << tilt;
}

TEST(NaiveForm, OfTreesIsDeeperThanItsStack) {
    EXPECT_EQ(failures("F26", 32), 0);
    EXPECT_GT(error("F26", 240), 120);
}

TEST(NaiveForm, JumpsFarFromTheOrigin) {
    EXPECT_NEAR(error("F20", 1e4), 9.8e-4 / 2, 3e-4) << "a float at 10 km";
    EXPECT_GT(error("F20", 1e7), 0.25);
}

TEST(NaiveForm, OfNormalsLeansTheWrongWay) { EXPECT_NEAR(error("F22", 0.1), 78.58, 0.05); }

TEST(NaiveForm, OfRotationsDrifts) { EXPECT_NEAR(error("F23", 1e6), 0.03 / 2, 0.01); }

TEST(NaiveForm, OfArcCosinesIsNoNumberNearAPole) { EXPECT_NEAR(failures("F25", 1e-3), 0.3, 0.1); }

TEST(NaiveForm, OfRefractionIsNoNumberBeyondTheCriticalAngle) {
    EXPECT_EQ(failures("F27", 40), 0);
    EXPECT_EQ(failures("F27", 44), 1);
}

TEST(NaiveForm, OfReflectanceIsFarOffInsideGlass) { EXPECT_NEAR(error("F28", 60), 0.93, 0.03); }

TEST(NaiveForm, OfHighlightsGivesTwiceTheLight) {
    for (const double n : {1.0, 2.0, 4.0}) EXPECT_NEAR(error("F32", n), 2 * kPiD / (n + 2) - 1, 0.02) << n;
    EXPECT_EQ(error("F32", 100), 0);
}

TEST(NaiveForm, OfHighlightsShinesOnTheUnlitSide) {
    EXPECT_EQ(failures("F33", 0), 0);
    EXPECT_GT(failures("F33", 120), 0.3);
}

TEST(NaiveForm, OfMirrorsGoesUnderTheSurface) {
    EXPECT_EQ(failures("F35", 0), 0);
    EXPECT_GT(failures("F35", 15), 0.05);
    EXPECT_GT(failures("F35", 30), 2 * failures("F35", 15));
}

TEST(NaiveForm, OfWaterInGlassBendsAsInAir) {
    const double wrong = std::asin(0.5 / 1.33), right = std::asin(0.5 * 1.5 / 1.33);
    EXPECT_NEAR(degrees(wrong), 22.08, 0.01);
    EXPECT_NEAR(degrees(right), 34.33, 0.01);
    EXPECT_NEAR(error("F36", 30), 2 * std::sin((right - wrong) / 2), 0.03);
}

TEST(NaiveForm, CutOffLosesAsMuchAsTheCutoff) {
    EXPECT_LE(error("F40", 1e-3), 1e-3);
    EXPECT_NEAR(error("F40", 0.5), std::pow(0.9, 7), 1e-6);
}

TEST(NaiveForm, CountsEmissionTwice) { EXPECT_NEAR(error("F42", 0.5), 0.5, 1e-6) << "3 for 2"; }

TEST(NaiveForm, OfFirefliesLosesTwoThirdsOfTheLight) {
    EXPECT_NEAR(error("F48", 1), 0.66, 0.08);
    EXPECT_EQ(failures("F48", 1e5), 0);
}

TEST(NaiveForm, OfPixelsThatStopThemselvesLosesRareLight) {
    EXPECT_NEAR(error("F49", 0.05), 0.45, 0.05);
    EXPECT_NEAR(error("F49", 0.02), 0.60, 0.05);
    EXPECT_LT(error("F49", 0.5), 0.05);
}

TEST(NaiveForm, OfHaltonPointsIsCorrelatedInHighBases) {
    EXPECT_LT(error("F52", 3), 0.1);
    EXPECT_NEAR(error("F52", 67), 0.68, 0.15);
}

TEST(NaiveForm, SpoilsEachPixelThatHasOneNan) {
    EXPECT_NEAR(failures("F58", 64), 1 - std::pow(0.999, 64), 0.03);
}

TEST(NaiveForm, OfHalfFloatsOverflowsAndRounds) {
    EXPECT_EQ(failures("F59", 1e5), 1);
    EXPECT_EQ(failures("F59", 1e-9), 1);
    EXPECT_LT(error("F59", 1), 1e-3);
}

TEST(NaiveForm, MeetsDenormalNumbersInDenseMedia) {
    EXPECT_EQ(failures("F60", 70), 0);
    EXPECT_EQ(failures("F60", 95), 1);
    EXPECT_EQ(failures("F60", 95, Form::NaiveDouble), 0);
}

TEST(NaiveForm, OfTheNearestHitEndsAtItsFirstGuess) {
    EXPECT_EQ(failures("F64", 1e3), 0);
    EXPECT_EQ(failures("F64", 1e5), 1);
}

TEST(NaiveForm, CutAtADepthLosesTheRestOfTheSeries) {
    EXPECT_NEAR(error("F39", 0.9), std::pow(0.9, 7), 0.02); // the lamp's last reflection is seen too
}

TEST(NaiveForm, OfRouletteIsTooDark) {
    double expected = 0, survive = 1;
    for (int bounce = 0; bounce < 200; ++bounce) {
        expected += survive * std::pow(0.8, bounce);
        if (bounce >= 3) survive *= 0.8;
    }
    EXPECT_NEAR(error("F41", 0.8), 1 - expected / 5, 0.01);
}

TEST(NaiveForm, OfACosineDistributionPassesAFurnaceAndNoOtherSky) {
    EXPECT_EQ(error("F43", 0), 0);
    EXPECT_NEAR(error("F43", 4), 0.5, 0.01) << "1/2 for 1/3";
}

TEST(NaiveForm, OfALensIsCrowdedInItsMiddle) { EXPECT_NEAR(error("F44", 0.5), 0.25, 0.01); }

TEST(NaiveForm, OfAreaSamplingHasTheKnownDeviations) {
    EXPECT_NEAR(error("F45", 1), 0.174, 0.005);
    EXPECT_NEAR(error("F45", 0.1), 3.2, 0.1);
}

TEST(NaiveForm, OfASmallConeCancels) { EXPECT_EQ(failures("F46", 1e-4), 1); }

TEST(NaiveForm, OfALampShadesItself) { EXPECT_NEAR(failures("F47", 1e4), 0.28, 0.05); }

TEST(NaiveForm, OfSeedsIsCorrelated) { EXPECT_GT(error("F50", 1), 0.999); }

TEST(NaiveForm, OfRandomNumbersReachesOne) { EXPECT_NEAR(failures("F51", 1000), 0.128, 0.01); }

TEST(NaiveForm, OfACheckerboardHasSpeckles) { EXPECT_NEAR(failures("F54", 1.78), 0.11, 0.03); }

TEST(NaiveForm, OfSrgbIsOffByEightCodes) { EXPECT_NEAR(error("F55", 3e-3), 8.6, 0.5); }

TEST(NaiveForm, OfSumsLosesWhatComesAfterAFirefly) { EXPECT_NEAR(error("F56", 1e6), 1e4 / 1.01e6, 1e-3); }

TEST(NaiveForm, OfAFilmOfBytesStopsMoving) { EXPECT_GT(error("F57", 1024), 30); }

TEST(NaiveForm, SkipsPanesWithinItsEpsilon) { EXPECT_NEAR(error("F61", 5e-4), 0.5, 0.1); }

TEST(NaiveForm, OfPixelsIsHalfAPixelOff) { EXPECT_NEAR(error("F63", 640), 0.5, 0.01); }

}
}
