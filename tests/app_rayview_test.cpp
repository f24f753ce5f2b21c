// labels: ui
#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/gui/layout.h"
#include "core/image/decode.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

constexpr int kFloor = 0; // object of the scene homage

/// The window with the rays in space beside the picture.
class ExplainingScreen : public Screen {
public:
    explicit ExplainingScreen(const std::string& scene = "homage", int width = 1100, int height = 760)
        : Screen(scene, width, height) {
        execute("explain on=on");
        settle();
    }

    void execute(const std::string& command) {
        if (!gui.execute(Command::parse(command))) throw std::runtime_error(command);
        play();
    }
    void pick(PixelPosition pixel) {
        execute(fmt::format("pick x={} y={}", pixel.x, pixel.y));
        settle();
    }
    const RayView& view() { return gui.rayPane().view(); }
    const std::vector<RayRecord>& rays() const { return viewer.picked()->trace.rays; }

    /// Where a point relative to the World's origin stands in the window.
    Point place(const Vec3& p) {
        const WidgetRect r = rect("rays in space");
        const auto at = view().projection()->point(p);
        if (!at) throw std::runtime_error("behind the outside camera");
        return {r.x0 + at->at.x, r.y0 + at->at.y};
    }
    using Screen::place;

    /// The pixel, of every tenth, whose sample has the highest score(rays).
    template <class Score>
    PixelPosition bestPixel(const Score& score) {
        const PictureSize size = viewer.pictureSize();
        PixelPosition best;
        std::ptrdiff_t highest = 0;
        for (int y = 2; y < size.height; y += 10)
            for (int x = 2; x < size.width; x += 10) {
                const std::ptrdiff_t now = score(raysOf(x, y, 0));
                if (now > highest) best = {x, y};
                highest = std::max(highest, now);
            }
        return best;
    }
    PixelPosition pixelOfManyRays() {
        return bestPixel([](const std::vector<RayRecord>& rays) { return ending(rays, RayEnd::Hit); });
    }
    static std::ptrdiff_t ending(const std::vector<RayRecord>& rays, RayEnd end) {
        return std::count_if(rays.begin(), rays.end(), [&](const RayRecord& ray) { return ray.end == end; });
    }
};

TEST(RayView, ItsArrowsRunBetweenTheRecordsOwnPoints) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOfManyRays());
    const auto& rays = screen.rays();
    const auto& arrows = screen.view().arrows();
    ASSERT_GT(rays.size(), 10U);
    ASSERT_EQ(arrows.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(arrows[i].ray, static_cast<int>(i));
        EXPECT_EQ(arrows[i].kind, rays[i].kind);
        EXPECT_EQ(arrows[i].from, rays[i].origin);
        if (rays[i].end == RayEnd::Hit) {
            EXPECT_EQ(arrows[i].to, rays[i].hit.position);
        }
        if (rays[i].kind == RayKind::Shadow && std::isfinite(rays[i].t)) {
            EXPECT_EQ(arrows[i].to, rays[i].origin + rays[i].t * rays[i].direction);
        }
    }
}

TEST(RayView, EveryVertexOfThePickedPixelIsDrawnWhereItIsProjected) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOfManyRays());
    const auto& sketch = screen.view().sketch();
    const Projection& projection = *screen.view().projection();
    const auto& arrows = screen.view().arrows();
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        const auto tip = projection.point(arrows[i].to);
        if (arrows[i].end != RayEnd::Hit || !tip) continue;
        if (tip->at.x < 0 || tip->at.y < 0 || tip->at.x > static_cast<float>(projection.width()) ||
            tip->at.y > static_cast<float>(projection.height()))
            continue;
        float nearest = 1e9F;
        for (const SketchPath& path : sketch.paths)
            if (path.tag == static_cast<int>(i))
                for (const Vec2& p : path.points) nearest = std::min(nearest, glm::length(p - tip->at));
        EXPECT_LT(nearest, 0.1F) << "ray " << i;
    }
}

