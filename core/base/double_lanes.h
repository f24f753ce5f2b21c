// As many doubles side by side as core/base/lanes.h has floats: two registers of them. Compiled once for each
// instruction set, as core/base/lanes.h.
#if defined(EYERAY_DOUBLE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_DOUBLE_LANES_H
#undef EYERAY_DOUBLE_LANES_H
#else
#define EYERAY_DOUBLE_LANES_H
#endif

#include "core/base/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

using DoubleTag = hn::ScalableTag<double>;

/// The lower lanes and the upper ones; both are the same single lane where registers are not used.
struct DoubleLanes {
    hn::Vec<DoubleTag> low, high;
};
struct DoubleMask {
    hn::Mask<DoubleTag> low, high;
};
using DVec3Lanes = Three<DoubleLanes>;

HWY_INLINE DoubleLanes all(double value) {
    const auto lanes = hn::Set(DoubleTag(), value);
    return {lanes, lanes};
}
HWY_INLINE DoubleLanes widen(FloatLanes v) {
    const DoubleTag d;
#if HWY_TARGET == HWY_SCALAR
    return {hn::PromoteTo(d, v), hn::PromoteTo(d, v)};
#else
    const hn::Half<FloatTag> half;
    return {hn::PromoteTo(d, hn::LowerHalf(half, v)), hn::PromoteTo(d, hn::UpperHalf(half, v))};
#endif
}
HWY_INLINE FloatLanes narrow(DoubleLanes v) {
#if HWY_TARGET == HWY_SCALAR
    return FloatLanes(static_cast<float>(v.low.raw)); // DemoteTo would make infinity the largest number here
#else
    const hn::Half<FloatTag> half;
    return hn::Combine(FloatTag(), hn::DemoteTo(half, v.high), hn::DemoteTo(half, v.low));
#endif
}
/// Of whole numbers.
HWY_INLINE IntLanes toInts(DoubleLanes v) { return hn::ConvertTo(IntTag(), narrow(v)); }

HWY_INLINE DoubleLanes operator+(DoubleLanes a, DoubleLanes b) { return {a.low + b.low, a.high + b.high}; }
HWY_INLINE DoubleLanes operator-(DoubleLanes a, DoubleLanes b) { return {a.low - b.low, a.high - b.high}; }
HWY_INLINE DoubleLanes operator*(DoubleLanes a, DoubleLanes b) { return {a.low * b.low, a.high * b.high}; }
HWY_INLINE DoubleLanes operator/(DoubleLanes a, DoubleLanes b) { return {a.low / b.low, a.high / b.high}; }
HWY_INLINE DoubleLanes operator-(DoubleLanes a) { return {hn::Neg(a.low), hn::Neg(a.high)}; }
HWY_INLINE DoubleMask operator<(DoubleLanes a, DoubleLanes b) { return {a.low < b.low, a.high < b.high}; }
HWY_INLINE DoubleMask operator<=(DoubleLanes a, DoubleLanes b) { return {a.low <= b.low, a.high <= b.high}; }
HWY_INLINE DoubleMask operator>(DoubleLanes a, DoubleLanes b) { return b < a; }
HWY_INLINE DoubleMask operator>=(DoubleLanes a, DoubleLanes b) { return b <= a; }
HWY_INLINE DoubleMask operator==(DoubleLanes a, DoubleLanes b) { return {a.low == b.low, a.high == b.high}; }

HWY_INLINE DoubleLanes sqrt(DoubleLanes v) { return {hn::Sqrt(v.low), hn::Sqrt(v.high)}; }
HWY_INLINE DoubleLanes abs(DoubleLanes v) { return {hn::Abs(v.low), hn::Abs(v.high)}; }
HWY_INLINE DoubleLanes min(DoubleLanes a, DoubleLanes b) {
    return {hn::Min(a.low, b.low), hn::Min(a.high, b.high)};
}
HWY_INLINE DoubleLanes max(DoubleLanes a, DoubleLanes b) {
    return {hn::Max(a.low, b.low), hn::Max(a.high, b.high)};
}
HWY_INLINE DoubleLanes copySign(DoubleLanes v, DoubleLanes sign) {
    return {hn::CopySign(v.low, sign.low), hn::CopySign(v.high, sign.high)};
}

HWY_INLINE DoubleMask both(DoubleMask a, DoubleMask b) {
    return {hn::And(a.low, b.low), hn::And(a.high, b.high)};
}
HWY_INLINE DoubleMask either(DoubleMask a, DoubleMask b) {
    return {hn::Or(a.low, b.low), hn::Or(a.high, b.high)};
}
/// Where `mask` is, but not `without`.
HWY_INLINE DoubleMask butNot(DoubleMask without, DoubleMask mask) {
    return {hn::AndNot(without.low, mask.low), hn::AndNot(without.high, mask.high)};
}
HWY_INLINE bool none(DoubleMask mask) { return hn::AllFalse(DoubleTag(), hn::Or(mask.low, mask.high)); }
HWY_INLINE DoubleLanes select(DoubleMask mask, DoubleLanes yes, DoubleLanes no) {
    return {hn::IfThenElse(mask.low, yes.low, no.low), hn::IfThenElse(mask.high, yes.high, no.high)};
}

HWY_INLINE DVec3Lanes select(DoubleMask mask, const DVec3Lanes& yes, const DVec3Lanes& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_INLINE DVec3Lanes all(const DVec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE DVec3Lanes widen(const Vec3Lanes& v) { return {widen(v.x), widen(v.y), widen(v.z)}; }
HWY_INLINE Vec3Lanes narrow(const DVec3Lanes& v) { return {narrow(v.x), narrow(v.y), narrow(v.z)}; }

}
HWY_AFTER_NAMESPACE();

#endif
