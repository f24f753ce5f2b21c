// labels: ui
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/image/decode.h"
#include "core/image/metrics.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

bool hasReflection(Screen& screen, int x, int y) {
    for (int pass = 0; pass < kSamples; ++pass) {
        const auto rays = screen.raysOf(x, y, pass);
        if (std::any_of(rays.begin(), rays.end(),
                        [](const RayRecord& ray) { return ray.kind == RayKind::Reflection; }))
            return true;
    }
    return false;
}

TEST(Ui, SwitchingReflectionsOffChangesOnlyPixelsThatHaveReflectionRays) {
    Screen screen;
    const ColorImage before = screen.viewer.session().image();
    std::vector<bool> may;
    for (int y = 0; y < before.height(); ++y)
        for (int x = 0; x < before.width(); ++x) may.push_back(hasReflection(screen, x, y));
    screen.click("reflections");
    EXPECT_FALSE(screen.document().render.trace.reflections);
    screen.settle();
    const ColorImage after = screen.viewer.session().image();
    ASSERT_EQ(after.values().size(), before.values().size());
    std::size_t changed = 0, mayChange = 0, wrong = 0;
    for (std::size_t i = 0; i < may.size(); ++i) {
        const bool differs = before.values()[i] != after.values()[i];
        mayChange += may[i];
        changed += differs;
        wrong += differs && !may[i];
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(changed, mayChange * 9 / 10);
    EXPECT_LT(mayChange, may.size() / 2);
    screen.click("reflections");
    screen.settle();
    EXPECT_EQ(screen.viewer.session().image(), before) << "on again, the same bits";
}

TEST(Ui, DraggingMaxDepthSetsItAndIsOneStepOfUndo) {
    Screen screen;
    const WidgetRect slider = screen.rect("max-depth");
    const float y = (slider.y0 + slider.y1) / 2;
    screen.drag(0, {(slider.x0 + slider.x1) / 2, y}, {slider.x1 - 2, y});
    EXPECT_EQ(screen.document().render.trace.maxDepth, kMaxDepth);
    screen.drag(0, {slider.x1 - 4, y}, {slider.x0 + 2, y});
    EXPECT_EQ(screen.document().render.trace.maxDepth, 0);
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().render.trace.maxDepth, kMaxDepth);
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().render.trace.maxDepth, 5);
    screen.press("Ctrl+Shift+Z");
    EXPECT_EQ(screen.document().render.trace.maxDepth, kMaxDepth);
}

TEST(Ui, AClickPicksThePixelAndSelectsItsObject) {
    Screen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    screen.click(screen.place(ball));
    EXPECT_EQ(screen.document().pixel, ball);
    EXPECT_EQ(screen.document().selectedObject, kMirrorBall);
    ASSERT_TRUE(screen.viewer.picked());
    EXPECT_EQ(screen.viewer.picked()->trace.rays.front().object, kMirrorBall);
    EXPECT_FALSE(screen.viewer.canUndo()) << "a pick is no edit";
    screen.press("Right");
    screen.press("Down");
    EXPECT_EQ(screen.document().pixel, (PixelPosition{ball.x + 1, ball.y + 1}));
    screen.press("Escape");
    EXPECT_FALSE(screen.document().pixel);
    EXPECT_EQ(screen.document().selectedObject, -1);
}

TEST(Ui, APressThatMovesUnderFourPixelsIsAClick) {
    Screen screen;
    const Camera camera = screen.document().camera;
    const Point at = screen.place(screen.pixelOf(kMirrorBall));
    screen.drag(0, at, {at.x + 2, at.y + 2});
    EXPECT_EQ(screen.document().camera, camera);
    EXPECT_EQ(screen.document().selectedObject, kMirrorBall);
}

TEST(Ui, ALeftDragOrbitsAndOneUndoReturns) {
    Screen screen;
    const Camera camera = screen.document().camera;
    const Point from = screen.middle("picture");
    screen.drag(0, from, {from.x + 80, from.y + 20});
    const Camera orbited = screen.document().camera;
    EXPECT_EQ(orbited.target, camera.target);
    EXPECT_NEAR(orbited.distance(), camera.distance(), 1e-9);
    EXPECT_GT(glm::length(orbited.eye - camera.eye), 0.1 * camera.distance());
    EXPECT_FALSE(screen.document().pixel) << "a drag picks nothing";
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().camera, camera);
    EXPECT_FALSE(screen.viewer.canUndo());
}