TEST(RayView, TheEyeRayGoesThroughThePickedPixelOfTheImagePlane) {
    ExplainingScreen screen;
    const PixelPosition pixel = screen.pixelOf(kMirrorBall);
    screen.pick(pixel);
    const PictureSize size = screen.viewer.pictureSize();
    const World& world = *screen.viewer.world();
    const ImagePlane plane =
        imagePlaneOf(screen.document().camera, world.origin, static_cast<double>(size.width) / size.height,
                     screen.document().camera.distance());
    const DVec3 through = plane.point(DVec2(pixel.x, pixel.y) + 0.5, size.width, size.height) - plane.eye;
    EXPECT_NEAR(glm::dot(glm::normalize(through), DVec3(screen.rays()[0].direction)), 1, 1e-7);
    const DVec2 half = imagePlaneHalfExtents(screen.document().camera.verticalFov,
                                             static_cast<double>(size.width) / size.height);
    EXPECT_NEAR(glm::length(plane.corners[1] - plane.corners[0]), 2 * half.x * plane.scale, 1e-9);
    EXPECT_NEAR(glm::length(plane.corners[3] - plane.corners[0]), 2 * half.y * plane.scale, 1e-9);
}

Ink inkOf(const Sketch& sketch, int tag) {
    for (const SketchPath& path : sketch.paths)
        if (path.tag == tag && path.width == 0) return path.ink; // its head or its vertex
    return Ink(0);
}

TEST(RayView, BlockedLightRaysLookOtherThanThoseThatArrive) {
    ExplainingScreen screen("shadows");
    screen.pick(screen.bestPixel([](const std::vector<RayRecord>& rays) {
        return ExplainingScreen::ending(rays, RayEnd::Blocked) *
               ExplainingScreen::ending(rays, RayEnd::Unblocked);
    }));
    const auto& arrows = screen.view().arrows();
    const auto inksOf = [&](std::size_t arrow) {
        std::vector<Ink> inks;
        for (const SketchPath& path : screen.view().sketch().paths)
            if (path.tag == static_cast<int>(arrow)) inks.push_back(path.ink);
        return inks;
    };
    const auto sameHue = [](const Ink& a, const Ink& b) { return glm::length(Vec3(a) - Vec3(b)) < 0.05F; };
    int blocked = 0, reaching = 0;
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        if (arrows[i].kind != RayKind::Shadow) continue;
        for (std::size_t j = 0; j < arrows.size(); ++j) {
            if (arrows[i].end != RayEnd::Blocked || arrows[j].end != RayEnd::Unblocked) continue;
            const auto of = inksOf(i), other = inksOf(j);
            EXPECT_FALSE(sameHue(of.back(), inkOf(screen.view().sketch(), static_cast<int>(j))));
            EXPECT_GT(other.size(), 0U);
        }
        blocked += arrows[i].end == RayEnd::Blocked;
        reaching += arrows[i].end == RayEnd::Unblocked;
        if (arrows[i].end == RayEnd::Blocked) {
            const float way = glm::length(arrows[i].to - arrows[i].from);
            EXPECT_LT(glm::length(arrows[i].blocker - arrows[i].from), way);
            EXPECT_NEAR(glm::length(arrows[i].blocker - arrows[i].from) +
                            glm::length(arrows[i].to - arrows[i].blocker),
                        way, 1e-4 * way);
        }
    }
    EXPECT_GT(blocked, 0);
    EXPECT_GT(reaching, 0);
}

TEST(RayView, SelectingARayChangesOnlyWhatMarksIt) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOf(kMirrorBall));
    const auto pathsBut = [&](int first, int second) {
        std::vector<std::vector<Vec2>> points;
        for (const SketchPath& path : screen.view().sketch().paths)
            if (path.tag >= 0 && path.tag != first && path.tag != second) points.push_back(path.points);
        return points;
    };
    const auto before = pathsBut(0, 2);
    const std::uint64_t version = screen.viewer.status().counts.total();
    screen.execute("select-ray index=2");
    EXPECT_EQ(pathsBut(0, 2), before);
    EXPECT_EQ(screen.viewer.status().counts.total(), version);
    EXPECT_EQ(screen.viewer.selectedRay(), 2);
}

