#include "core/study/log_fit.h"

#include <cmath>

#include "core/base/errors.h"

namespace eyeray {
namespace {

bool hasLog(double value) { return std::isfinite(value) && value > 0; }

/// y at `at` on the line through two points, all in logarithms.
double between(double x0, double y0, double x1, double y1, double at) {
    const double share = std::log(at / x0) / std::log(x1 / x0);
    return std::exp(std::lerp(std::log(y0), std::log(y1), share));
}

}

std::optional<double> fittedSlope(std::span<const double> x, std::span<const double> y) {
    ENSURE(x.size() == y.size());
    double n = 0, sumX = 0, sumY = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (hasLog(x[i]) && hasLog(y[i])) {
            ++n;
            sumX += std::log(x[i]);
            sumY += std::log(y[i]);
        }
    double square = 0, product = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (hasLog(x[i]) && hasLog(y[i])) {
            const double dx = std::log(x[i]) - sumX / n;
            square += dx * dx;
            product += dx * (std::log(y[i]) - sumY / n);
        }
    return square > 0 ? std::optional(product / square) : std::nullopt;
}

std::optional<double> interpolated(std::span<const double> x, std::span<const double> y, double at) {
    ENSURE(x.size() == y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] == at && hasLog(y[i])) return y[i];
        if (i == 0 || !(x[i - 1] < at && at < x[i])) continue;
        if (!hasLog(y[i - 1]) || !hasLog(y[i]) || !hasLog(x[i - 1])) return std::nullopt;
        return between(x[i - 1], y[i - 1], x[i], y[i], at);
    }
    return std::nullopt;
}

std::optional<double> firstReach(std::span<const double> x, std::span<const double> y, double level) {
    ENSURE(x.size() == y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(y[i] <= level)) continue;
        // Before the first point the curve may have been there already.
        if (i == 0) return y[i] == level ? std::optional(x[i]) : std::nullopt;
        if (!hasLog(y[i - 1]) || !hasLog(y[i]) || !hasLog(x[i - 1])) return std::nullopt;
        return between(y[i - 1], x[i - 1], y[i], x[i], level);
    }
    return std::nullopt;
}

}
