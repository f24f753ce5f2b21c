// labels: ui
// What is told of the pixel under the pointer, before any click.

#include <gtest/gtest.h>

#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

class HoverScreen : public Screen {
public:
    explicit HoverScreen(const std::string& scene = "homage") : Screen(scene, 1100, 760) {}

    void execute(const std::string& command) {
        if (!gui.execute(Command::parse(command))) throw std::runtime_error(command);
        settle();
    }
    /// Moves the pointer there and waits until what it is over has been traced.
    void moveTo(Point at) {
        platform.moveMouse(at.x, at.y);
        do play();
        while (gui.picture().hover().pending());
        play();
    }
    void hover(PixelPosition pixel) { moveTo(place(pixel)); }
    const std::optional<HoveredPixel>& hovered() const { return gui.picture().hover().pixel(); }
    std::size_t paths() { return gui.rayPane().view().sketch().paths.size(); }
};

TEST(Hover, TellsOfTheVeryPixelUnderThePointerAndPicksNothing) {
    HoverScreen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    const ByteImage before = screen.picture();
    screen.hover(ball);
    ASSERT_TRUE(screen.hovered());
    EXPECT_EQ(screen.hovered()->pixel, ball);
    EXPECT_EQ(screen.hovered()->trace.radiance, screen.viewer.session().retrace(ball.x, ball.y, 0)->radiance);
    EXPECT_FALSE(screen.viewer.picked());
    EXPECT_FALSE(screen.document().pixel);
    const ByteImage told = screen.platform.screenshot();
    EXPECT_NE(told, before);
    screen.moveTo({3, 1});
    EXPECT_FALSE(screen.hovered()) << "the pointer has left";
    EXPECT_EQ(screen.picture(), before);
}

TEST(Hover, FollowsThePointerAndThePicture) {
    HoverScreen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    screen.moveTo({2, 2});
    screen.hover(ball);
    const std::size_t rays = screen.hovered()->trace.rays.size();
    ASSERT_GT(rays, 1U);
    screen.execute("set max-depth=0 shadows=off");
    screen.hover(ball);
    EXPECT_EQ(screen.hovered()->trace.rays.size(), 1U) << "of the new picture";
    screen.hover({ball.x + 40, ball.y});
    EXPECT_EQ(screen.hovered()->pixel, (PixelPosition{ball.x + 40, ball.y}));
}

TEST(Hover, SaysWhatTheRayMeetsOfWhichMaterialAndHowFar) {
    HoverScreen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    screen.hover(ball);
    const Scene& scene = *screen.document().scene;
    const RayRecord& ray = screen.hovered()->trace.rays.front();
    const auto& object = scene.objects[kMirrorBall];
    EXPECT_EQ(metText(scene, ray),
              fmt::format("{}, {}, t = {:.4g} m", object.name,
                          scene.materials[static_cast<std::size_t>(object.material)].name, ray.t));
    EXPECT_EQ(metText(scene, RayRecord{}), "nothing hit");
}

TEST(Hover, ItsRaysAreDrawnPaleAmongThoseInSpace) {
    HoverScreen screen;
    screen.execute("explain on=on");
    screen.picture();
    const std::size_t none = screen.paths();
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    screen.hover(ball);
    EXPECT_GT(screen.paths(), none + screen.hovered()->trace.rays.size());
    EXPECT_TRUE(screen.gui.rayPane().view().arrows().empty()) << "a click there selects none of them";
    screen.click(screen.place(ball));
    screen.settle();
    const auto arrows = screen.gui.rayPane().view().arrows().size();
    EXPECT_EQ(arrows, screen.viewer.picked()->trace.rays.size()) << "picked, it is not drawn twice";
}

TEST(Hover, IsSwitchedOffAndOnByKeyHAndRemembered) {
    HoverScreen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    screen.press("H");
    screen.hover(ball);
    EXPECT_FALSE(screen.hovered());
    const TemporaryFolder folder;
    savePreferences(screen.gui.preferences(), folder / "preferences");
    EXPECT_FALSE(loadPreferences(folder / "preferences").hover);
    screen.press("H");
    screen.hover(ball);
    EXPECT_TRUE(screen.hovered());
}

TEST(Hover, IsSilentWhileAButtonIsDownAndWhereAnotherPictureStands) {
    HoverScreen screen;
    const PixelPosition ball = screen.pixelOf(kMirrorBall);
    for (const char* command : {"rasterised on=on", "compare with=\"max-depth=1\"", "play-grid on=on"}) {
        screen.execute(command);
        screen.moveTo({2, 2});
        screen.hover(ball);
        EXPECT_FALSE(screen.hovered()) << command;
        for (const char* undone :
             {"rasterised on=off", "compare on=off", "play-grid on=off", "explain on=off"})
            screen.execute(undone);
    }
    screen.hover(ball);
    EXPECT_TRUE(screen.hovered());
    screen.platform.mouseButton(0, true);
    screen.play();
    EXPECT_FALSE(screen.hovered());
    screen.platform.mouseButton(0, false);
    screen.play();
}

}
}