TEST(Ui, MiddleDragPansAndRightDragTurns) {
    Screen screen;
    const Camera camera = screen.document().camera;
    const Point from = screen.middle("picture");
    screen.drag(2, from, {from.x + 30, from.y});
    const Camera panned = screen.document().camera;
    EXPECT_LT(glm::dot(panned.eye - camera.eye, axesOf(camera).right), 0) << "the scene follows the pointer";
    EXPECT_NEAR(glm::length((panned.eye - camera.eye) - (panned.target - camera.target)), 0, 1e-9);
    screen.drag(1, from, {from.x + 30, from.y});
    EXPECT_EQ(screen.document().camera.eye, panned.eye);
    EXPECT_NE(screen.document().camera.target, panned.target);
}

TEST(Ui, TheWheelMovesTheCameraNearer) {
    Screen screen;
    const double distance = screen.document().camera.distance();
    const Point at = screen.middle("picture");
    screen.platform.moveMouse(at.x, at.y);
    screen.platform.wheel(0, 1);
    screen.play();
    EXPECT_NEAR(screen.document().camera.distance(), 0.9 * distance, 1e-9);
    screen.platform.moveMouse(screen.middle("max-depth").x, screen.middle("max-depth").y);
    screen.platform.wheel(0, 1);
    screen.play();
    EXPECT_NEAR(screen.document().camera.distance(), 0.9 * distance, 1e-9)
        << "over the panels it scrolls them";
}

/// Horizontal place in the picture, in pixels, of a point of the scene.
double pixelColumn(const Camera& camera, const PictureSize& size, const DVec3& point) {
    const CameraAxes axes = axesOf(camera);
    const DVec3 to = point - camera.eye;
    const double half = std::tan(camera.verticalFov / 2) * -glm::dot(to, axes.backward);
    return 0.5 * size.width + 0.5 * size.height * glm::dot(to, axes.right) / half;
}

TEST(Ui, ShiftDragMovesTheObjectWithThePointer) {
    Screen screen;
    const Point from = screen.place(screen.pixelOf(kMirrorBall));
    screen.click(from);
    const auto column = [&] {
        const DMat4& transform = screen.document().scene->objects[kMirrorBall].transform;
        return pixelColumn(screen.document().camera, screen.viewer.pictureSize(), DVec3(transform[3]));
    };
    const double before = column();
    const Camera camera = screen.document().camera;
    screen.platform.key(kKeyLeftShift, true);
    screen.drag(0, from, {from.x - 40, from.y});
    screen.platform.key(kKeyLeftShift, false);
    screen.play();
    EXPECT_NEAR(column(), before - 40, 0.5);
    EXPECT_EQ(screen.document().camera, camera);
    screen.press("Ctrl+Z");
    EXPECT_EQ(column(), before);
}

TEST(Ui, KeysOneToFourAddTheLecturesSteps) {
    Screen screen;
    const auto check = [&](const char* key, bool shadows, bool reflections, bool refractions) {
        screen.press(key);
        const TraceSettings& trace = screen.document().render.trace;
        EXPECT_EQ(trace.shadows, shadows) << key;
        EXPECT_EQ(trace.reflections, reflections) << key;
        EXPECT_EQ(trace.refractions, refractions) << key;
    };
    check("1", false, false, false);
    check("3", true, true, false);
    check("2", true, false, false);
    check("4", true, true, true);
}

TEST(Ui, SpacePausesAndGoesOn) {
    Screen screen;
    screen.press("Space");
    EXPECT_TRUE(screen.viewer.paused());
    screen.press("S");
    EXPECT_FALSE(screen.document().render.trace.shadows);
    screen.press("Space");
    EXPECT_FALSE(screen.viewer.paused());
    screen.settle();
    EXPECT_EQ(screen.viewer.status().phase, RenderStatus::Phase::Finished);
}

