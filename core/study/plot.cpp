#include "core/study/plot.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "core/base/errors.h"

namespace eyeray {
namespace {

/// 0 to 1 from low to high; what the axis cannot show stands at an end.
double shareOnAxis(const Axis& axis, double value) {
    if (axis.scale == Scale::Log && value <= 0) return 0;
    const double share = axis.share(value);
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : (share < 0 ? 0.0 : 1.0);
}

bool isOnAxis(const Axis& axis, double value) {
    return std::isfinite(value) && value >= axis.low && value <= axis.high;
}

}

void fitAxes(Plot& plot, Scale x, Scale y) {
    std::vector<double> xs, ys;
    for (const PlotSeries& series : plot.series)
        for (const PlotPoint& point : series.points) {
            xs.push_back(point.x);
            ys.push_back(point.y);
            if (point.xRange) xs.insert(xs.end(), point.xRange->begin(), point.xRange->end());
            if (point.yRange) ys.insert(ys.end(), point.yRange->begin(), point.yRange->end());
        }
    plot.x = axisAround(x, xs);
    plot.y = axisAround(y, ys);
}

PlotFrame::Place PlotFrame::place(double xValue, double yValue) const {
    const DVec2 share(shareOnAxis(x, xValue), 1 - shareOnAxis(y, yValue));
    return {corner + Vec2(share) * size, isOnAxis(x, xValue) && isOnAxis(y, yValue)};
}

std::array<Vec2, 2> PlotFrame::line(const PlotGuide& guide) const {
    ENSURE(x.scale == Scale::Log && y.scale == Scale::Log);
    // Along the guide, as shares of the axes, with the share along x as the parameter.
    const double rise = guide.slope * std::log10(x.high / x.low) / std::log10(y.high / y.low);
    const double start = y.share(guide.y) - rise * x.share(guide.x);
    double low = 0, high = 1;
    if (rise != 0) {
        low = std::max(low, std::min(-start / rise, (1 - start) / rise));
        high = std::min(high, std::max(-start / rise, (1 - start) / rise));
    }
    const bool outside = low > high || (rise == 0 && (start < 0 || start > 1));
    if (outside) return {corner, corner};
    const auto at = [&](double share) {
        return corner + Vec2(DVec2(share, 1 - (start + rise * share))) * size;
    };
    return {at(low), at(high)};
}

}
