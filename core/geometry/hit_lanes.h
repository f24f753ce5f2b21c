// Hits of several rays at once. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_HIT_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_HIT_LANES_H
#undef EYERAY_HIT_LANES_H
#else
#define EYERAY_HIT_LANES_H
#endif

#include "core/geometry/ray_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// Calls each(number of the bit) for the bits that are set.
template <class Each>
HWY_INLINE void eachBit(std::uint32_t bits, const Each& each) {
    for (; bits != 0; bits &= bits - 1) each(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Calls each(lane) for the lanes of a mask.
template <class Each>
HWY_INLINE void eachLane(FloatMask mask, const Each& each) {
    eachBit(bitsOf(mask), each);
}

/// Hits in lanes: t is infinite where there is none.
struct HitLanes {
    FloatLanes t = all(kInfinity), u = all(0.0F), v = all(0.0F); // as in Hit
    IntLanes primitive = hn::Zero(IntTag()), instance = hn::Zero(IntTag());

    FloatMask met() const { return t < all(kInfinity); }
};

struct HitSpread {
    Spread t, u, v;
    SpreadInt primitive, instance;

    explicit HitSpread(const HitLanes& hits)
        : t(spread(hits.t)), u(spread(hits.u)), v(spread(hits.v)), primitive(spread(hits.primitive)),
          instance(spread(hits.instance)) {}
    Hit at(std::size_t lane) const {
        return {t.lane[lane], u.lane[lane], v.lane[lane], primitive.at(lane), instance.at(lane)};
    }
    void set(std::size_t lane, const Hit& hit) {
        t.lane[lane] = hit.t, u.lane[lane] = hit.u, v.lane[lane] = hit.v;
        primitive.set(lane, hit.primitive), instance.set(lane, hit.instance);
    }
    HitLanes gathered() const {
        namespace here = eyeray::HWY_NAMESPACE;
        return {here::gathered(t), here::gathered(u), here::gathered(v), here::gathered(primitive),
                here::gathered(instance)};
    }
};

/// The nearest of the hits that come, as NearestHit.
struct NearestLanes {
    FloatLanes limit;
    HitLanes hit;

    explicit NearestLanes(FloatLanes tMax = all(kInfinity), const HitLanes& before = {})
        : limit(tMax), hit(before) {}

    /// Of shapes, among shapes.
    HWY_INLINE void offer(const ShapeHitLanes& other, std::uint32_t id) {
        const auto ids = hn::Set(IntTag(), static_cast<std::int32_t>(id));
        const auto better = nearer(other.t, other.face, ids);
        take(better, other.t, other.u, other.face, ids);
    }
    /// Returns where they are taken.
    HWY_INLINE FloatMask offer(const HitLanes& other) {
        const auto better = nearer(other.t, other.primitive, other.instance);
        take(better, other.t, other.u, other.primitive, other.instance);
        hit.v = hn::IfThenElse(better, other.v, hit.v);
        return better;
    }

private:
    HWY_INLINE FloatMask nearer(FloatLanes t, IntLanes primitive, IntLanes instance) const {
        const FloatTag f;
        const auto lower =
            hn::Or(instance < hit.instance, hn::And(instance == hit.instance, primitive < hit.primitive));
        const auto tie = hn::And(hn::And(t == hit.t, t < all(kInfinity)), hn::RebindMask(f, lower));
        return hn::Or(t < hit.t, tie);
    }
    HWY_INLINE void take(FloatMask better, FloatLanes t, FloatLanes u, IntLanes primitive,
                         IntLanes instance) {
        const auto betterInt = hn::RebindMask(IntTag(), better);
        hit.t = hn::IfThenElse(better, t, hit.t);
        hit.u = hn::IfThenElse(better, u, hit.u);
        hit.primitive = hn::IfThenElse(betterInt, primitive, hit.primitive);
        hit.instance = hn::IfThenElse(betterInt, instance, hit.instance);
        limit = hn::IfThenElse(better, nextAbove(t), limit);
    }
};

}
HWY_AFTER_NAMESPACE();

#endif
