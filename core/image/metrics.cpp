#include "core/image/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "core/base/errors.h"

namespace eyeray {
namespace {

template <class T>
void checkSameSize(const Pixels<T>& a, const Pixels<T>& b) {
    if (a.width() != b.width() || a.height() != b.height())
        throw InputError{"comparison",
                         fmt::format("{}x{} and {}x{} pixels", a.width(), a.height(), b.width(), b.height()),
                         "compare pictures of one size"};
}

}

double rmse(const ColorImage& a, const ColorImage& b) {
    checkSameSize(a, b);
    if (a.empty()) return 0;
    const double sum = std::transform_reduce(a.values().begin(), a.values().end(), b.values().begin(), 0.0,
                                             std::plus<>(), [](const Color& p, const Color& q) {
                                                 const DVec3 difference = DVec3(p) - DVec3(q);
                                                 return glm::dot(difference, difference);
                                             });
    return std::sqrt(sum / (3 * static_cast<double>(a.values().size())));
}

double relativeMse(const ColorImage& reference, const ColorImage& test) {
    constexpr double kFloor = 0.01; // dark pixels count as if they were as bright as its root
    checkSameSize(reference, test);
    if (reference.empty()) return 0;
    const double sum =
        std::transform_reduce(reference.values().begin(), reference.values().end(), test.values().begin(),
                              0.0, std::plus<>(), [](const Color& r, const Color& t) {
                                  const DVec3 truth(r), difference = DVec3(t) - truth;
                                  const DVec3 relative = difference * difference / (truth * truth + kFloor);
                                  return relative.x + relative.y + relative.z;
                              });
    return sum / (3 * static_cast<double>(reference.values().size()));
}

namespace {

/// Of every channel; all NaN if one is.
std::vector<double> differences(const ColorImage& a, const ColorImage& b) {
    checkSameSize(a, b);
    std::vector<double> result;
    result.reserve(3 * a.values().size());
    bool anyNan = false;
    for (std::size_t i = 0; i < a.values().size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float p = a.values()[i][c], q = b.values()[i][c];
            result.push_back(p == q ? 0 : std::fabs(static_cast<double>(p) - static_cast<double>(q)));
            anyNan |= std::isnan(result.back());
        }
    if (anyNan) std::fill(result.begin(), result.end(), std::numeric_limits<double>::quiet_NaN());
    return result;
}

}

double maxDifference(const ColorImage& a, const ColorImage& b) {
    const std::vector<double> all = differences(a, b);
    return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
}

double percentile95(const ColorImage& a, const ColorImage& b) {
    std::vector<double> all = differences(a, b);
    if (all.empty()) return 0;
    const auto rank = static_cast<std::ptrdiff_t>(all.size() * 95 / 100);
    std::nth_element(all.begin(), all.begin() + rank, all.end());
    return all[static_cast<std::size_t>(rank)];
}

int maxByteDifference(const ByteImage& a, const ByteImage& b) {
    checkSameSize(a, b);
    return std::transform_reduce(
        a.values().begin(), a.values().end(), b.values().begin(), 0,
        [](int x, int y) { return std::max(x, y); },
        [](const Rgba8 p, const Rgba8 q) {
            return std::max(
                {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b), std::abs(p.a - q.a)});
        });
}

bool clearlyDiffers(const Rgba8& a, const Rgba8& b) {
    constexpr int kSlight = 2;
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > kSlight;
}

std::size_t countDifferingPixels(const ByteImage& a, const ByteImage& b) {
    checkSameSize(a, b);
    return std::transform_reduce(a.values().begin(), a.values().end(), b.values().begin(), std::size_t{0},
                                 std::plus<>(),
                                 [](const Rgba8 p, const Rgba8 q) { return p == q ? 0U : 1U; });
}

}
