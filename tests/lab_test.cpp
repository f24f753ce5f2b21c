// labels: unit

#include "core/study/lab.h"

#include <gtest/gtest.h>

#include "app/document/document_commands.h"
#include "app/document/scene_files.h"
#include "core/base/errors.h"
#include "core/image/metrics.h"
#include "tests/app_documents.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

struct Sides {
    ByteImage naive, robust;
    double lightNaive = 0, lightRobust = 0;
    double wrongShare() const {
        double wrong = 0;
        for (std::size_t i = 0; i < naive.values().size(); ++i)
            wrong += clearlyDiffers(naive.values()[i], robust.values()[i]) ? 1 : 0;
        return wrong / static_cast<double>(naive.values().size());
    }
};

ColorImage traced(const Document& document, int passes) {
    constexpr int kWidth = 160, kHeight = 120;
    const auto world = buildWorld(document.scene, buildSettings(document));
    const TraceContext context(world, document.camera, document.render.trace, kWidth, kHeight, 0, {});
    const auto integrator = makeIntegrator(document.render.trace.method);
    const FloatEnvironment environment;
    ColorImage sum(kWidth, kHeight, Color(0));
    for (int pass = 0; pass < passes; ++pass) {
        const TileResult result = integrator->renderTile(context, {0, 0, kWidth, kHeight}, pass);
        for (std::size_t i = 0; i < sum.values().size(); ++i)
            sum.values()[i] += result.radiance[i] / static_cast<float>(passes);
    }
    return sum;
}

double light(const ColorImage& image) {
    double sum = 0;
    for (const Color& value : image.values()) sum += luminance(DVec3(value));
    return sum;
}

Sides sidesOf(std::string_view name, double value, int passes = 1) {
    const Document robust = labDocument(*labDemoNamed(name), value), naive = otherSide(robust);
    const ColorImage a = traced(naive, passes), b = traced(robust, passes);
    return {display(a, shownDisplay(naive.render)), display(b, shownDisplay(robust.render)), light(a),
            light(b)};
}

double wrongAt(std::string_view name, double value) { return sidesOf(name, value).wrongShare(); }

TEST(Lab, HasASceneAndANaiveSideForAnyValueOfItsSlider) {
    EXPECT_GE(labDemos().size(), 12U);
    for (const LabDemo& demo : labDemos())
        for (const double value : {demo.slider.lowest, demo.slider.start, demo.slider.highest}) {
            const Document document = labDocument(demo, value);
            EXPECT_NO_THROW(validate(*document.scene)) << demo.name;
            EXPECT_TRUE(document.comparison.on);
            const Document naive = otherSide(document);
            EXPECT_FALSE(naive.render == document.render && naive.camera == document.camera) << demo.name;
            EXPECT_EQ(document.labValue, value) << demo.name;
        }
    EXPECT_EQ(labDemoNamed("homage"), nullptr);
}

TEST(Lab, StartsWhereTheFailureIsSeen) {
    for (const LabDemo& demo : labDemos())
        EXPECT_GT(sidesOf(demo.name, demo.slider.start, 8).wrongShare(), 0.0005) << demo.name;
}

TEST(Lab, SliderLeadsFromRightToWrong) {
    struct Case {
        const char* name;
        double right, wrong;
    };
    for (const Case& c : {Case{"lab-sphere", 10, 1e5},
                          {"lab-leaks", 4, 128},
                          {"lab-holes", 10, 0.01},
                          {"lab-far", 1, 1e7},
                          {"lab-squash", 1, 0.05},
                          {"lab-glass", 0, 60},
                          {"lab-terminator", 128, 8},
                          {"lab-tunnel", 64, 0},
                          {"lab-cutoff", 1e-3, 1},
                          {"lab-fireflies", 1000, 0.1},
                          {"lab-epsilon", 1e-4, 0}}) {
        EXPECT_LT(wrongAt(c.name, c.right), 0.12) << c.name;
        EXPECT_GT(wrongAt(c.name, c.wrong), wrongAt(c.name, c.right) + 0.01) << c.name;
    }
}