TEST(RayView, AClickNearAnArrowSelectsItsRay) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOfManyRays());
    const WidgetRect area = screen.rect("rays in space");
    int selected = 0;
    for (std::size_t i = 1; i < screen.rays().size(); ++i) {
        const RayRecord& ray = screen.rays()[i];
        if (ray.end != RayEnd::Hit) continue;
        const Point at = screen.place(0.5F * (ray.origin + ray.hit.position));
        const int nearest = arrowAt(*screen.view().projection(), screen.view().arrows(),
                                    {std::floor(at.x) - area.x0, std::floor(at.y) - area.y0}, 8);
        if (nearest != static_cast<int>(i)) continue; // another runs over it there
        screen.click(Point{std::floor(at.x), std::floor(at.y)});
        EXPECT_EQ(screen.viewer.selectedRay(), static_cast<int>(i));
        ++selected;
    }
    EXPECT_GT(selected, 2);
}

TEST(RayView, OrbitingItLeavesThePictureUntouched) {
    ExplainingScreen screen;
    const Camera camera = screen.document().camera;
    const ColorImage image = screen.viewer.session().image();
    const Camera outside = screen.gui.rayPane().view().outside().camera();
    const Point from = screen.middle("rays in space");
    screen.drag(0, from, {from.x + 60, from.y + 20});
    EXPECT_NE(screen.view().outside().camera().eye, outside.eye);
    EXPECT_NEAR(screen.view().outside().camera().distance(), outside.distance(), 1e-9);
    screen.drag(2, from, {from.x + 30, from.y});
    screen.platform.moveMouse(from.x, from.y);
    screen.platform.wheel(0, 1);
    screen.settle();
    EXPECT_NEAR(screen.view().outside().camera().distance(), 0.9 * outside.distance(), 1e-9);
    EXPECT_EQ(screen.document().camera, camera);
    EXPECT_EQ(screen.viewer.session().image(), image);
    EXPECT_FALSE(screen.viewer.canUndo());
}

TEST(RayView, AMovedCameraCopiesNoMeshAgain) {
    ExplainingScreen screen;
    const std::size_t copied = screen.view().meshes().copiedMeshes();
    EXPECT_GT(copied, 0U);
    screen.execute("orbit yaw=20");
    screen.execute("rayview yaw=40");
    screen.settle();
    EXPECT_EQ(screen.view().meshes().copiedMeshes(), copied);
    screen.execute("move object=3 by=0.2,0,0");
    screen.settle();
    EXPECT_EQ(screen.view().meshes().copiedMeshes(), copied) << "nor does an object that moves";
}

TEST(RayView, EachStandSeesTheEyeAndTheTarget) {
    ExplainingScreen screen;
    for (const char* stand : {"frame", "top", "side", "front", "follow"}) {
        screen.execute(fmt::format("rayview view={}", stand));
        const Projection& projection = *screen.view().projection();
        const DVec3 origin = screen.viewer.world()->origin;
        for (const DVec3& p : {screen.document().camera.eye, screen.document().camera.target}) {
            const auto at = projection.point(p - origin);
            ASSERT_TRUE(at) << stand;
            EXPECT_GT(at->at.x, 0) << stand;
            EXPECT_GT(at->at.y, 0) << stand;
            EXPECT_LT(at->at.x, projection.width()) << stand;
            EXPECT_LT(at->at.y, projection.height()) << stand;
        }
    }
    const DVec3 before = screen.view().outside().camera().eye;
    screen.execute("pan right=1");
    EXPECT_GT(glm::length(screen.view().outside().camera().eye - before), 0.5) << "it follows";
}

