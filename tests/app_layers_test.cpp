// labels: ui
// Layers and comparisons in the viewer, played by a person.

#include <gtest/gtest.h>

#include "app/rayview/rasteriser.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "core/image/metrics.h"
#include "core/study/layer_picture.h"
#include "tests/app_screen.h"
#include "tests/read_pictures.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

void run(Screen& screen, const std::string& line) {
    ASSERT_TRUE(screen.gui.execute(Command::parse(line))) << line;
    screen.settle();
}

/// The part of the window where the picture is.
ByteImage shownPicture(Screen& screen) {
    const ByteImage window = screen.picture();
    const WidgetRect r = screen.rect("picture");
    ByteImage part(static_cast<int>(r.x1 - r.x0), static_cast<int>(r.y1 - r.y0));
    for (int y = 0; y < part.height(); ++y)
        for (int x = 0; x < part.width(); ++x)
            part.at(x, y) = window.at(x + static_cast<int>(r.x0), y + static_cast<int>(r.y0));
    return part;
}

/// Share of the pixels of the upper quarter, which no legend covers, that are the same.
double sameAbove(const ByteImage& a, const ByteImage& b) {
    int same = 0;
    const int rows = a.height() / 4;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < a.width(); ++x) same += a.at(x, y) == b.at(x, y) ? 1 : 0;
    return static_cast<double>(same) / (rows * a.width());
}

TEST(LayersUi, TheWindowShowsTheLayerThatTheTracerHasOnRecord) {
    Screen screen;
    for (const char* const name : {"normal", "depth", "id", "rays", "reflection"}) {
        run(screen, std::string("layer name=") + name);
        const auto film = screen.viewer.layers().film();
        ASSERT_TRUE(film);
        const LayerImage image = film->image(0);
        EXPECT_EQ(image.layer.name, name);
        EXPECT_EQ(image.samples, kSamples);
        const LayerRange range = hasRange(image.layer.quantity) ? rangeOf(image) : LayerRange{};
        const ByteImage expected = displayLayer(image, range, screen.document().render.display);
        EXPECT_EQ(sameAbove(shownPicture(screen), expected), 1.0) << name;
    }
}

TEST(LayersUi, NGoesThroughTheLayersAndBackAndUndoReturns) {
    Screen screen;
    screen.press("N");
    EXPECT_EQ(screen.document().layer, "normal");
    screen.press("N");
    EXPECT_EQ(screen.document().layer, "depth");
    screen.press("Shift+N");
    screen.press("Shift+N");
    EXPECT_EQ(screen.document().layer, "color");
    screen.press("Shift+N");
    EXPECT_EQ(screen.document().layer, "rest");
    screen.press("Shift+O");
    EXPECT_EQ(screen.document().layer, "color");
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().layer, "rest");
}

TEST(LayersUi, WhileOIsHeldThePictureItselfIsShown) {
    Screen screen;
    const ByteImage color = shownPicture(screen);
    run(screen, "layer name=normal");
    const ByteImage normal = shownPicture(screen);
    EXPECT_LT(sameAbove(normal, color), 0.1);
    screen.platform.key('O', true);
    screen.play();
    EXPECT_EQ(shownPicture(screen), color);
    screen.platform.key('O', false);
    screen.play();
    EXPECT_EQ(shownPicture(screen), normal);
    EXPECT_EQ(screen.document().layer, "normal");
}

TEST(LayersUi, ALayerFollowsTheCameraAndTheSwitches) {
    Screen screen;
    run(screen, "layer name=rays");
    const LayerImage before = screen.viewer.layers().film()->image(0);
    run(screen, "set reflections=off");
    const LayerImage fewer = screen.viewer.layers().film()->image(0);
    EXPECT_NE(fewer.values, before.values);
    run(screen, "orbit yaw=40");
    EXPECT_NE(screen.viewer.layers().film()->image(0).values, fewer.values);
    run(screen, "layer name=color");
    EXPECT_FALSE(screen.viewer.layers().film());
}

TEST(LayersUi, TheLayerOfALampThatIsRemovedGivesWayToThePicture) {
    Screen screen("shadows");
    const std::vector<Layer> layers = layersOf(*screen.document().scene);
    const std::string lamp = std::ranges::find(layers, Quantity::Lamp, &Layer::quantity)->name;
    run(screen, Command("layer", {{"name", lamp}}).text());
    while (!screen.document().scene->lights.empty()) run(screen, "remove-light light=0");
    EXPECT_EQ(shownLayer(screen.document()).quantity, Quantity::Picture);
    EXPECT_FALSE(screen.viewer.layers().film());
    for (const Notice& notice : screen.viewer.notices())
        EXPECT_NE(notice.kind, Notice::Kind::Error) << notice.text;
}