TEST(Lab, ScaledSceneIsTheSamePictureOnTheRobustSide) {
    const ByteImage small = sidesOf("lab-scale", 1e-3).robust, large = sidesOf("lab-scale", 1e5).robust;
    double wrong = 0;
    for (std::size_t i = 0; i < small.values().size(); ++i)
        wrong += clearlyDiffers(small.values()[i], large.values()[i]) ? 1 : 0;
    EXPECT_LE(wrong, 0.001 * static_cast<double>(small.values().size()));
}

TEST(Lab, TunnelGainsLightWithEachLevelOfRecursion) {
    double last = 0;
    for (const double depth : {0.0, 2.0, 6.0, 12.0, 24.0}) {
        const Sides sides = sidesOf("lab-tunnel", depth);
        EXPECT_GT(sides.lightNaive, last) << depth;
        EXPECT_LE(sides.lightNaive, sides.lightRobust) << depth;
        last = sides.lightNaive;
    }
}

TEST(Lab, ClampedCausticIsTheDarkerTheLowerTheClamp) {
    double last = 0;
    for (const double clamp : {0.1, 1.0, 10.0, 100.0}) {
        const Sides sides = sidesOf("lab-fireflies", clamp, 16);
        EXPECT_GT(sides.lightNaive, last) << clamp;
        EXPECT_LE(sides.lightNaive, (clamp <= 1 ? 0.97 : 1.0) * sides.lightRobust) << clamp;
        last = sides.lightNaive;
    }
}

TEST(Lab, RouletteWithoutWeightsIsTheDarkerTheWhiterTheWalls) {
    const Sides dark = sidesOf("lab-roulette", 0.3, 8), white = sidesOf("lab-roulette", 0.9, 8);
    EXPECT_LT(dark.lightNaive, dark.lightRobust);
    EXPECT_LT(white.lightNaive / white.lightRobust, dark.lightNaive / dark.lightRobust - 0.1);
}

TEST(Lab, NothingIsSeenThroughAClosedMeshButByTheNaiveSide) {
    const auto white = [](const ByteImage& picture) {
        return std::ranges::count(picture.values(), Rgba8{255, 255, 255, 255});
    };
    for (const double rows : {16.0, 64.0}) {
        const Sides sides = sidesOf("lab-leaks", rows);
        EXPECT_EQ(white(sides.robust), 0) << rows;
        EXPECT_GT(white(sides.naive), 20) << rows;
    }
}

TEST(Lab, SamplesSmoothOneSideOfTheAliasedFloorAlone) {
    const auto changed = [](const ByteImage& a, const ByteImage& b) {
        double count = 0;
        for (std::size_t i = 0; i < a.values().size(); ++i) count += a.values()[i] != b.values()[i] ? 1 : 0;
        return count / static_cast<double>(a.values().size());
    };
    const Sides once = sidesOf("lab-aliasing", 1, 1), often = sidesOf("lab-aliasing", 16, 16);
    EXPECT_EQ(changed(once.naive, once.robust), 0) << "the first sample is through the centre";
    EXPECT_EQ(changed(once.naive, often.naive), 0);
    EXPECT_GT(changed(once.robust, often.robust), 0.1);
}

TEST(Lab, SliderIsACommandAndUndoneByADifference) {
    const Document start = openScene("lab-sphere").document;
    const Document slid = edited(start, "lab value=20000");
    EXPECT_EQ(slid.labValue, 20000);
    EXPECT_NE(slid.camera, start.camera);
    const std::vector<Command> commands = commandsBetween(start, slid);
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_EQ(commands[0].text(), "lab value=20000");
    EXPECT_GT(edited(start, "lab by=1").labValue, start.labValue);
    EXPECT_LT(edited(start, "lab by=-1").labValue, start.labValue);
    EXPECT_EQ(edited(start, "lab by=100").labValue, start.lab->slider.highest);
    EXPECT_THROW(edited(start, "lab value=5"), InputError);
    EXPECT_THROW(edited(openScene("homage").document, "lab value=5"), InputError);
}

TEST(Lab, WholeSlidersMoveByOneAtLeast) {
    const LabDemo& demo = *labDemoNamed("lab-checker");
    EXPECT_EQ(labStep(demo, 1, 1), 2);
    EXPECT_EQ(labStep(demo, 2, -1), 1);
    EXPECT_EQ(labStep(*labDemoNamed("lab-epsilon"), 0, -1), 0);
    EXPECT_GT(labStep(*labDemoNamed("lab-epsilon"), 0, 1), 0);
}

}
}
