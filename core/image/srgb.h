#pragma once
// The sRGB transfer curve, IEC 61966-2-1:1999, both ways.

#include <array>
#include <bit>
#include <cstdint>

namespace eyeray {

/// sRGB-coded value of a linear one. Nothing is clamped: over 1 the curve goes on, below 0 its line does; NaN
/// stays NaN.
float encodeSrgb(float linear);

/// Linear value of an sRGB-coded one, the inverse of encodeSrgb.
float decodeSrgb(float encoded);

namespace detail {

/// The byte of a float in two steps: its leading bits choose a bucket, narrow enough to hold at most one
/// change of byte, and one comparison says on which side of that change it lies.
struct SrgbTables {
    static constexpr float kLow = 0x1p-13F;          // below it the byte is 0
    static constexpr float kHigh = 0x1.fffffep-1F;   // largest float below 1; from it on the byte is 255
    static constexpr unsigned kDroppedBits = 23 - 7; // 7 bits of mantissa: buckets of less than 0.8 % width
    static constexpr std::size_t kBuckets = 13UL << 7U; // 13 powers of two between kLow and 1

    static constexpr std::size_t bucketOf(float value) {
        return (std::bit_cast<std::uint32_t>(value) - std::bit_cast<std::uint32_t>(kLow)) >> kDroppedBits;
    }

    std::array<std::uint8_t, kBuckets> firstByte; // byte of the smallest float in the bucket
    std::array<float, 257> threshold;             // smallest float that gives byte i; [256] is never reached
    std::array<float, 256> decoded;               // linear value of byte i
};
extern const SrgbTables kSrgbTables;

}

/// round(255 · encodeSrgb(linear)) of the exact curve, for every float; clamped to 0 … 255, and 0 for NaN.
inline std::uint8_t encodeSrgb8(float linear) {
    using Tables = detail::SrgbTables;
    const Tables& tables = detail::kSrgbTables;
    const float notLow = linear > Tables::kLow ? linear : Tables::kLow; // in this order NaN becomes kLow
    const float value = notLow < Tables::kHigh ? notLow : Tables::kHigh;
    const std::uint8_t byte = tables.firstByte[Tables::bucketOf(value)];
    return static_cast<std::uint8_t>(byte + (value >= tables.threshold[byte + 1U] ? 1 : 0));
}

/// Linear value of an sRGB byte, 0 … 1; encodeSrgb8 gives the same byte back.
inline float decodeSrgb8(std::uint8_t encoded) { return detail::kSrgbTables.decoded[encoded]; }

}
