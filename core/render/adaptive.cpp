#include "core/render/adaptive.h"

#include <algorithm>
#include <bit>

namespace eyeray {
namespace {

constexpr int kNearReach = 2, kWideReach = 16; // pixels to each side

/// Sums of values over rectangles of a picture, from a summed-area table: F. Crow 1984, "Summed-Area Tables
/// for Texture Mapping".
class AreaSums {
public:
    AreaSums(std::span<const double> values, int width, int height)
        : width_(width), height_(height),
          sums_((static_cast<std::size_t>(width) + 1) * (static_cast<std::size_t>(height) + 1), 0.0) {
        std::size_t next = 0;
        for (int y = 0; y < height; ++y) {
            double row = 0;
            for (int x = 0; x < width; ++x) {
                row += values[next++];
                sums_[index(x + 1, y + 1)] = sums_[index(x + 1, y)] + row;
            }
        }
    }

    /// Mean over the square of pixels up to `reach` from one whose own value is left out unless it is alone.
    double meanAround(int x, int y, int reach, double own) const {
        const int x0 = std::max(x - reach, 0), x1 = std::min(x + reach + 1, width_);
        const int y0 = std::max(y - reach, 0), y1 = std::min(y + reach + 1, height_);
        const double sum =
            sums_[index(x1, y1)] - sums_[index(x0, y1)] - sums_[index(x1, y0)] + sums_[index(x0, y0)];
        const int others = (x1 - x0) * (y1 - y0) - 1;
        return others > 0 ? std::max(0.0, sum - own) / others : own;
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) +
               static_cast<std::size_t>(x);
    }
    int width_, height_;
    std::vector<double> sums_;
};

std::vector<double> surroundingVariancesOf(const Film& film, int passes, const DisplaySettings& display) {
    return surroundingVariances(film.displayedVariances(passes, display), film.width(), film.height(),
                                passes);
}

}

bool isAdaptiveStage(int passes) {
    return passes >= kAdaptivePilot && std::has_single_bit(static_cast<unsigned>(passes));
}

std::vector<double> surroundingVariances(std::span<const double> variances, int width, int height,
                                         int passes) {
    const AreaSums sums(variances, width, height);
    const double weight = static_cast<double>(kAdaptivePilot) / passes; // of the wide mean
    std::vector<double> around;
    around.reserve(variances.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double own = variances[around.size()];
            const double near = sums.meanAround(x, y, kNearReach, own);
            const double wide = sums.meanAround(x, y, kWideReach, own);
            around.push_back((near + weight * wide) / (1 + weight));
        }
    return around;
}

std::vector<int> nextLimits(std::span<const double> variances, std::span<const int> samples, int passes,
                            double error) {
    std::vector<int> limits(samples.begin(), samples.end());
    for (std::size_t i = 0; i < limits.size(); ++i)
        if (limits[i] == passes)
            limits[i] = static_cast<int>(
                std::clamp(std::ceil(variances[i] / (error * error)), 1.0 * passes, 2.0 * passes));
    return limits;
}

std::vector<int> likelySamples(const Film& film, int passes, double error, const DisplaySettings& display,
                               int most) {
    const std::vector<double> variances = surroundingVariancesOf(film, passes, display);
    const double least = std::min(kAdaptivePilot, most);
    std::vector<int> samples(variances.size());
    std::transform(variances.begin(), variances.end(), samples.begin(), [&](double variance) {
        return static_cast<int>(std::clamp<double>(std::ceil(variance / (error * error)), least, most));
    });
    return samples;
}

void decideSamples(Film& film, int passes, double error, const DisplaySettings& display) {
    film.limit(
        nextLimits(surroundingVariancesOf(film, passes, display), film.samples(passes), passes, error));
}

}