TEST(LayersUi, AScreenshotOfALayerHoldsItAndOpensInThatState) {
    const TemporaryFolder folder;
    Screen screen;
    run(screen, "layer name=depth");
    const LayerImage depth = screen.viewer.layers().film()->image(0);
    run(screen, Command("screenshot", {{"file", (folder / "depth.png").string()}}).text());
    run(screen, Command("screenshot", {{"file", (folder / "depth.exr").string()}}).text());
    const auto png = readFile(folder / "depth.png", 1U << 26U);
    EXPECT_EQ(decodeImage(png, "depth.png").pixels, displayLayer(depth, rangeOf(depth), {}));
    EXPECT_EQ(readPngText(png, "depth.png").at("eyeray.range"), rangeText(depth, rangeOf(depth)));
    EXPECT_EQ(readExr(readFile(folder / "depth.exr", 1U << 26U)).image, depth.values);
    run(screen, "layer name=color");
    run(screen, Command("open", {{"scene", (folder / "depth.png").string()}}).text());
    EXPECT_EQ(screen.document().layer, "depth");
}

TEST(LayersUi, TheSamplesAreThoseOfThePictureItself) {
    Screen screen;
    run(screen, "set error=0.05 samples=64");
    run(screen, "layer name=samples");
    run(screen, "wait samples=64");
    const ColorImage counts = screen.viewer.session().sampleCounts();
    EXPECT_EQ(screen.viewer.layerImage()->values, counts);
    const auto [least, most] = std::ranges::minmax_element(
        counts.values(), [](const Color& a, const Color& b) { return a.x < b.x; });
    EXPECT_EQ(least->x, 4) << "the pilot";
    EXPECT_EQ(most->x, screen.viewer.status().samples);
    EXPECT_GT(most->x, 16);
    EXPECT_EQ(screen.viewer.layers().film(), nullptr) << "nothing is traced for it";
    run(screen, "set adaptive=off");
    const ColorImage even = screen.viewer.layerImage()->values;
    EXPECT_EQ(even, ColorImage(even.width(), even.height(), even.at(0, 0)));
}

TEST(LayersUi, AnUnknownLayerIsRefusedAndNothingChanges) {
    Screen screen;
    EXPECT_FALSE(screen.gui.execute(Command::parse("layer name=kolor")));
    EXPECT_EQ(screen.document().layer, "color");
    ASSERT_EQ(screen.viewer.notices().size(), 1U);
}

TEST(CompareUi, LeftOfTheLineIsTheOtherSideAndRightOfItThisOne) {
    Screen screen;
    run(screen, "set max-depth=1");
    const ByteImage shallow = shownPicture(screen);
    run(screen, "set max-depth=5");
    const ByteImage deep = shownPicture(screen);
    run(screen, "compare with=\"max-depth=1\"");
    const ByteImage split = shownPicture(screen);
    const int middle = split.width() / 2, label = 60, y = 2 * split.height() / 5;
    int differing = 0;
    for (int x = 0; x < split.width(); ++x)
        for (int row = label; row < y; ++row) {
            if (std::abs(x - middle) < 4) continue;
            EXPECT_EQ(split.at(x, row), (x < middle ? shallow : deep).at(x, row)) << x << " " << row;
            differing += shallow.at(x, row) == deep.at(x, row) ? 0 : 1;
        }
    EXPECT_GT(differing, 100) << "or the test says nothing";
    screen.press("K");
    EXPECT_EQ(shownPicture(screen), deep);
}

TEST(CompareUi, TheCountOfChangedPixelsAndRaysIsThatOfTwoPicturesRenderedAlone) {
    Screen screen;
    const ByteImage own = display(screen.viewer.session().image(), screen.document().render.display);
    const RayCounts ownRays = screen.viewer.status().counts;
    run(screen, "set shadows=off");
    const ByteImage other = display(screen.viewer.session().image(), screen.document().render.display);
    const RayCounts otherRays = screen.viewer.status().counts;
    run(screen, "set shadows=on");
    run(screen, "compare with=\"shadows=off\"");
    ASSERT_TRUE(screen.viewer.comparison().change());
    const PictureChange& change = *screen.viewer.comparison().change();
    EXPECT_EQ(change.samples, kSamples);
    EXPECT_EQ(change.changed, countDifferingPixels(own, other));
    EXPECT_EQ(change.pixels, own.values().size());
    EXPECT_EQ(change.here.rays, ownRays.rays);
    EXPECT_EQ(change.there.rays, otherRays.rays);
    EXPECT_GT(change.changed, 0U);
}

