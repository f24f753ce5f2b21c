#include "core/study/color_map.h"

#include <algorithm>
#include <array>

#include "core/image/srgb.h"

namespace eyeray {
namespace {

struct Lab {
    double lightness, a, b;
};

Lab fromChroma(double lightness, double chroma, double hue) {
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

/// Linear Rec. 709; channels outside 0 … 1 are beyond what a screen shows. The numbers are Ottosson's.
DVec3 toLinear(const Lab& c) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b);
    const double m = cube(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b);
    const double s = cube(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool isShowable(const DVec3& c) { return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1; }

/// The colour with no more chroma than a screen can show.
Lab showable(double lightness, double chroma, double hue) {
    double lowest = 0, highest = chroma;
    if (isShowable(toLinear(fromChroma(lightness, chroma, hue)))) return fromChroma(lightness, chroma, hue);
    for (int i = 0; i < 30; ++i) {
        const double middle = (lowest + highest) / 2;
        (isShowable(toLinear(fromChroma(lightness, middle, hue))) ? lowest : highest) = middle;
    }
    return fromChroma(lightness, lowest, hue);
}

Rgba8 toBytes(const Lab& c) {
    const DVec3 linear = toLinear(c);
    return {encodeSrgb8(static_cast<float>(linear.x)), encodeSrgb8(static_cast<float>(linear.y)),
            encodeSrgb8(static_cast<float>(linear.z))};
}

/// The way through OKLab: lightness rises steadily while the hue turns from blue over red to yellow.
Lab heatAt(double u) {
    const double hue = radians(270 + 195 * u);
    return showable(0.16 + 0.80 * u, 0.05 + 0.16 * std::sin(kPiD * std::min(1.0, 0.08 + 0.84 * u)), hue);
}

double distance(const Lab& p, const Lab& q) {
    return glm::length(DVec3(p.lightness - q.lightness, p.a - q.a, p.b - q.b));
}

constexpr int kSteps = 256;

Rgba8 entry(const std::array<Rgba8, kSteps>& table, double t) {
    return table[static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * (kSteps - 1)))];
}

/// Colours at equal distances along the way.
std::array<Rgba8, kSteps> heatTable() {
    constexpr int kPieces = 4096;
    std::vector<double> way(1, 0.0); // length up to each piece
    for (int i = 1; i <= kPieces; ++i)
        way.push_back(way.back() +
                      distance(heatAt((i - 1.0) / kPieces), heatAt(static_cast<double>(i) / kPieces)));
    std::array<Rgba8, kSteps> table{};
    for (int i = 0; i < kSteps; ++i) {
        const double wanted = way.back() * i / (kSteps - 1);
        const auto piece = std::lower_bound(way.begin(), way.end(), wanted) - way.begin();
        table[static_cast<std::size_t>(i)] = toBytes(heatAt(static_cast<double>(piece) / kPieces));
    }
    return table;
}

}

Rgba8 heatColor(double t) {
    static const auto table = heatTable();
    return entry(table, t);
}

Rgba8 depthColor(double t) {
    static const auto table = [] {
        std::array<Rgba8, kSteps> greys{};
        for (int i = 0; i < kSteps; ++i)
            greys[static_cast<std::size_t>(i)] = toBytes({1 - 0.78 * i / (kSteps - 1), 0, 0});
        return greys;
    }();
    return entry(table, t);
}

Rgba8 objectColor(int number) {
    // steps of the golden angle spread any number of hues; three tiers of lightness part neighbours further
    constexpr double kGoldenAngle = 2.39996322972865332;
    constexpr std::array kLightness = {0.72, 0.56, 0.85};
    const double hue = 0.6 + kGoldenAngle * number;
    return toBytes(showable(kLightness[static_cast<std::size_t>(number % 3)], 0.14, hue));
}

}
