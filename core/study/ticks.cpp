#include "core/study/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr double kSlack = 1e-9;                      // of an axis: what rounding may move a mark at its end
constexpr double kMargin = 0.06;                     // of an axis, on each side
constexpr double kFlat = 1e-9;                       // relative width of values that are taken as one
constexpr int kLeastInDecades = 3;                   // labels that powers of ten must give to stand alone
constexpr double kPlainLow = 1e-3, kPlainHigh = 1e5; // numbers between them need no power of ten

bool isShown(Scale scale, double value) {
    return std::isfinite(value) && (scale == Scale::Linear || value > 0);
}

double scaled(Scale scale, double value) { return scale == Scale::Log ? std::log10(value) : value; }
double unscaled(Scale scale, double value) { return scale == Scale::Log ? std::pow(10, value) : value; }

bool isOn(const Axis& axis, double value) {
    const double share = axis.share(value);
    return share >= -kSlack && share <= 1 + kSlack;
}

std::string superscript(int number) {
    constexpr std::array kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result;
    for (const char c : fmt::format("{}", number))
        result += c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
    return result;
}

/// The least of 1, 2, 5, 10, 20, … that is no less.
double roundStep(double atLeast) {
    const double power = std::pow(10, std::floor(std::log10(atLeast)));
    for (const double mantissa : {1, 2, 5})
        if (mantissa * power >= atLeast * (1 - kSlack)) return mantissa * power;
    return 10 * power;
}

/// Equal numbers of decimals on all marks.
std::string linearLabel(double value, double step, double largest) {
    if (largest >= kPlainHigh || step < kPlainLow / 10)
        return shortNumber(value, 1 + static_cast<int>(std::ceil(std::log10(largest / step))));
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + kSlack)));
    return fmt::format("{:.{}f}", value, decimals);
}

std::vector<Tick> linearTicks(const Axis& axis, int most) {
    double step = roundStep((axis.high - axis.low) / most);
    const auto first = [&] { return std::ceil(axis.low / step - kSlack); };
    const auto last = [&] { return std::floor(axis.high / step + kSlack); };
    if (last() - first() + 1 > most) step = roundStep(step * 1.5);
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high)), from = first();
    const int count = static_cast<int>(last() - from) + 1;
    std::vector<Tick> ticks;
    for (int i = 0; i < count; ++i) {
        const double value = from + i == 0 ? 0 : (from + i) * step;
        ticks.push_back({value, linearLabel(value, step, largest)});
    }
    return ticks;
}

/// Marks at these multiples of each power of ten that lies on the axis.
std::vector<double> inDecades(const Axis& axis, std::span<const int> mantissas) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(axis.low))) - 1;
    const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
    for (int power = first; power <= last; ++power)
        for (const int mantissa : mantissas)
            if (const double value = mantissa * std::pow(10, power); isOn(axis, value))
                values.push_back(value);
    return values;
}

std::vector<Tick> logTicks(const Axis& axis, int most) {
    constexpr std::array kOne = {1};
    constexpr std::array kOneTwoFive = {1, 2, 5};
    constexpr std::array kAll = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    std::vector<double> labelled = inDecades(axis, kOne);
    const int decades = static_cast<int>(labelled.size());
    const int every = (decades + most - 1) / std::max(1, most);
    if (decades < kLeastInDecades) labelled = inDecades(axis, kOneTwoFive);
    if (static_cast<int>(labelled.size()) < 2) return linearTicks(axis, most);
    if (decades >= 2 && static_cast<int>(labelled.size()) > most) labelled = inDecades(axis, kOne);
    if (static_cast<int>(labelled.size()) > most && decades < 2) return linearTicks(axis, most);
    const auto isLabelled = [&](double value) {
        return std::ranges::find(labelled, value) != labelled.end() &&
               (every <= 1 || static_cast<int>(std::lround(std::log10(value))) % every == 0);
    };
    std::vector<Tick> ticks;
    for (const double value : every > 1 ? inDecades(axis, kOne) : inDecades(axis, kAll))
        ticks.push_back({value, isLabelled(value) ? shortNumber(value, 1) : ""});
    return ticks;
}

}

double Axis::share(double value) const {
    return (scaled(scale, value) - scaled(scale, low)) / (scaled(scale, high) - scaled(scale, low));
}

double Axis::valueAt(double share) const {
    return unscaled(scale, std::lerp(scaled(scale, low), scaled(scale, high), share));
}

Axis axisAround(Scale scale, std::span<const double> values) {
    double low = kPlainHigh, high = -kPlainHigh;
    bool any = false;
    for (const double value : values) {
        if (!isShown(scale, value)) continue;
        const double at = scaled(scale, value);
        low = any ? std::min(low, at) : at;
        high = any ? std::max(high, at) : at;
        any = true;
    }
    if (!any) low = high = scaled(scale, 1);
    if (high - low <= kFlat * std::max(std::abs(low), std::abs(high))) {
        const double around = scale == Scale::Log ? 0.5 : std::max(std::abs(low) / 2, kPlainLow);
        low -= around;
        high += around;
    }
    const double margin = kMargin * (high - low);
    return {scale, unscaled(scale, low - margin), unscaled(scale, high + margin)};
}

std::vector<Tick> ticksOf(const Axis& axis, int most) {
    ENSURE(axis.low < axis.high && (axis.scale == Scale::Linear || axis.low > 0));
    return axis.scale == Scale::Log ? logTicks(axis, std::max(2, most))
                                    : linearTicks(axis, std::max(2, most));
}

std::string shortNumber(double value, int digits) {
    if (std::isnan(value)) return "?";
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    if (value == 0) return "0";
    const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = scientific.find('e');
    const int power = std::stoi(scientific.substr(e + 1));
    const double rounded = std::abs(std::stod(scientific));
    if (rounded >= kPlainLow && rounded < kPlainHigh)
        return fmt::format("{:.{}f}", std::stod(scientific), std::max(0, digits - 1 - power));
    const std::string mantissa = scientific.substr(0, e);
    if (mantissa == "1" || mantissa == "-1")
        return mantissa.substr(0, mantissa.size() - 1) + "10" + superscript(power);
    return mantissa + "·10" + superscript(power);
}

}