TEST(CompareUi, TheDifferenceIsThatOfTheTwoPicturesTimesTheGain) {
    Screen screen;
    const ColorImage own = screen.viewer.session().image();
    run(screen, "set reflections=off");
    ColorImage difference = screen.viewer.session().image();
    for (std::size_t i = 0; i < own.values().size(); ++i)
        difference.values()[i] = glm::abs(own.values()[i] - difference.values()[i]) * 4.0F;
    run(screen, "set reflections=on");
    run(screen, "compare with=\"reflections=off\" difference=on gain=4");
    EXPECT_EQ(sameAbove(shownPicture(screen), display(difference, screen.document().render.display)), 1.0);
}

TEST(CompareUi, TheLineIsDraggedAndIsNoStepOfUndo) {
    Screen screen;
    run(screen, "compare with=\"max-depth=0\"");
    const Camera camera = screen.document().camera;
    const Point from = screen.middle("split line");
    const WidgetRect r = screen.rect("picture");
    const float to = r.x0 + 0.25F * (r.x1 - r.x0);
    screen.drag(0, from, {to, from.y});
    EXPECT_NEAR(screen.document().comparison.split, 0.25, 0.01);
    EXPECT_EQ(screen.document().camera, camera) << "the line, not the view";
    EXPECT_FALSE(screen.viewer.canUndo());
    const Point away{r.x1 - 20, from.y};
    screen.drag(0, away, {away.x - 40, away.y});
    EXPECT_NE(screen.document().camera, camera) << "beside the line it is the view";
}

TEST(CompareUi, SwitchingAKindOfRaysTellsItsEffectAndDShowsIt) {
    Screen screen;
    const RayCounts before = screen.viewer.status().counts;
    screen.press("R");
    screen.settle();
    ASSERT_EQ(screen.viewer.notices().size(), 1U);
    const std::string line = screen.viewer.notices()[0].text;
    EXPECT_EQ(line.rfind("reflection rays off: ", 0), 0U) << line;
    EXPECT_NE(line.find(" rays fewer, "), std::string::npos) << line;
    EXPECT_NE(line.find(" % of pixels changed"), std::string::npos) << line;
    EXPECT_EQ(screen.viewer.status().samples, kSamples) << "the picture has gone on to its end";
    const RayCounts after = screen.viewer.status().counts;
    EXPECT_GT(before.total(), after.total());
    EXPECT_FALSE(screen.document().comparison.on);
    screen.press("D");
    screen.settle();
    EXPECT_TRUE(screen.document().comparison.on);
    EXPECT_TRUE(screen.document().comparison.difference);
    EXPECT_EQ(screen.document().comparison.with, "reflections=on");
    ASSERT_TRUE(screen.viewer.comparison().change());
    EXPECT_EQ(screen.viewer.comparison().change()->there.rays, before.rays);
}

TEST(CompareUi, SettingsThatAreNoneOrThatBothSidesShareAreRefused) {
    Screen screen;
    for (const char* const with :
         {"depth=1", "max-depth=99", "accel=brute", "samples=4", "aspect=1", "rubbish"}) {
        EXPECT_FALSE(screen.gui.execute({"compare", {{"with", with}}})) << with;
        EXPECT_FALSE(screen.document().comparison.on);
    }
    EXPECT_FALSE(screen.gui.execute({"difference"})) << "nothing to compare with";
}

TEST(CompareUi, TheOtherSideMayHaveAnotherViewOrExposureAndFollowsTheCamera) {
    Screen screen;
    run(screen, "compare with=\"fov=60 exposure=2\"");
    ASSERT_TRUE(screen.viewer.comparison().change());
    run(screen, "orbit yaw=30");
    ASSERT_TRUE(screen.viewer.comparison().change());
    EXPECT_EQ(screen.viewer.comparison().change()->samples, kSamples);
    EXPECT_GT(screen.viewer.comparison().change()->changed, screen.viewer.comparison().change()->pixels / 2);
    run(screen, "compare on=off");
    EXPECT_FALSE(screen.viewer.comparison().active());
    run(screen, "set max-depth=3");
    EXPECT_EQ(screen.viewer.status().phase, RenderStatus::Phase::Finished);
}

TEST(CompareUi, AnotherExposureIsCountedAnew) {
    Screen screen;
    run(screen, "compare with=\"shadows=off\"");
    const std::size_t before = screen.viewer.comparison().change()->changed;
    ASSERT_GT(before, 0U);
    run(screen, "set exposure=-20");
    EXPECT_EQ(screen.viewer.comparison().change()->changed, 0U) << "black beside black";
    run(screen, "set exposure=0");
    EXPECT_EQ(screen.viewer.comparison().change()->changed, before);
}

