#pragma once
// How wrong a picture is, by all measures at once, and where.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/image/pixels.h"
#include "core/render/display.h"
#include "core/study/ticks.h"

namespace eyeray {

/// Of linear light: root mean square, mean square as a share of what is there, and what 95 of 100 values stay
/// below. As displayed (0 to 1): root mean square, the same share, and ꟻLIP.
enum class ErrorMetric : std::uint8_t { Rmse, RelativeMse, Percentile95, ShownRmse, ShownPercentile95, Flip };
inline constexpr std::size_t kErrorMetrics = 6;
inline constexpr std::array<std::string_view, kErrorMetrics> kErrorMetricNames = {
    "rmse", "relmse", "p95", "shown-rmse", "shown-p95", "flip"};
inline constexpr std::array<std::string_view, kErrorMetrics> kErrorMetricLabels = {
    "RMSE of linear light", "relative MSE of linear light", "95th percentile of linear light",
    "RMSE as displayed",    "95th percentile as displayed", "FLIP, mean"};

/// Power of the number of samples that the metric falls with where they are independent.
constexpr double monteCarloSlope(ErrorMetric metric) {
    return metric == ErrorMetric::RelativeMse ? -1 : -0.5;
}

struct PictureErrors {
    std::array<double, kErrorMetrics> values{};
    double operator[](ErrorMetric metric) const { return values[static_cast<std::size_t>(metric)]; }
};

/// Throws InputError if the sizes differ.
PictureErrors errorsOf(const ColorImage& reference, const ColorImage& test, const DisplaySettings&);

/// The largest difference of a channel of each pixel, of linear light times 2^exposure, in colours of
/// heatColor along the axis.
ByteImage differencePicture(const ColorImage& reference, const ColorImage& test, double exposure,
                            const Axis&);

/// What the colours of the axis stand for, as an SVG.
std::string svgOfHeat(const Axis&, const std::string& title);

}
