#include "core/image/flip.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/srgb.h"

namespace eyeray {
namespace {

using Plane = Pixels<float>;

constexpr float kColorExponent = 0.7F, kFeatureExponent = 0.5F; // qc, qf
constexpr float kKneeError = 0.4F, kKneeValue = 0.95F;          // pc, pt
constexpr double kFeatureWidth = 0.082;                         // degrees

// Linear Rec. 709 to CIE XYZ and back, by the primaries and D65 of IEC 61966-2-1, columns of the matrix
// first.
const DMat3 kToXyz(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750,
                   0.9503041);
const DMat3 kFromXyz = glm::inverse(kToXyz);
const DVec3 kWhite = kToXyz * DVec3(1);

/// Luminance, red-green and blue-yellow: CIELAB's axes without its cube root.
Vec3 toOpponent(const Color& linear) {
    const DVec3 v = kToXyz * DVec3(linear) / kWhite;
    return Vec3(116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z));
}

Color fromOpponent(const Vec3& c) {
    const double y = (c.x + 16.0) / 116;
    return Color(kFromXyz * (kWhite * DVec3(y + c.y / 500.0, y, y - c.z / 200.0)));
}

/// CIELAB with the Hunt effect: colours fade as they darken.
Vec3 toHuntLab(const Color& linear) {
    constexpr double kDelta = 6.0 / 29;
    const DVec3 v = kToXyz * DVec3(linear) / kWhite;
    const auto f = [&](double t) {
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
    };
    const double l = 116 * f(v.y) - 16;
    return Vec3(l, 0.01 * l * 500 * (f(v.x) - f(v.y)), 0.01 * l * 200 * (f(v.y) - f(v.z)));
}

/// Distance for large colour differences. S. Abasi et al. 2020, "Distance metrics for very large color
/// differences", Color Research & Application 45(2).
float hyab(const Vec3& a, const Vec3& b) { return std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// Weights at −radius … radius.
using Kernel = std::vector<float>;

template <class Weight>
Kernel kernelOf(int radius, const Weight& weight) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(static_cast<float>(weight(i)));
    return kernel;
}

float sumOf(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0F); }

/// The picture filtered by across(x)·down(y); beyond its edges the border goes on.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
    const auto pass = [](const Plane& from, const Kernel& kernel, int dx, int dy) {
        const int radius = static_cast<int>(kernel.size()) / 2;
        Plane to(from.width(), from.height());
        for (int y = 0; y < from.height(); ++y)
            for (int x = 0; x < from.width(); ++x) {
                float sum = 0;
                int i = -radius;
                for (const float weight : kernel) {
                    sum += weight * from.at(std::clamp(x + i * dx, 0, from.width() - 1),
                                            std::clamp(y + i * dy, 0, from.height() - 1));
                    ++i;
                }
                to.at(x, y) = sum;
            }
        return to;
    };
    return pass(pass(plane, across, 1, 0), down, 0, 1);
}

/// One Gaussian of a contrast sensitivity: a √(π/b) e^(−π² r²/b), r in degrees.
struct Sensitivity {
    double a, b;
};
// Sums of two for the blue-yellow channel: the paper's table 1.
const std::array<std::vector<Sensitivity>, 3> kSensitivities = {
    {{{1, 0.0047}}, {{1, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}}};
constexpr double kWidestB = 0.04;

Plane seenBySensitivity(const Plane& plane, const std::vector<Sensitivity>& terms, double pixelsPerDegree) {
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(kWidestB / (2 * kPiD * kPiD)) * pixelsPerDegree));
    Plane sum(plane.width(), plane.height());
    double weight = 0;
    for (const Sensitivity& s : terms) {
        const Kernel kernel = kernelOf(radius, [&](int i) {
            const double degrees = i / pixelsPerDegree;
            return std::exp(-kPiD * kPiD * degrees * degrees / s.b);
        });
        const double factor = s.a * std::sqrt(kPiD / s.b);
        weight += factor * sumOf(kernel) * sumOf(kernel);
        const Plane term = filtered(plane, kernel, kernel);
        for (std::size_t i = 0; i < sum.values().size(); ++i)
            sum.values()[i] += static_cast<float>(factor) * term.values()[i];
    }
    for (float& v : sum.values()) v /= static_cast<float>(weight);
    return sum;
}

