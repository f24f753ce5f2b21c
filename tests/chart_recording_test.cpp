// labels: unit
// The live chart: what it takes down of a picture that refines.

#include <gtest/gtest.h>

#include "app/viewer/chart_recording.h"
#include "core/image/metrics.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 64, kHeight = 48;

Document documentOf(Method method) {
    Scene scene = underSky(Color(0.5F));
    look(scene, {0, 0.5, 4}, {0, 0, 0});
    add(scene, Plane{20, 20, true}, matte(Color(0.7F)), at({0, -1, 0}));
    add(scene, Sphere{1}, matte(Color(0.6F)));
    scene.lights = {lampAt({2, 4, -3}, SphereLamp{0.5}, 20)};
    Document document = makeDocument(std::make_shared<const Scene>(std::move(scene)));
    document.render.trace.method = method;
    document.render.trace.sampler = Sampler::Independent;
    document.render.width = kWidth;
    document.render.height = kHeight;
    return document;
}

/// Refines to each of the numbers of samples and lets the chart look there.
void record(ChartRecording& chart, const Document& document, RenderSession& session, int most) {
    RenderSettings settings = document.render;
    settings.stop = {.samples = most, .seconds = 0, .error = 0};
    session.holdAt(1);
    session.start(buildWorld(document.scene, {}), document.camera, settings);
    chart.begin(document, document, kWidth, kHeight);
    for (int samples = 1; samples <= most; samples *= 2) {
        session.holdAt(samples);
        while (session.status().samples < samples) session.wait(std::chrono::milliseconds(1));
        EXPECT_TRUE(chart.update(session));
        EXPECT_FALSE(chart.update(session)) << "nothing new";
    }
    session.holdAt(0);
    session.stop();
}

TEST(ChartRecording, EstimatesTheErrorThatAPictureHas) {
    const Document document = documentOf(Method::Path);
    ChartRecording chart;
    chart.setOn(true);
    RenderSession session(2);
    record(chart, document, session, 4096);
    const ColorImage truth = session.image();
    record(chart, document, session, 64);
    ASSERT_EQ(chart.curves().size(), 2U);
    const auto& points = chart.curves()[1].points;
    ASSERT_EQ(points.size(), 6U) << "2, 4, 8, 16, 32, 64";
    EXPECT_EQ(points.back().samples, 64);
    EXPECT_NEAR(points.back().error / rmse(session.image(), truth), 1, 0.12);
    EXPECT_NEAR(points[1].error / points[5].error, 4, 0.8) << "16 times the samples, a quarter of the error";
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].seconds, points[i - 1].seconds);
}

TEST(ChartRecording, TakesNothingWhileItIsOff) {
    const Document document = documentOf(Method::Cast);
    ChartRecording chart;
    RenderSession session(1);
    session.start(buildWorld(document.scene, {}), document.camera, document.render);
    chart.begin(document, document, kWidth, kHeight);
    while (session.status().samples < 2) session.wait(std::chrono::milliseconds(1));
    EXPECT_FALSE(chart.update(session));
    EXPECT_TRUE(chart.curves()[0].points.empty());
}

TEST(ChartRecording, KeepsPinnedCurvesWhenTheViewChangesAndOtherSettingsOfOneView) {
    const Document document = documentOf(Method::Cast);
    ChartRecording chart;
    chart.setOn(true);
    RenderSession session(1);
    record(chart, document, session, 2);
    record(chart, document, session, 2);
    record(chart, document, session, 2);
    EXPECT_EQ(chart.curves().size(), 3U) << "of one view";
    EXPECT_NE(chart.curves()[0].color, chart.curves()[1].color);
    chart.pin(1, true);
    chart.rename(1, "kept");
    Document moved = document;
    moved.camera.eye.x += 1;
    chart.begin(document, moved, kWidth, kHeight);
    ASSERT_EQ(chart.curves().size(), 2U);
    EXPECT_EQ(chart.curves()[0].name, "kept");
    EXPECT_TRUE(chart.curves()[1].points.empty());
    chart.remove(0);
    EXPECT_EQ(chart.curves().size(), 1U);
}

TEST(ChartRecording, HoldsFewCurvesHoweverOftenSettingsChange) {
    const Document document = documentOf(Method::Local);
    ChartRecording chart;
    chart.setOn(true);
    RenderSession session(1);
    for (int i = 0; i < 14; ++i) record(chart, document, session, 2);
    EXPECT_EQ(chart.curves().size(), 8U);
}

TEST(ChartRecording, IsWrittenWithEveryPoint) {
    const Document document = documentOf(Method::Cast);
    ChartRecording chart;
    chart.setOn(true);
    RenderSession session(1);
    record(chart, document, session, 8);
    chart.rename(0, "a \"b\"");
    const std::string csv = csvOf(chart);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 4) << csv;
    EXPECT_NE(csv.find("\"a \"\"b\"\"\",8,"), std::string::npos) << csv;
    const Plot plot = plotOf(chart);
    ASSERT_EQ(plot.series.size(), 1U);
    EXPECT_EQ(plot.series[0].points.size(), 3U);
    EXPECT_EQ(plot.series[0].points[2].label, "×8");
}

TEST(ChartRecording, MeasuresAllPointsAgainstAReferenceUntilTheViewChanges) {
    const Document document = documentOf(Method::Path);
    const Document cast = apply(document, Command::parse("set method=cast"));
    ChartRecording chart;
    chart.setOn(true);
    RenderSession session(2);
    record(chart, cast, session, 8);
    const ColorImage simple = session.image();
    record(chart, document, session, 64);
    const ColorImage truth = session.image();
    chart.takeReference(1);
    EXPECT_DOUBLE_EQ(chart.errorOf(chart.curves()[0].points.back()), rmse(simple, truth))
        << "a point from before; pictures so small are kept whole";
    EXPECT_EQ(chart.errorOf(chart.curves()[1].points.back()), 0);
    EXPECT_EQ(plotOf(chart).yTitle, "RMSE to path d5 ×64");
    chart.pin(0, true);
    Document moved = document;
    moved.camera.eye.y += 1;
    chart.begin(document, moved, kWidth, kHeight);
    EXPECT_FALSE(chart.reference());
    EXPECT_EQ(chart.errorOf(chart.curves()[0].points.back()), chart.curves()[0].points.back().error);
    EXPECT_THROW(chart.takeReference(1), InputError);
}

TEST(ChartRecording, NamesASettingByWhatDiffersFromTheScene) {
    const Document original = documentOf(Method::Whitted);
    const Document now = apply(original, Command::parse("set method=path max-depth=3 shadows=off samples=7"));
    EXPECT_EQ(nameOfSetting(original, original), "whitted d5");
    EXPECT_EQ(nameOfSetting(original, now), "path d3 shadows=off");
}

}
}
