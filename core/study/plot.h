#pragma once
// A chart: points and lines between two axes.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/study/ticks.h"

namespace eyeray {

struct PlotPoint { // NOLINTBEGIN(readability-redundant-member-init): GCC warns of members left out without
    double x = 0, y = 0;
    std::string label = {}; // beside it; none: no label
    std::string hover = {}; // shown while the pointer is on it; lines end in '\n'
    std::optional<std::array<double, 2>> xRange = {}, yRange = {}; // least and most of what was measured
};

enum class PlotMark : std::uint8_t { None, Disc, Square, Triangle, Diamond, Cross };
enum class PlotLine : std::uint8_t { None, Full, Dashed, Broad };

struct PlotSeries {
    std::string name = {}; // in the legend; none: not there
    int color = 0;         // colorOfSeries
    PlotMark mark = PlotMark::Disc;
    PlotLine line = PlotLine::Full;
    std::vector<PlotPoint> points;
};

/// A straight line through a point; its slope is in powers of ten along y for each along x. Log axes alone.
struct PlotGuide {
    double x = 1, y = 1, slope = -0.5;
    std::string label = {};
};

/// A point that an axis cannot show stands at its edge, hollow: 0 on a log axis at the low end, whatever is
/// not finite at the high end. None is left out.
struct Plot {
    std::string title = {}, xTitle = {}, yTitle = {};
    Axis x, y;
    std::vector<PlotSeries> series;
    std::vector<PlotGuide> guides = {};
}; // NOLINTEND(readability-redundant-member-init)

/// Axes around all points of the series and their ranges.
void fitAxes(Plot&, Scale x, Scale y);

/// The rectangle between the axes; y down.
struct PlotFrame {
    Axis x, y;
    Vec2 corner{0}, size{1};

    struct Place {
        Vec2 at;
        bool onAxes; // false: moved to the edge
    };
    Place place(double xValue, double yValue) const;
    /// The two ends of the part of a guide that lies in the frame; equal where none does.
    std::array<Vec2, 2> line(const PlotGuide&) const;
};

struct PlotSize {
    float width = 960, height = 600, letter = 15;
};

/// The chart as a file of its own, or to stand in an HTML page. Light, and dark on screens that prefer it.
std::string svgOf(const Plot&, const PlotSize& = {});

/// Several, each of this size, one below the other.
std::string svgOf(std::span<const Plot>, const PlotSize&);

}