TEST(CompareUi, APauseHoldsBothSidesAndAllGoesOnAfterIt) {
    Screen screen;
    screen.press("Space");
    run(screen, "compare with=\"max-depth=1\"");
    run(screen, "set shadows=off");
    screen.press("Space");
    screen.settle();
    ASSERT_TRUE(screen.viewer.comparison().change());
    EXPECT_EQ(screen.viewer.comparison().change()->samples, kSamples);
}

TEST(CompareUi, ThePanelComparesWithAPreset) {
    Screen screen("homage", 760, 1400);
    screen.click("panel Compare");
    screen.settle();
    screen.click("compare with");
    screen.settle();
    screen.click("compare shadows=off");
    screen.settle();
    EXPECT_TRUE(screen.document().comparison.on);
    EXPECT_EQ(screen.document().comparison.with, "shadows=off");
}

TEST(CompareUi, WithEqualSecondsTheOtherSideIsTracedNoShorter) {
    Screen screen;
    run(screen, "compare with=\"max-depth=1\" equal=seconds");
    const PictureChange& change = *screen.viewer.comparison().change();
    EXPECT_EQ(change.samples, kSamples);
    EXPECT_GE(change.samplesThere, 1);
    EXPECT_GT(change.secondsHere, 0);
    EXPECT_GE(change.secondsThere, change.secondsHere);
    EXPECT_EQ(screen.viewer.comparison().session()->status().samples, change.samplesThere) << "it waits";
    run(screen, "compare equal=samples");
    EXPECT_EQ(screen.viewer.comparison().change()->samplesThere, kSamples);
    EXPECT_FALSE(screen.gui.execute(Command::parse("compare equal=rays")));
}

TEST(CompareUi, TheOtherSideMayBeWhatOpenGLDraws) {
    Screen screen;
    run(screen, "rasterised");
    const ByteImage raster = shownPicture(screen);
    run(screen, "rasterised");
    const ByteImage traced = shownPicture(screen);
    run(screen, "compare with=rasterised");
    const ByteImage split = shownPicture(screen);
    const int row = split.height() / 2, middle = split.width() / 2;
    for (int x = 0; x < split.width(); ++x)
        if (std::abs(x - middle) > 12) {
            EXPECT_EQ(split.at(x, row), (x < middle ? raster : traced).at(x, row)) << x;
        }
    EXPECT_EQ(screen.viewer.comparison().session(), nullptr) << "nothing else is traced";
}

/// What OpenGL draws of the screen's document by itself.
ColorImage rasterised(Screen& screen) {
    const PictureSize size = screen.viewer.pictureSize();
    return Rasteriser(screen.platform.gl())
        .draw(screen.viewer.world(), screen.document().camera, size.width, size.height)
        .radiance;
}

TEST(CompareUi, TheDifferenceFromWhatOpenGLDrawsIsThatOfTheTwoPictures) {
    Screen screen;
    run(screen, "compare with=rasterised difference=on gain=3");
    const DisplaySettings& shown = screen.document().render.display;
    const auto expect = [&] {
        const ColorImage own = screen.viewer.session().image(), other = rasterised(screen);
        ASSERT_TRUE(screen.viewer.comparison().change());
        const PictureChange& change = *screen.viewer.comparison().change();
        EXPECT_EQ(change.samples, kSamples);
        EXPECT_EQ(change.changed, countDifferingPixels(display(own, shown), display(other, shown)));
        EXPECT_GT(change.changed, 0U);
        EXPECT_EQ(change.there.total(), 0U) << "it traces no ray";
        EXPECT_EQ(change.here.rays, screen.viewer.status().counts.rays);
        ColorImage difference = own;
        for (std::size_t i = 0; i < own.values().size(); ++i)
            difference.values()[i] = glm::abs(own.values()[i] - other.values()[i]) * 3.0F;
        EXPECT_EQ(sameAbove(shownPicture(screen), display(difference, shown)), 1.0);
    };
    expect();
    run(screen, "orbit yaw=25");
    expect();
    run(screen, "set exposure=1");
    expect();
    run(screen, "compare on=off");
    EXPECT_FALSE(screen.viewer.comparison().change());
}

TEST(CompareUi, WhereNothingButEyeRaysIsTracedFewPixelsDifferFromOpenGL) {
    Screen screen("knot");
    run(screen, "set method=local samples=1");
    run(screen, "compare with=rasterised");
    const PictureChange local = *screen.viewer.comparison().change();
    run(screen, "set method=whitted");
    const PictureChange whitted = *screen.viewer.comparison().change();
    const auto unlike = [](const PictureChange& change) {
        return std::count_if(change.difference.values().begin(), change.difference.values().end(),
                             [](const Color& c) { return maxComponent(c) > 0.01F; });
    };
    EXPECT_LT(20 * unlike(local), unlike(whitted));
}

}
}