TEST(RayView, ShowsTheRaysOfARowAColumnAndAGridUpToACap) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOf(kFloor));
    const auto samples = [&] {
        int most = -1;
        for (const Arrow& arrow : screen.view().arrows()) most = std::max(most, arrow.sample);
        return most + 1;
    };
    EXPECT_EQ(samples(), 1);
    const PictureSize size = screen.viewer.pictureSize();
    screen.execute("rayview show=row step=40");
    EXPECT_NEAR(samples(), size.width / 40.0, 1);
    const PixelPosition pixel = *screen.document().pixel;
    const auto& arrows = screen.view().arrows();
    for (const Arrow& arrow : arrows) {
        if (arrow.kind != RayKind::Eye) continue;
        const auto& first = arrows.front();
        // all in one plane through the eye
        EXPECT_EQ(arrow.from, first.from);
    }
    EXPECT_EQ(arrows.front().to, screen.rays()[0].hit.position) << "the picked pixel " << pixel.x << " first";
    screen.execute("rayview show=column step=40");
    EXPECT_NEAR(samples(), size.height / 40.0, 1);
    screen.execute("rayview show=grid step=1");
    EXPECT_LE(samples(), 201);
    EXPECT_LE(screen.view().arrows().size(), 1001U);
    EXPECT_GT(samples(), 20);
    screen.execute("rayview show=pixel");
    EXPECT_EQ(samples(), 1);
}

TEST(RayView, AnglesAtTheHitAreThoseOfTheRecord) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOf(kMirrorBall));
    const auto vectors = vectorsAt(screen.viewer.picked()->trace, 0);
    ASSERT_TRUE(vectors);
    ASSERT_TRUE(vectors->l && vectors->r);
    EXPECT_NEAR(glm::dot(*vectors->r, vectors->n), glm::dot(*vectors->l, vectors->n), 1e-6);
    EXPECT_NEAR(glm::length(*vectors->r), 1, 1e-6);
    EXPECT_NEAR(glm::dot(glm::cross(*vectors->r, *vectors->l), vectors->n), 0, 1e-5);
    const std::string angle =
        fmt::format("v {:.1f}°", degrees(std::acos(static_cast<double>(glm::dot(vectors->v, vectors->n)))));
    const auto& labels = screen.view().sketch().labels;
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const SketchLabel& label) {
        return label.text == angle;
    })) << angle;
}

TEST(RayView, IsSavedAsAPictureThatKnowsItsScene) {
    const TemporaryFolder folder;
    ExplainingScreen screen;
    screen.pick(screen.pixelOfManyRays());
    screen.execute(
        fmt::format("rayview-screenshot file={} width=500 height=400", (folder / "rays.png").string()));
    const std::string bytes = textOf(folder / "rays.png");
    const auto read = decodeImage(std::as_bytes(std::span(bytes)), "rays.png");
    EXPECT_EQ(read.pixels.width(), 500);
    EXPECT_EQ(read.pixels.height(), 400);
    EXPECT_EQ(readPictureState(folder / "rays.png").scene, "homage");
    std::set<int> colors;
    for (const Rgba8& pixel : read.pixels.values()) colors.insert(pixel.r << 16 | pixel.g << 8 | pixel.b);
    EXPECT_GT(colors.size(), 100U);
}

TEST(RayView, IsSavedAsVectorsWhereItsPointsAreProjected) {
    const TemporaryFolder folder;
    ExplainingScreen screen("shadows");
    screen.pick(screen.pixelOf(0));
    screen.execute(fmt::format("rayview-screenshot file={}", (folder / "rays.svg").string()));
    const std::string svg = textOf(folder / "rays.svg");
    ASSERT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    EXPECT_NE(svg.find("<image "), std::string::npos);
    EXPECT_NE(svg.find(">eye 1</text>"), std::string::npos);
    const auto hit = screen.view().projection()->point(screen.view().arrows()[0].to);
    ASSERT_TRUE(hit);
    EXPECT_NE(svg.find(fmt::format("{:.2f},{:.2f} ", hit->at.x, hit->at.y)), std::string::npos);
}

