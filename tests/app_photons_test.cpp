// labels: ui
// Photons from the lamps in the window: the picture, the ways in space, the counters.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/rayview/photon_arrows.h"
#include "tests/app_screen.h"

namespace eyeray {
namespace {

constexpr int kPhotons = 30000;

class FromTheLight : public testing::Test {
protected:
    void execute(const std::string& command) {
        if (!screen.gui.execute(Command::parse(command))) throw std::runtime_error(command);
        screen.settle();
    }
    const PhotonPicture& picture() { return *screen.viewer.photons().picture(); }
    const RayView& view() { return screen.gui.rayPane().view(); }

    /// The same photons, sent without a window.
    PhotonFilm sent(double radius, int photons) {
        const PictureSize size = screen.viewer.pictureSize();
        const Camera& camera = screen.document().camera;
        const auto world = screen.viewer.world();
        const double aspect = static_cast<double>(size.width) / size.height;
        const PhotonWalk walk(world, camera, lensOf(camera, world->origin, aspect, radius));
        PhotonFilm film((size.width + kPhotonBlock - 1) / kPhotonBlock,
                        (size.height + kPhotonBlock - 1) / kPhotonBlock);
        ThreadPool pool(1);
        film.add(walk, photons, pool, {});
        return film;
    }

    Screen screen{"cornell", 1100, 760};
};

TEST_F(FromTheLight, ThePictureIsThatOfTheSamePhotonsSentWithoutAWindow) {
    execute(fmt::format("from-light radius=0.4 photons={}", kPhotons));
    const PhotonFilm film = sent(0.4, kPhotons);
    EXPECT_EQ(picture().tally.emitted, static_cast<std::uint64_t>(kPhotons));
    EXPECT_EQ(picture().tally.reached, film.tally().reached);
    EXPECT_GT(picture().tally.reached, 20U);
    EXPECT_EQ(picture().radiance, film.radiance());

    const ByteImage window = screen.picture(),
                    expected = display(film.radiance(), screen.document().render.display);
    const WidgetRect r = screen.rect("picture");
    int lit = 0;
    for (int y = 0; y < expected.height() / 3; ++y) // no legend is there
        for (int x = 0; x < expected.width(); ++x) {
            const float right = (static_cast<float>(x) + 0.5F) / static_cast<float>(expected.width());
            const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(expected.height());
            const Rgba8 shown = window.at(static_cast<int>(r.x0 + right * (r.x1 - r.x0)),
                                          static_cast<int>(r.y0 + down * (r.y1 - r.y0)));
            ASSERT_EQ(shown, expected.at(x, y)) << x << " " << y;
            lit += shown == Rgba8{0, 0, 0, 255} ? 0 : 1;
        }
    EXPECT_GT(lit, 3);
}

TEST_F(FromTheLight, TheWaysOfTheLatestPhotonsAreDrawnInSpace) {
    execute(fmt::format("from-light photons={}", kPhotons));
    const auto arrows = arrowsOf(picture().paths, screen.viewer.world()->radius);
    ASSERT_GT(arrows.size(), PhotonFilm::kLatest);
    ASSERT_EQ(view().arrows().size(), arrows.size());
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        EXPECT_EQ(view().arrows()[i].from, arrows[i].from);
        EXPECT_EQ(view().arrows()[i].to, arrows[i].to);
    }
    std::size_t next = 0;
    for (const PhotonPath& path : picture().paths)
        for (const PhotonStep& step : path.steps) {
            EXPECT_EQ(arrows[next].from, step.from);
            EXPECT_EQ(arrows[next].kind, step.kind);
            ++next;
        }
    execute("from-light on=off");
    EXPECT_TRUE(view().arrows().empty());
}

TEST_F(FromTheLight, TheKeyTurnsItOnAndOffAndOShowsTheTracedPicture) {
    execute("explain on=on");
    const ByteImage traced = screen.picture();
    execute(fmt::format("from-light photons={} on=off", kPhotons));
    screen.press("Shift+L");
    const ByteImage lit = screen.picture();
    EXPECT_NE(lit, traced);
    for (const char* name : {"from-light", "pause photons", "from-light radius", "from-light rate"})
        EXPECT_TRUE(screen.gui.widgets().contains(name)) << name;
    const WidgetRect r = screen.rect("picture");
    const auto sameAbove = [&](const ByteImage& a, const ByteImage& b) {
        for (int y = static_cast<int>(r.y0); y < static_cast<int>(r.y0 + (r.y1 - r.y0) / 4); ++y)
            for (int x = static_cast<int>(r.x0); x < static_cast<int>(r.x1); ++x)
                if (a.at(x, y) != b.at(x, y)) return false;
        return true;
    };
    execute("other on=on");
    EXPECT_TRUE(sameAbove(screen.picture(), traced));
    execute("other on=off");
    EXPECT_TRUE(sameAbove(screen.picture(), lit));
    screen.press("Shift+L");
    EXPECT_FALSE(screen.viewer.photonSettings().on);
    EXPECT_TRUE(sameAbove(screen.picture(), traced));
}

TEST_F(FromTheLight, AnotherLensOrCameraBeginsAnewAndMorePhotonsDoNot) {
    execute(fmt::format("from-light radius=0.2 photons={}", kPhotons));
    execute(fmt::format("from-light photons={}", 2 * kPhotons));
    EXPECT_EQ(picture().radiance, sent(0.2, 2 * kPhotons).radiance());
    execute("from-light radius=0.3");
    EXPECT_EQ(picture().radiance, sent(0.3, 2 * kPhotons).radiance());
    execute("orbit yaw=10");
    EXPECT_EQ(picture().radiance, sent(0.3, 2 * kPhotons).radiance());
    execute("set lens=0.25");
    execute("from-light radius=0");
    EXPECT_EQ(picture().radiance, sent(0.25, 2 * kPhotons).radiance()) << "the camera's own lens";
}

TEST_F(FromTheLight, APauseHoldsThePhotons) {
    execute("pause on=on");
    execute(fmt::format("from-light photons={}", kPhotons));
    EXPECT_FALSE(screen.viewer.photons().ends());
    EXPECT_TRUE(!screen.viewer.photons().picture() || picture().tally.emitted == 0);
    execute("pause on=off");
    EXPECT_EQ(picture().tally.emitted, static_cast<std::uint64_t>(kPhotons));
    execute("from-light on=off");
    EXPECT_EQ(screen.viewer.photons().picture(), nullptr);
}

TEST_F(FromTheLight, WithoutALampItSaysSoAndWaitsForNothing) {
    execute("light light=0 enabled=off");
    execute(fmt::format("from-light photons={}", kPhotons));
    ASSERT_TRUE(screen.viewer.photons().picture());
    EXPECT_FALSE(picture().lamps);
    EXPECT_FALSE(screen.viewer.photons().ends());
}

TEST_F(FromTheLight, WrongValuesAreRefused) {
    for (const char* line :
         {"from-light radius=-1", "from-light rate=0", "from-light photons=-5", "from-light x=1"})
        EXPECT_FALSE(screen.gui.execute(Command::parse(line))) << line;
    EXPECT_FALSE(screen.viewer.photonSettings().on);
}

}
}
