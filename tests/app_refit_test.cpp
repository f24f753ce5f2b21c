// labels: ui
// Objects that are dragged: the index follows them, and is built anew once they are let go.

#include <gtest/gtest.h>

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

TEST_F(Dragging, IsWhatRefitsForAMoveAloneBuildsAnew) {
    EXPECT_TRUE(viewer.execute(Command::parse("move object=100 by=0.1,0,0")));
    viewer.finishJobs();
    EXPECT_FALSE(viewer.world()->refitted);
}

}
}