TEST(RayView, IsNotSavedInAnotherFormat) {
    const TemporaryFolder folder;
    ExplainingScreen screen;
    screen.execute(fmt::format("rayview-screenshot file={}", (folder / "rays.exr").string()));
    ASSERT_EQ(screen.viewer.notices().size(), 1U);
    EXPECT_EQ(screen.viewer.notices()[0].kind, Notice::Kind::Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "rays.exr"));
}

TEST(RayView, LayoutNeverLeavesAViewTooSmallAndFillsTheMiddle) {
    for (float width = 60; width < 2000; width += 97)
        for (float height = 60; height < 1300; height += 83) {
            const ExplainLayout layout = explainLayout({{10, 20}, {width, height}}, 17);
            float area = layout.picture.size.x * layout.picture.size.y;
            for (const auto& view : {layout.rays, layout.words}) {
                if (!view) continue;
                area += view->size.x * view->size.y;
                EXPECT_GT(view->size.x, 200);
                EXPECT_GT(view->size.y, 140);
            }
            EXPECT_NEAR(area, width * height, 1);
        }
}

TEST(RayView, IsLeftOutOfAVerySmallWindow) {
    const ExplainingScreen screen("homage", 320, 240);
    EXPECT_EQ(screen.gui.widgets().count("rays in space"), 0U);
    EXPECT_EQ(screen.viewer.notices().size(), 0U);
}

TEST(RayView, IsRememberedBetweenTwoStarts) {
    const TemporaryFolder folder;
    Preferences preferences;
    preferences.explain = true;
    savePreferences(preferences, folder / "preferences");
    EXPECT_EQ(loadPreferences(folder / "preferences"), preferences);
}

TEST(RayView, KeyEShowsAndHidesItAndThePickedPixelStaysOnItsObject) {
    Screen screen("homage", 1100, 760);
    screen.click(screen.place(screen.pixelOf(kMirrorBall)));
    ASSERT_EQ(screen.viewer.picked()->object, kMirrorBall);
    for (int i = 0; i < 4; ++i) {
        screen.press("E");
        screen.settle();
        EXPECT_EQ(screen.gui.widgets().count("rays in space"), i % 2 == 0 ? 1U : 0U);
        ASSERT_TRUE(screen.viewer.picked());
        EXPECT_EQ(screen.viewer.picked()->object, kMirrorBall);
    }
}

TEST(Play, ShowsTheRaysOneAfterTheOther) {
    ExplainingScreen screen;
    screen.pick(screen.pixelOfManyRays());
    const auto arrows = [&] { return screen.view().arrows().size(); };
    const std::size_t all = screen.rays().size();
    const std::uint64_t traced = screen.viewer.status().counts.total();
    screen.execute("play to=start");
    EXPECT_EQ(arrows(), 1U);
    screen.execute("play to=next");
    EXPECT_EQ(arrows(), 2U);
    EXPECT_EQ(screen.viewer.selectedRay(), 1) << "all views mark the ray that has just been traced";
    screen.execute("play to=back");
    EXPECT_EQ(arrows(), 1U);
    screen.settle();
    screen.click("play to=end");
    screen.play();
    EXPECT_EQ(arrows(), all);
    EXPECT_EQ(screen.viewer.status().counts.total(), traced) << "and nothing was rendered anew";
    screen.execute("play to=start");
    screen.pick({3, 3});
    EXPECT_EQ(arrows(), screen.rays().size()) << "another pixel begins with all its rays";
}

TEST(Play, OpensItsViewsAndRunsByItself) {
    Screen screen;
    screen.gui.execute(Command::parse("pick x=200 y=200"));
    screen.settle();
    EXPECT_FALSE(screen.gui.preferences().explain);
    screen.gui.execute(Command::parse("play run=on"));
    screen.settle();
    EXPECT_TRUE(screen.gui.preferences().explain);
    EXPECT_TRUE(screen.gui.widgets().contains("play to=next"));
    EXPECT_TRUE(screen.viewer.player().begun());
}

}
}
