#pragma once
// Measured curves that are straight where both axes are logarithmic.

#include <optional>
#include <span>

namespace eyeray {

/// Slope of the straight line of least squares through the logarithms; pairs that have none are left out.
/// Nothing for fewer than two different x.
std::optional<double> fittedSlope(std::span<const double> x, std::span<const double> y);

/// y at `at`, straight between the neighbours' logarithms; x ascends. Nothing outside of what was measured,
/// or where a neighbour has no logarithm.
std::optional<double> interpolated(std::span<const double> x, std::span<const double> y, double at);

/// The least x at which the curve comes down to y, likewise.
std::optional<double> firstReach(std::span<const double> x, std::span<const double> y, double level);

}
