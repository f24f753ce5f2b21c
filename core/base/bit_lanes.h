// Words of 32 bits side by side, and the random numbers made of them: the same bits as sampling.h. Compiled
// once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_BIT_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_BIT_LANES_H
#undef EYERAY_BIT_LANES_H
#else
#define EYERAY_BIT_LANES_H
#endif

#include "core/base/lanes.h"
#include "core/base/sampling.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

using BitTag = hn::Rebind<std::uint32_t, FloatTag>;

struct BitLanes {
    hn::Vec<BitTag> v;

    BitLanes(hn::Vec<BitTag> lanes) : v(lanes) {} // NOLINT(google-explicit-constructor)
    explicit BitLanes(std::uint32_t bits) : v(hn::Set(BitTag(), bits)) {}

    friend HWY_INLINE BitLanes operator^(BitLanes a, BitLanes b) { return hn::Xor(a.v, b.v); }
    friend HWY_INLINE BitLanes operator|(BitLanes a, BitLanes b) { return hn::Or(a.v, b.v); }
    friend HWY_INLINE BitLanes operator&(BitLanes a, BitLanes b) { return hn::And(a.v, b.v); }
    friend HWY_INLINE BitLanes operator+(BitLanes a, BitLanes b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE BitLanes operator*(BitLanes a, BitLanes b) { return hn::Mul(a.v, b.v); }
    friend HWY_INLINE BitLanes operator<<(BitLanes a, unsigned n) {
        return hn::ShiftLeftSame(a.v, static_cast<int>(n));
    }
    friend HWY_INLINE BitLanes operator>>(BitLanes a, unsigned n) {
        return hn::ShiftRightSame(a.v, static_cast<int>(n));
    }
};

#include "core/base/bit_mixing.h"

/// As a number; of less than 2³¹.
HWY_INLINE FloatLanes toFloat(BitLanes bits) {
    return hn::ConvertTo(FloatTag(), hn::BitCast(IntTag(), bits.v));
}
HWY_INLINE FloatLanes toUnitFloat(BitLanes bits) { return toFloat(bits >> 8U) * all(0x1p-24F); }

/// Points in [0, 1)².
struct PlaceLanes {
    FloatLanes x, y;
};

HWY_INLINE PlaceLanes pixelSample(std::uint32_t seed, BitLanes x, BitLanes y, std::uint32_t pass) {
    if (pass == 0) return {all(0.5F), all(0.5F)};
    const auto purpose = static_cast<std::uint32_t>(SamplePurpose::PixelFilter);
    const auto key = mixing::keyOf(BitLanes(seed), x, y, BitLanes(0U), BitLanes(purpose));
    const auto point = mixing::sobol(BitLanes(pass), key);
    return {toUnitFloat(point.x), toUnitFloat(point.y)};
}

}
HWY_AFTER_NAMESPACE();

#endif
