#pragma once
// A chart of core/study/plot.h in the window.

#include <optional>

#include "app/gui/widgets.h"
#include "core/study/plot.h"

namespace eyeray {

/// A point of a plot.
struct PlotPlace {
    std::size_t series = 0, point = 0;
    friend bool operator==(const PlotPlace&, const PlotPlace&) = default;
};

/// Where the axes stand when a plot is drawn over this rectangle.
PlotFrame frameOf(const Plot&, ImVec2 corner, ImVec2 size);

/// Draws the plot over this rectangle of the current window. Returns the point under the pointer, which is
/// drawn larger.
std::optional<PlotPlace> drawPlot(const Widgets&, const Plot&, ImVec2 corner, ImVec2 size);

}