TEST(Ui, AKeyHeldDownSwitchesOnceButGoesOnMovingThePixel) {
    Screen screen;
    const auto hold = [&](int key) {
        screen.platform.key(key, true);
        for (int frame = 0; frame < 60; ++frame) screen.play();
        screen.platform.key(key, false);
        screen.play();
    };
    hold(kKeySpace);
    EXPECT_TRUE(screen.viewer.paused());
    hold(kKeySpace);
    EXPECT_FALSE(screen.viewer.paused());
    screen.click("picture");
    const int x = screen.document().pixel->x;
    hold(kKeyRight);
    EXPECT_GT(screen.document().pixel->x, x + 3);
}

TEST(Ui, HomeFramesTheSceneAndTabHidesThePanels) {
    Screen screen;
    screen.press("Home");
    const SceneBounds bounds = boundsOf(*screen.document().scene);
    EXPECT_NEAR(glm::length(screen.document().camera.target - bounds.center()), 0, 1e-9);
    const float width = screen.rect("picture").x1 - screen.rect("picture").x0;
    screen.press("Tab");
    screen.play();
    EXPECT_GT(screen.rect("picture").x1 - screen.rect("picture").x0, 1.5F * width);
    EXPECT_EQ(screen.gui.widgets().count("max-depth"), 0U);
}

TEST(Ui, HelpOpensOnF1AndClosesOnEscape) {
    Screen screen;
    const ByteImage before = screen.picture();
    screen.press("F1");
    EXPECT_GT(countDifferingPixels(before, screen.picture()), before.values().size() / 4);
    screen.press("Escape");
    EXPECT_EQ(screen.picture(), before);
}

TEST(Ui, ThemeAndPresenterChangeThePicture) {
    Screen screen;
    const ByteImage dark = screen.picture();
    screen.press("L");
    EXPECT_FALSE(screen.gui.preferences().dark);
    EXPECT_GT(countDifferingPixels(dark, screen.picture()), dark.values().size() / 4);
    screen.press("L");
    EXPECT_EQ(screen.picture(), dark);
    const WidgetRect before = screen.rect("shadows");
    screen.press("P");
    screen.settle();
    const WidgetRect large = screen.rect("shadows");
    EXPECT_GT(large.y1 - large.y0, 1.4F * (before.y1 - before.y0));
}

TEST(Ui, ABrokenFileLeavesTheOldSceneAndShowsTheError) {
    Screen screen;
    const TemporaryFolder folder;
    writeText(folder / "broken.gltf", "{\"asset\": 3");
    const auto scene = screen.document().scene;
    const ColorImage image = screen.viewer.session().image();
    screen.platform.dropFile(folder / "broken.gltf");
    screen.settle();
    EXPECT_EQ(screen.document().scene, scene);
    EXPECT_EQ(screen.viewer.opened().reference, "homage");
    EXPECT_EQ(screen.viewer.session().image(), image);
    ASSERT_EQ(screen.viewer.notices().size(), 1U);
    EXPECT_EQ(screen.viewer.notices()[0].kind, Notice::Kind::Error);
    EXPECT_NE(screen.viewer.notices()[0].text.find("broken.gltf"), std::string::npos);
    screen.settle();
    screen.click("close notice 0");
    EXPECT_TRUE(screen.viewer.notices().empty());
}

TEST(Ui, TypingAFileNameTriggersNoKeysAndEnterOpensIt) {
    Screen screen;
    screen.press("Ctrl+O");
    screen.settle();
    screen.click("file name");
    for (const char letter : std::string("phongrst1")) {
        screen.platform.key(std::toupper(letter), true);
        screen.platform.text(std::string(1, letter));
        screen.platform.key(std::toupper(letter), false);
    }
    screen.play();
    EXPECT_TRUE(screen.document().render.trace.shadows);
    EXPECT_TRUE(screen.document().render.trace.reflections);
    EXPECT_FALSE(screen.gui.preferences().presenter);
    for (int i = 0; i < 4; ++i) screen.platform.chord({.key = kKeyBackspace});
    screen.platform.text(".gltf");
    screen.press("Enter");
    screen.settle();
    EXPECT_EQ(screen.viewer.opened().path.filename(), "phong.gltf");
    EXPECT_EQ(screen.viewer.notices().size(), 0U);
}

