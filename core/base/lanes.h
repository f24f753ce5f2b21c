// Several numbers side by side: the types of code that takes many rays at once. Each lane goes through the
// operations of IEEE 754 that scalar code would take it through, so it ends with the same bits. Compiled once
// for each instruction set: included by a file that Google Highway's foreach_target includes, hence the
// guard.
#if defined(EYERAY_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_LANES_H
#undef EYERAY_LANES_H
#else
#define EYERAY_LANES_H
#endif

#include <array>

#include <hwy/highway.h>

#include "core/base/math.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::Rebind<std::int32_t, FloatTag>;
using FloatLanes = hn::Vec<FloatTag>;
using IntLanes = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;
inline constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());

HWY_INLINE FloatLanes all(float value) { return hn::Set(FloatTag(), value); }

/// `first`, the next number and so on. Not Highway's Iota of a variable, which goes through memory.
HWY_INLINE IntLanes countedFrom(std::size_t first) {
    const IntTag n;
    return hn::Iota(n, 0) + hn::Set(n, static_cast<std::int32_t>(first));
}

/// One bit for each lane.
HWY_INLINE std::uint32_t bitsOf(FloatMask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(FloatTag(), mask, bits);
    return bits[0] | static_cast<std::uint32_t>(bits[1]) << 8U;
}
HWY_INLINE FloatMask maskOf(std::uint32_t bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U)};
    return hn::LoadMaskBits(FloatTag(), bytes);
}

/// Which of 8 lanes come first, next and so on to lie close together, for each mask of them.
inline constexpr auto kCloseTogether = [] {
    std::array<std::array<std::int32_t, 8>, 256> from{};
    for (std::size_t bits = 0; bits < from.size(); ++bits)
        for (std::size_t lane = 0, next = 0; lane < 8; ++lane)
            if ((bits >> lane & 1U) != 0) from[bits][next++] = static_cast<std::int32_t>(lane);
    return from;
}();

/// The lanes of the mask, close together. Not Highway's Compress where that looks them up in a table, which
/// g++ copies to the stack each time.
template <class Lanes>
HWY_INLINE Lanes compressed(Lanes values, FloatMask mask) {
    const hn::DFromV<Lanes> d;
    if constexpr (kLanes == 1 || kLanes > 8)
        return hn::Compress(values, hn::RebindMask(d, mask));
    else
        return hn::TableLookupLanes(values, hn::SetTableIndices(d, kCloseTogether[bitsOf(mask)].data()));
}

/// Vectors of three, a lane each.
template <class T>
struct Three {
    T x, y, z;
};
using Vec3Lanes = Three<FloatLanes>;

template <class T>
HWY_INLINE Three<T> operator+(const Three<T>& a, const Three<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
HWY_INLINE Three<T> operator-(const Three<T>& a, const Three<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
HWY_INLINE Three<T> operator*(const Three<T>& a, const Three<T>& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
HWY_INLINE Three<T> operator*(const Three<T>& a, T s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class T>
HWY_INLINE Three<T> operator/(const Three<T>& a, T s) {
    return {a.x / s, a.y / s, a.z / s};
}
template <class T>
HWY_INLINE Three<T> operator-(const Three<T>& a) {
    return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
template <class T>
HWY_INLINE T dot(const Three<T>& a, const Three<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
HWY_INLINE Three<T> cross(const Three<T>& a, const Three<T>& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
template <class T>
HWY_INLINE Three<T> abs(const Three<T>& a) {
    return {hn::Abs(a.x), hn::Abs(a.y), hn::Abs(a.z)};
}
HWY_INLINE Vec3Lanes normalize(const Vec3Lanes& a) { return a * (all(1.0F) / hn::Sqrt(dot(a, a))); }
HWY_INLINE Vec3Lanes select(FloatMask mask, const Vec3Lanes& yes, const Vec3Lanes& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE Vec3Lanes orZero(FloatMask mask, const Vec3Lanes& yes) {
    return {hn::IfThenElseZero(mask, yes.x), hn::IfThenElseZero(mask, yes.y),
            hn::IfThenElseZero(mask, yes.z)};
}
HWY_INLINE FloatMask notBlack(const Vec3Lanes& c) {
    const auto zero = hn::Zero(FloatTag());
    return hn::Or(hn::Or(c.x != zero, c.y != zero), c.z != zero);
}
/// By the sign, so -0 as well.
HWY_INLINE FloatMask isNegative(FloatLanes v) {
    return hn::RebindMask(FloatTag(), hn::BitCast(IntTag(), v) < hn::Zero(IntTag()));
}
HWY_INLINE FloatLanes maxComponent(const Vec3Lanes& c) { return hn::Max(c.x, hn::Max(c.y, c.z)); }

HWY_INLINE Vec3Lanes all(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }

/// What lanes hold, for code that takes one lane after the other.
struct alignas(64) Spread {
    float lane[kLanes] = {};
};
struct Spread3 {
    Spread x, y, z;

    Vec3 at(std::size_t lane) const { return {x.lane[lane], y.lane[lane], z.lane[lane]}; }
    void set(std::size_t lane, const Vec3& v) { x.lane[lane] = v.x, y.lane[lane] = v.y, z.lane[lane] = v.z; }
};
struct alignas(64) SpreadInt {
    std::int32_t lane[kLanes] = {};

    std::uint32_t at(std::size_t i) const { return static_cast<std::uint32_t>(lane[i]); }
    void set(std::size_t i, std::uint32_t value) { lane[i] = static_cast<std::int32_t>(value); }
};
HWY_INLINE Spread spread(FloatLanes v) {
    Spread result;
    hn::Store(v, FloatTag(), result.lane);
    return result;
}
HWY_INLINE SpreadInt spread(IntLanes v) {
    SpreadInt result;
    hn::Store(v, IntTag(), result.lane);
    return result;
}
HWY_INLINE Spread3 spread(const Vec3Lanes& v) { return {spread(v.x), spread(v.y), spread(v.z)}; }
HWY_INLINE FloatLanes gathered(const Spread& s) { return hn::Load(FloatTag(), s.lane); }
HWY_INLINE IntLanes gathered(const SpreadInt& s) { return hn::Load(IntTag(), s.lane); }
HWY_INLINE Vec3Lanes gathered(const Spread3& s) { return {gathered(s.x), gathered(s.y), gathered(s.z)}; }

}
HWY_AFTER_NAMESPACE();

#endif