/// How strongly edges (first derivative) and points (second derivative) stand out of the luminance.
struct Features {
    Plane edges, points;
};

Features featuresOf(const Plane& luminance, double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto bell = [&](int i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    const Kernel smooth = kernelOf(radius, bell);
    // Positive and negative weights, in two dimensions, each add up to one.
    const auto normalised = [&](Kernel kernel) {
        float positive = 0, negative = 0;
        for (const float w : kernel) (w > 0 ? positive : negative) += w;
        for (float& w : kernel) w /= (w > 0 ? positive : -negative) * sumOf(smooth);
        return kernel;
    };
    const Kernel first = normalised(kernelOf(radius, [&](int i) { return -i * bell(i); }));
    const Kernel second =
        normalised(kernelOf(radius, [&](int i) { return (i * i / (deviation * deviation) - 1) * bell(i); }));
    const auto magnitude = [&](const Kernel& derivative) {
        Plane across = filtered(luminance, derivative, smooth);
        const Plane down = filtered(luminance, smooth, derivative);
        for (std::size_t i = 0; i < across.values().size(); ++i)
            across.values()[i] = std::hypot(across.values()[i], down.values()[i]);
        return across;
    };
    return {magnitude(first), magnitude(second)};
}

/// A picture as the metric sees it.
struct Seen {
    std::vector<Vec3> lab;
    Features features;
};

Seen seen(const ByteImage& picture, double pixelsPerDegree) {
    std::array<Plane, 3> channels;
    channels.fill(Plane(picture.width(), picture.height()));
    Plane luminance = channels[0];
    for (std::size_t i = 0; i < picture.values().size(); ++i) {
        const Rgba8& p = picture.values()[i];
        const Vec3 c = toOpponent({decodeSrgb8(p.r), decodeSrgb8(p.g), decodeSrgb8(p.b)});
        for (std::size_t k = 0; k < 3; ++k) channels[k].values()[i] = c[static_cast<int>(k)];
        luminance.values()[i] = (c.x + 16) / 116;
    }
    for (std::size_t k = 0; k < 3; ++k)
        channels[k] = seenBySensitivity(channels[k], kSensitivities[k], pixelsPerDegree);
    Seen result{.lab = {}, .features = featuresOf(luminance, pixelsPerDegree)};
    result.lab.reserve(picture.values().size());
    for (std::size_t i = 0; i < picture.values().size(); ++i) {
        const Vec3 c(channels[0].values()[i], channels[1].values()[i], channels[2].values()[i]);
        result.lab.push_back(toHuntLab(glm::clamp(fromOpponent(c), Color(0), Color(1))));
    }
    return result;
}

/// Colour differences mapped to 0 … 1: most of the range for those that are small.
float colorError(float distance) {
    static const float kLargest = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), kColorExponent);
    const float error = std::pow(distance, kColorExponent), knee = kKneeError * kLargest;
    if (error < knee) return kKneeValue / knee * error;
    return kKneeValue + (error - knee) / (kLargest - knee) * (1 - kKneeValue);
}

}

Pixels<float> flip(const ByteImage& reference, const ByteImage& test, double pixelsPerDegree) {
    if (reference.width() != test.width() || reference.height() != test.height())
        throw InputError{"comparison",
                         fmt::format("{}x{} and {}x{} pixels", reference.width(), reference.height(),
                                     test.width(), test.height()),
                         "compare pictures of one size"};
    const Seen a = seen(reference, pixelsPerDegree), b = seen(test, pixelsPerDegree);
    Pixels<float> result(reference.width(), reference.height());
    for (std::size_t i = 0; i < result.values().size(); ++i) {
        const auto difference = [&](const Plane& p, const Plane& q) {
            return std::fabs(p.values()[i] - q.values()[i]);
        };
        const float feature = std::max(difference(a.features.edges, b.features.edges),
                                       difference(a.features.points, b.features.points));
        const float weight = std::min(1.0F, std::pow(feature / std::sqrt(2.0F), kFeatureExponent));
        const float color = std::clamp(colorError(hyab(a.lab[i], b.lab[i])), 0.0F, 1.0F);
        result.values()[i] = std::pow(color, 1 - weight);
    }
    return result;
}

double meanFlip(const Pixels<float>& differences) {
    if (differences.empty()) return 0;
    return std::accumulate(differences.values().begin(), differences.values().end(), 0.0) /
           static_cast<double>(differences.values().size());
}

}