TEST(Ui, ClickingWhileAnotherSceneOpensPicksNothingThatIsNotThere) {
    Screen screen("many");
    ASSERT_GT(screen.document().scene->objects.size(), 100U);
    screen.click(screen.middle("picture"));
    screen.gui.execute({"open", {{"scene", "phong"}}});
    const WidgetRect r = screen.rect("picture");
    for (int i = 0; i < 60; ++i) {
        const auto step = static_cast<float>(i) / 60;
        screen.click(Point{r.x0 + (r.x1 - r.x0) * step, r.y0 + (r.y1 - r.y0) * (0.4F + step / 2)});
        if (i == 10) screen.viewer.finishJobs();
        EXPECT_LT(screen.document().selectedObject,
                  static_cast<int>(screen.document().scene->objects.size()));
    }
    screen.settle();
    EXPECT_EQ(screen.viewer.opened().reference, "phong");
}

TEST(Ui, ALampMayGoWhileAPixelIsPicked) {
    Screen screen("shadows");
    screen.click(screen.middle("picture"));
    ASSERT_TRUE(screen.viewer.picked());
    while (!screen.document().scene->lights.empty()) {
        ASSERT_TRUE(screen.gui.execute({"remove-light", {{"light", "0"}}}));
        screen.play();
    }
    screen.settle();
    for (const RayRecord& ray : screen.viewer.picked()->trace.rays) EXPECT_NE(ray.kind, RayKind::Shadow);
}

TEST(Ui, ASmallWindowIsUsableWithEveryDialog) {
    Screen screen("homage", 320, 240);
    EXPECT_GE(screen.viewer.pictureSize().width, 80);
    for (const char* key : {"F1", "F2", "Ctrl+O", "Ctrl+S", "Escape", "P", "Tab", "Tab", "L", "F11"}) {
        screen.press(key);
        screen.settle();
        const ByteImage shown = screen.picture();
        EXPECT_EQ(shown.width(), 320);
        EXPECT_EQ(shown.height(), 240);
    }
    EXPECT_EQ(screen.viewer.notices().size(), 0U);
}

TEST(Ui, AFileThatChangesOnDiskIsLoadedAgainAndKeepsTheView) {
    const TemporaryFolder folder;
    const auto file = folder / "scene.gltf";
    const auto scene = [](const char* red) {
        return std::string(R"({"asset": {"version": "2.0"}, "scene": 0,
          "scenes": [{"nodes": [0], "extras": {"eyeray": {"version": 1, "ambient": [)") +
               red + R"(, 0, 0],
          "settings": ["set exposure=0"]}}}],
          "nodes": [{"extras": {"eyeray": {"shape": 0}}}], "extensionsUsed": ["KHR_implicit_shapes"],
          "extensions": {"KHR_implicit_shapes": {"shapes": [{"type": "sphere", "sphere": {"radius": 1}}]}}})";
    };
    writeText(file, scene("0.25"));
    Screen screen(file.string());
    ASSERT_TRUE(screen.viewer.hasScene());
    const Camera own = screen.document().camera;
    ASSERT_TRUE(screen.gui.execute(Command::parse("orbit yaw=30")));
    ASSERT_TRUE(screen.gui.execute(Command::parse("set max-depth=2")));
    const Camera view = screen.document().camera;
    writeText(file, scene("0.5"));
    screen.press("F5");
    screen.settle();
    EXPECT_EQ(screen.document().scene->ambient.r, 0.5F);
    EXPECT_EQ(screen.document().camera, view);
    EXPECT_EQ(screen.document().render.trace.maxDepth, 2);
    screen.press("Ctrl+R");
    EXPECT_EQ(screen.document().camera, own) << "reset goes back to the scene's own state";
    EXPECT_EQ(screen.document().scene->ambient.r, 0.5F);
}

TEST(Ui, AScreenshotOfTheWindowIsTheWindow) {
    const TemporaryFolder folder;
    Screen screen;
    const ByteImage shown = screen.picture();
    screen.gui.execute({"window-screenshot", {{"file", (folder / "window.png").string()}}});
    screen.play();
    const std::string text = textOf(folder / "window.png");
    const auto read = decodeImage(std::as_bytes(std::span(text)), "window.png");
    EXPECT_EQ(read.pixels, shown);
}

}
}
