// labels: unit
#include "core/study/plot.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/study/label_layout.h"
#include "core/study/markup.h"

using namespace eyeray;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const PlotFrame kFrame{{Scale::Log, 0.01, 100}, {Scale::Log, 1e-4, 1}, {50, 20}, {400, 200}};

Plot smallPlot() {
    Plot plot{
        .title = "Speed & accuracy", .xTitle = "seconds", .yTitle = "error", .x = {}, .y = {}, .series = {}};
    plot.series.push_back(
        {.name = "path <b>", .color = 0, .points = {{1, 0.1, "1 \"spp\"", "one\nsample"}, {4, 0.05}}});
    plot.series.push_back({.name = "failed",
                           .color = 1,
                           .mark = PlotMark::Cross,
                           .line = PlotLine::None,
                           .points = {{2, kNan}}});
    plot.guides.push_back({.x = 1, .y = 0.1, .slope = -0.5, .label = "−½"});
    fitAxes(plot, Scale::Log, Scale::Log);
    return plot;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

}

TEST(PlotFrame, PlacesTheEndsOfTheAxesAtItsCorners) {
    EXPECT_EQ(kFrame.place(0.01, 1e-4).at, Vec2(50, 220));
    EXPECT_EQ(kFrame.place(100, 1).at, Vec2(450, 20));
    EXPECT_EQ(kFrame.place(1, 0.01).at, Vec2(250, 120));
    EXPECT_TRUE(kFrame.place(1, 0.01).onAxes);
}

TEST(PlotFrame, LeavesNoPointOut) {
    const double infinity = std::numeric_limits<double>::infinity();
    const auto expectAt = [](double y, float at) {
        const PlotFrame::Place place = kFrame.place(1, y);
        EXPECT_FLOAT_EQ(place.at.y, at) << y;
        EXPECT_FALSE(place.onAxes) << y;
    };
    expectAt(0, 220);
    expectAt(1e-9, 220);
    expectAt(-3, 220);
    expectAt(7, 20);
    expectAt(kNan, 20);
    expectAt(infinity, 20);
}

TEST(PlotFrame, CutsAGuideOfSlopeMinusOneHalfWhereItLeavesTheFrame) {
    const auto ends = kFrame.line({.x = 1, .y = 0.01, .slope = -0.5});
    // Over the four decades from 0.01 to 100, y falls by two: from 0.1 to 0.001.
    EXPECT_LT(glm::distance(ends[0], kFrame.place(0.01, 0.1).at), 1e-3);
    EXPECT_LT(glm::distance(ends[1], kFrame.place(100, 0.001).at), 1e-3);
    const auto steep = kFrame.line({.x = 1, .y = 0.01, .slope = -2});
    EXPECT_LT(glm::distance(steep[0], kFrame.place(0.1, 1).at), 1e-3);
    EXPECT_LT(glm::distance(steep[1], kFrame.place(10, 1e-4).at), 1e-3);
    const auto outside = kFrame.line({.x = 1, .y = 1e3, .slope = -0.1});
    EXPECT_EQ(outside[0], outside[1]);
}

TEST(PlotSvg, HoldsEachPointWithItsLabelAndWhatIsSaidOfIt) {
    const std::string svg = svgOf(smallPlot());
    EXPECT_NE(svg.find("<title>one\nsample</title>"), std::string::npos);
    EXPECT_NE(svg.find("1 &quot;spp&quot;</text>"), std::string::npos);
    EXPECT_NE(svg.find("path &lt;b&gt;</text>"), std::string::npos);
    EXPECT_NE(svg.find("Speed &amp; accuracy</text>"), std::string::npos);
    EXPECT_NE(svg.find("−½</text>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(count(svg, "<svg"), 1U);
    EXPECT_EQ(count(svg, "<g>"), count(svg, "</g>"));
}

TEST(PlotSvg, HasADarkTwinForEachOfItsColours) {
    const std::string svg = svgOf(smallPlot());
    int colours = 0;
    for (const std::string attribute : {"fill", "stroke"})
        for (std::size_t at = svg.find(attribute + "=\"#"); at != std::string::npos;
             at = svg.find(attribute + "=\"#", at + 1)) {
            const std::string used = svg.substr(at, attribute.size() + 10); // fill="#a1b2c3"
            if (at > 0 && svg[at - 1] == '[') continue;                     // of the style itself
            EXPECT_NE(svg.find("svg [" + used + "]{"), std::string::npos) << used;
            ++colours;
        }
    EXPECT_GT(colours, 5);
}

TEST(LabelLayout, PutsNoLabelOnAnotherOnAPointOrOutside) {
    std::vector<LabelledPoint> points;
    points.reserve(40);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 8; ++column)
            points.push_back(
                {{100 + static_cast<float>(column) * 30, 50 + static_cast<float>(row) * 23}, {60, 10}});
    const Vec2 corner(0), size(500, 300);
    const auto labels = layOutLabels(points, corner, size, 4);
    std::size_t placed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!labels[i]) continue;
        ++placed;
        const Vec2 low = *labels[i], high = low + points[i].extent;
        EXPECT_TRUE(low.x >= 0 && low.y >= 0 && high.x <= size.x && high.y <= size.y);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec2 at = points[k].at;
            EXPECT_FALSE(at.x > low.x - 4 && at.x < high.x + 4 && at.y > low.y - 4 && at.y < high.y + 4);
            if (k == i || !labels[k]) continue;
            const Vec2 other = *labels[k], end = other + points[k].extent;
            EXPECT_FALSE(low.x < end.x && other.x < high.x && low.y < end.y && other.y < high.y)
                << i << " " << k;
        }
    }
    EXPECT_GE(placed, 15U);
}

TEST(Markup, EscapesWhatIsReservedAndLeavesOutWhatXmlCannotHold) {
    EXPECT_EQ(escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
    EXPECT_EQ(escaped("ÆΩ€🙂"), "ÆΩ€🙂");
    EXPECT_EQ(escaped(std::string_view("a\0b\x1b\x7f", 5)), "ab\x7f");
    EXPECT_EQ(escaped("\xff\xc0\xaf\xed\xa0\x80\xf5x\xe2\x82"), "x");
}
