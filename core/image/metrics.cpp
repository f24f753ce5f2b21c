#include "core/image/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
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

std::size_t countDifferingPixels(const ByteImage& a, const ByteImage& b) {
    checkSameSize(a, b);
    return std::transform_reduce(a.values().begin(), a.values().end(), b.values().begin(), std::size_t{0},
                                 std::plus<>(),
                                 [](const Rgba8 p, const Rgba8 q) { return p == q ? 0U : 1U; });
}

}
