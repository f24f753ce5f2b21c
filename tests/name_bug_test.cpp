// labels: unit
// A picture made with a known fault is told from the others.

#include "core/study/name_bug.h"

#include <gtest/gtest.h>

#include "app/viewer/bug_naming.h"
#include "core/transport/integrator.h"
#include "tests/app_documents.h"

namespace eyeray {
namespace {

class NameBug : public Documents {
protected:
    static constexpr int kWidth = 96, kHeight = 54;

    /// What a student's program with the fault would have written.
    ByteImage pictureWith(FaultSet faults) const {
        RenderSettings settings = homage.render;
        settings.trace.faults = faults;
        settings.width = kWidth;
        settings.height = kHeight;
        const TraceContext context(world_, homage.camera, settings.trace, kWidth, kHeight, 7, {});
        const auto integrator = makeIntegrator(settings.trace.method);
        const FloatEnvironment environment;
        const TileResult result = integrator->renderTile(context, {0, 0, kWidth, kHeight}, 0);
        ByteImage picture(kWidth, kHeight);
        display(result.radiance, shownDisplay(settings), picture.values());
        return picture;
    }

    NamedBug named(const ByteImage& picture) {
        return *nameBug(world_, homage.camera, homage.render, picture, pool_);
    }

    std::shared_ptr<const World> world_ = buildWorld(homage.scene, buildSettings(homage));
    ThreadPool pool_{1};
};

TEST_F(NameBug, PutsTheFaultThatThePictureHasFirst) {
    for (const Fault fault : {Fault::FlippedRows, Fault::ReflectionSign, Fault::EtaNotFlipped,
                              Fault::HorizontalFov, Fault::NoGamma}) {
        const NamedBug bug = named(pictureWith(fault));
        EXPECT_EQ(toText(bug.ranked.front().faults), toText(fault));
        EXPECT_TRUE(bug.firstWrong);
        EXPECT_EQ(bug.ranked.size(), static_cast<std::size_t>(kFaults) + 1);
    }
}

TEST_F(NameBug, FindsNothingWrongInARightPicture) {
    const NamedBug bug = named(pictureWith({}));
    const auto none = std::find_if(bug.ranked.begin(), bug.ranked.end(),
                                   [](const FaultMatch& match) { return match.faults.empty(); });
    EXPECT_EQ(none->rmse, bug.ranked.front().rmse) << "no fault explains it better";
}

TEST_F(NameBug, EndsWhenItIsToldTo) {
    const std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(nameBug(world_, homage.camera, homage.render, pictureWith({}), pool_, stop.get_token()));
}

}
}
