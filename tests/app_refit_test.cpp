// labels: ui
// The index of the scene shown: it follows objects that are dragged and is built anew once they are let go,
// and of a few objects it is another for another method.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "app/viewer/viewer.h"

namespace eyeray {
namespace {

class Dragging : public testing::Test {
protected:
    Dragging() {
        viewer.setPictureSize(64, 36);
        viewer.openInBackground("many", {Command::parse("set samples=1")});
        viewer.finishJobs();
    }

    void drag(double along) {
        const std::string by = std::to_string(along);
        EXPECT_TRUE(viewer.execute(Command::parse("move object=100 by=" + by + ",0,0"), "drag"));
        viewer.finishRendering(1);
    }

    Viewer viewer{2};
};

TEST_F(Dragging, RefitsUntilTheObjectIsLetGo) {
    drag(0.1);
    drag(0.1);
    const auto dragged = viewer.world();
    EXPECT_TRUE(dragged->refitted);
    EXPECT_EQ(dragged->scene, viewer.document().scene);
    const ColorImage before = viewer.session().image();
    viewer.endGesture();
    viewer.update();
    viewer.finishRendering(1);
    EXPECT_FALSE(viewer.world()->refitted);
    EXPECT_EQ(viewer.shownWorld(), viewer.world());
    EXPECT_EQ(viewer.world()->scene, dragged->scene);
    EXPECT_EQ(viewer.session().image(), before);
}

TEST_F(Dragging, IsSeenThoughEveryFrameMovesTheObject) {
    std::set<std::shared_ptr<const World>> shown;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (shown.size() < 5 && std::chrono::steady_clock::now() < end) {
        EXPECT_TRUE(viewer.execute(Command::parse("move object=100 by=0.001,0,0"), "drag"));
        viewer.update();
        shown.insert(viewer.shownWorld());
    }
    EXPECT_EQ(shown.size(), 5U);
    viewer.finishJobs();
    EXPECT_EQ(viewer.world()->scene, viewer.document().scene);
}

/// The indices of a scene's Worlds while the method changes.
class ChangingTheMethod : public testing::Test {
protected:
    AccelKind indexAfter(const std::string& scene, const char* method) {
        if (opened_ != scene) viewer.openInBackground(opened_ = scene, {});
        viewer.finishJobs();
        EXPECT_TRUE(viewer.execute(Command::parse(fmt::format("set method={}", method))));
        viewer.finishJobs();
        return viewer.world()->accelKind;
    }

    Viewer viewer{2};

private:
    std::string opened_;
};

TEST_F(ChangingTheMethod, ChangesTheIndexOfAFewObjects) {
    EXPECT_EQ(indexAfter("bubble", "path"), AccelKind::Bvh8);
    EXPECT_EQ(indexAfter("bubble", "whitted"), AccelKind::Brute);
    EXPECT_EQ(indexAfter("bubble", "distributed"), AccelKind::Bvh8);
    EXPECT_TRUE(viewer.execute(Command::parse("set accel=bvh2")));
    EXPECT_EQ(indexAfter("bubble", "local"), AccelKind::Bvh2) << "unless one was asked for";
}

TEST_F(ChangingTheMethod, LeavesTheWorldOfOthersAsItIs) {
    EXPECT_EQ(indexAfter("flake", "whitted"), AccelKind::Bvh8);
    const auto before = viewer.world();
    EXPECT_EQ(indexAfter("flake", "path"), AccelKind::Bvh8);
    EXPECT_EQ(viewer.world(), before);
}

TEST_F(Dragging, IsWhatRefitsForAMoveAloneBuildsAnew) {
    EXPECT_TRUE(viewer.execute(Command::parse("move object=100 by=0.1,0,0")));
    viewer.finishJobs();
    EXPECT_FALSE(viewer.world()->refitted);
}

}
}
