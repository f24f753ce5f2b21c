#include "core/image/srgb.h"

#include <cmath>
#include <limits>

namespace eyeray {
namespace {

constexpr double kLinearEnd = 0.0031308; // linear value up to which the curve is a line
constexpr double kEncodedEnd = 0.04045;  // its encoded value, as the standard rounds it

/// a^(1/5) for 0 < a <= 1 by Newton's method, which comes down from 1 until it can get no lower.
constexpr double fifthRoot(double a) {
    const auto improve = [a](double root) { return root - (root - a / (root * root * root * root)) / 5; };
    double root = 1;
    while (improve(root) < root) root = improve(root);
    return root;
}

/// Linear value of an encoded one in 0 … 1, at compile time: other constants may be built from the tables.
constexpr double decodeInUnitInterval(double encoded) {
    if (encoded <= kEncodedEnd) return encoded / 12.92;
    const double base = (encoded + 0.055) / 1.055;
    return base * base * fifthRoot(base * base); // base^2.4
}

constexpr float smallestFloatFrom(double value) {
    const auto nearest = static_cast<float>(value);
    return nearest >= value ? nearest : std::bit_cast<float>(std::bit_cast<std::uint32_t>(nearest) + 1);
}

constexpr detail::SrgbTables makeTables() {
    detail::SrgbTables tables{};
    for (std::size_t i = 0; i < 256; ++i) {
        const auto byte = static_cast<double>(i);
        tables.decoded[i] = static_cast<float>(decodeInUnitInterval(byte / 255));
        tables.threshold[i] = i == 0 ? 0 : smallestFloatFrom(decodeInUnitInterval((byte - 0.5) / 255));
    }
    tables.threshold[256] = std::numeric_limits<float>::infinity();
    for (std::size_t i = 1; i < 256; ++i) {
        const std::size_t bucket = detail::SrgbTables::bucketOf(tables.threshold[i]);
        for (std::size_t later = bucket + 1; later < tables.firstByte.size(); ++later)
            tables.firstByte[later] = static_cast<std::uint8_t>(i);
    }
    return tables;
}

}

constinit const detail::SrgbTables detail::kSrgbTables = makeTables();

float encodeSrgb(float linear) {
    const double value = linear;
    return static_cast<float>(value <= kLinearEnd ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
}

float decodeSrgb(float encoded) {
    const double value = encoded;
    return static_cast<float>(value <= kEncodedEnd ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

}
