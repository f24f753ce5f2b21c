// labels: ui
// The live chart in the window.

#include <gtest/gtest.h>

#include "app/gui/plot_view.h"
#include "core/image/atomic_file.h"
#include "tests/app_screen.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

class LiveChart : public testing::Test {
protected:
    void execute(const std::string& command) {
        if (!screen.gui.execute(Command::parse(command))) throw std::runtime_error(command);
        screen.play();
    }
    void refine() {
        screen.play();
        screen.viewer.finishRendering(16);
        screen.play();
        screen.play();
    }
    const std::vector<RecordedCurve>& curves() const { return screen.viewer.recording().curves(); }

    Point placeOf(std::size_t curve, std::size_t point) const {
        const Plot plot = plotOf(screen.viewer.recording());
        const WidgetRect r = screen.rect("chart plot");
        const PlotFrame frame = frameOf(plot, {r.x0, r.y0}, {r.x1 - r.x0, r.y1 - r.y0});
        const RecordedPoint& p = curves()[curve].points[point];
        const Vec2 at = frame.place(p.seconds, p.error).at;
        return {at.x, at.y};
    }

    Screen screen{"homage", 1100, 760};
};

TEST_F(LiveChart, KeyDrawsACurveForEachSettingAndAClickReturnsToIt) {
    screen.press("M");
    execute("set samples=16");
    execute("set method=distributed");
    refine();
    ASSERT_EQ(curves().size(), 1U) << "those before had no time for a second sample";
    ASSERT_GE(curves()[0].points.size(), 2U);
    execute("set method=path");
    refine();
    ASSERT_EQ(curves().size(), 2U);
    EXPECT_EQ(curves()[0].name, "distributed d5");
    EXPECT_EQ(curves()[1].name, "path d5");

    screen.click(placeOf(0, curves()[0].points.size() - 1));
    EXPECT_EQ(screen.document().render.trace.method, Method::Distributed);
    screen.press("Ctrl+Z");
    EXPECT_EQ(screen.document().render.trace.method, Method::Path);
}

TEST_F(LiveChart, ButtonsPinColourAndTakeAway) {
    execute("chart on=on");
    execute("set samples=16");
    execute("set method=path");
    refine();
    ASSERT_EQ(curves().size(), 1U);
    const int color = curves()[0].color;
    screen.click("curve pin 0");
    EXPECT_TRUE(curves()[0].pinned);
    screen.click("curve color 0");
    EXPECT_NE(curves()[0].color, color);
    execute("curve n=0 name=noise");
    EXPECT_EQ(curves()[0].name, "noise");
    screen.click("curve right 0");
    ASSERT_TRUE(screen.viewer.recording().reference());
    EXPECT_EQ(screen.viewer.recording().reference()->samples, 16);
    screen.click("curve right 0");
    EXPECT_FALSE(screen.viewer.recording().reference());
    screen.click("curve remove 0");
    EXPECT_TRUE(curves().empty() || curves()[0].points.empty());
}

TEST_F(LiveChart, IsSavedAsSvgAndCsv) {
    const TemporaryFolder folder;
    execute("chart on=on");
    execute("set samples=16");
    execute("set method=path");
    refine();
    const auto svg = folder.path() / "c.svg", csv = folder.path() / "c.csv";
    execute(fmt::format("chart-save file={}", svg.string()));
    execute(fmt::format("chart-save file={}", csv.string()));
    const auto textOf = [](const std::filesystem::path& file) {
        const auto bytes = readFile(file, 1U << 24U);
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    EXPECT_NE(textOf(svg).find("path d5"), std::string::npos);
    EXPECT_EQ(textOf(csv).rfind("curve,samples,seconds,estimated_error,error_to_reference\n", 0), 0U);
    EXPECT_FALSE(screen.gui.execute(Command::parse("chart-save file=c.png")));
    EXPECT_FALSE(screen.gui.execute(Command::parse("curve n=99 pin=on")));
    EXPECT_FALSE(screen.gui.execute(Command::parse("curve pin=on")));
}

}
}
