// Triangles against packets of rays: the tests of triangle.h for many rays at once. Compiled once for each
// instruction set, as core/base/lanes.h.
#if defined(EYERAY_PACKET_TRIANGLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_PACKET_TRIANGLES_H
#undef EYERAY_PACKET_TRIANGLES_H
#else
#define EYERAY_PACKET_TRIANGLES_H
#endif

#include "core/geometry/packet_rays.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// As RayShear, of the rays of a row, whose axes are the same.
struct ShearLanes {
    Vec3Lanes origin, direction; // turned
    FloatLanes sx, sy;
    FloatLanes soonest,
        latest; // a little less, or more, than the inverse of the direction along the third axis
};

/// What is known of a triangle before its areas in double: their signs in float are right or zero whatever
/// the rounding.
struct TriangleLanes {
    FloatMask open;             // the ray may meet it
    FloatMask certain;          // the areas' signs are right
    FloatLanes soonest, latest; // bounds of t: it lies between those of the corners
};

/// A triangle of turned corners.
struct TurnedTriangle {
    TriangleCorners corners, fromOrigin; // the latter if all rays begin at one
    DVec3 first, normal;

    TurnedTriangle(const TriangleCorners& turned, const std::array<float, 3>& origin)
        : corners(turned), fromOrigin(turned), first(detail::toDouble(turned[0])),
          normal(glm::cross(detail::toDouble(turned[1]) - first, detail::toDouble(turned[2]) - first)) {
        for (auto& corner : fromOrigin)
            for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] -= origin[axis];
    }
};

/// Rays of a packet prepared for tests against triangles; whether they begin at one point, is known.
template <bool kOneOrigin>
class PacketShear {
public:
    PacketShear(const PacketRays& rays, Rows rows) : rows_(rows) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rays.asked[rows.first]));
        const RayShear shear(RaySpread(rays.rows[rows.first]).at(lane));
        axes_ = shear.axes;
        origin_ = shear.origin;
        forward_ = shear.direction[2] > 0;
        for (std::size_t row = rows.first; row < rows.end; ++row)
            set(row, rays.rows[row], maskOf(rays.asked[row]));
    }

    /// Whether the direction of all rays is longest along the same axis; else the tests below do not hold.
    bool aligned() const { return aligned_; }

    const std::array<std::size_t, 3>& axes() const { return axes_; }
    const ShearLanes& row(std::size_t i) const { return shears_[i]; }
    const std::array<float, 3>& origin() const { return origin_; }

    /// Which triangles of a block any ray may meet before `limit`, a bit each.
    std::uint32_t mayMeet(const TriangleBlock& block, float limit) const {
        const Floats d;
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
            const auto fromOrigin = [&](std::size_t corner, std::size_t i) HWY_ATTR {
                const auto at = hn::Load(d, &block.corners[corner][axes_[i]][lane]);
                if constexpr (kOneOrigin)
                    return fromOne(hn::Sub(at, hn::Set(d, origin_[i])));
                else
                    return fromAny(at, hn::Set(d, origins_[i].whole.low), hn::Set(d, origins_[i].whole.high));
            };
            const auto slope = [&](std::size_t i) HWY_ATTR {
                return Ends{hn::Set(d, slopes_[i].whole.low), hn::Set(d, slopes_[i].whole.high)};
            };
            met |= bitsFrom(hn::Not(missed(fromOrigin, slope, hn::Set(d, limit * mostAlong_)))) << lane;
        }
        return met;
    }

    /// Which rows have rays that may meet a triangle before their own limit, a bit each.
    std::uint32_t rowsThatMayMeet(const TurnedTriangle& triangle, const OfRows& limits) const {
        const Floats d;
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < kMostRows; lane += hn::Lanes(d)) {
            const auto fromOrigin = [&](std::size_t corner, std::size_t i) HWY_ATTR {
                if constexpr (kOneOrigin)
                    return fromOne(hn::Set(d, triangle.fromOrigin[corner][i]));
                else
                    return fromAny(hn::Set(d, triangle.corners[corner][i]),
                                   hn::Load(d, &origins_[i].low[lane]), hn::Load(d, &origins_[i].high[lane]));
            };
            const auto slope = [&](std::size_t i) HWY_ATTR {
                return Ends{hn::Load(d, &slopes_[i].low[lane]), hn::Load(d, &slopes_[i].high[lane])};
            };
            const auto beyond = hn::Mul(hn::Load(d, &limits[lane]), hn::Load(d, &along_[lane]));
            met |= bitsFrom(hn::Not(missed(fromOrigin, slope, beyond))) << lane;
        }
        return met & rows_.bits();
    }

    /// The rays of a row against a triangle: as intersectCorners, but for its areas in double.
    HWY_INLINE TriangleLanes test(std::size_t row, const TurnedTriangle& triangle, bool doubleSided) const {
        const ShearLanes& shear = shears_[row];
        const auto zero = hn::Zero(FloatTag());
        const auto from = [&](std::size_t corner, std::size_t axis, FloatLanes origin) HWY_ATTR {
            if constexpr (kOneOrigin)
                return all(triangle.fromOrigin[corner][axis]);
            else
                return all(triangle.corners[corner][axis]) - origin;
        };
        const auto x = [&](std::size_t corner, FloatLanes z)
                           HWY_ATTR { return from(corner, 0, shear.origin.x) - shear.sx * z; };
        const auto y = [&](std::size_t corner, FloatLanes z)
                           HWY_ATTR { return from(corner, 1, shear.origin.y) - shear.sy * z; };
        const auto az = from(0, 2, shear.origin.z), bz = from(1, 2, shear.origin.z),
                   cz = from(2, 2, shear.origin.z);
        const auto ax = x(0, az), ay = y(0, az), bx = x(1, bz), by = y(1, bz), cx = x(2, cz), cy = y(2, cz);
        const auto u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        const auto least = hn::Min(u, hn::Min(v, w)), most = hn::Max(u, hn::Max(v, w));
        auto beside = hn::Lt(least, zero), certain = hn::Gt(least, zero);
        if (doubleSided) {
            beside = hn::And(beside, hn::Gt(most, zero));
            certain = hn::Or(certain, hn::Lt(most, zero));
        }
        auto nearest = hn::Min(az, hn::Min(bz, cz)), farthest = hn::Max(az, hn::Max(bz, cz));
        if (!forward_) {
            const auto other = hn::Neg(nearest);
            nearest = hn::Neg(farthest), farthest = other;
        }
        return {hn::AndNot(beside, farthest >= zero), certain, nearest * shear.soonest,
                farthest * shear.latest};
    }

    /// t where rays of a row meet the plane of a triangle, as detail::finishTriangle; infinite behind the
    /// origin.
    HWY_INLINE FloatLanes meetPlane(std::size_t row, const TurnedTriangle& triangle,
                                    const TriangleLanes& at) const {
        const ShearLanes& shear = shears_[row];
        const DVec3Lanes direction = widen(shear.direction), normal = all(triangle.normal);
        const DVec3Lanes origin = kOneOrigin ? all(detail::toDouble(origin_)) : widen(shear.origin);
        DoubleLanes distance;
        if constexpr (kOneOrigin)
            distance = all(glm::dot(triangle.normal, triangle.first - detail::toDouble(origin_)));
        else
            distance = dot(normal, all(triangle.first) - origin);
        const auto approach = dot(normal, direction);
        const auto plane = distance / approach; // not a number for a triangle that is seen edge-on
        const FloatLanes rounded = narrow(plane);
        const auto inside = hn::And(rounded > at.soonest * all(kBeyond * kBeyond),
                                    rounded * all(kBeyond * kBeyond) < at.latest);
        const auto ahead = at.soonest > hn::Zero(FloatTag());
        if (hn::AllTrue(FloatTag(), hn::Or(hn::And(inside, ahead), hn::Not(at.certain)))) return rounded;
        const auto along = abs(direction.z), sign = copySign(all(1.0), direction.z);
        const auto z = [&](std::size_t corner) HWY_ATTR {
            return sign * (all(static_cast<double>(triangle.corners[corner][2])) - origin.z);
        };
        const auto a = z(0), b = z(1), c = z(2);
        const auto nearest = min(a, min(b, c)), farthest = max(a, max(b, c));
        const auto soonest = nearest / along, latest = farthest / along;
        const auto after = select(soonest < plane, plane, soonest);
        const auto behind = both(nearest <= all(0.0), distance * approach < all(0.0));
        return narrow(select(behind, all(std::numeric_limits<double>::infinity()),
                             select(latest < after, latest, after)));
    }

private:
    void set(std::size_t row, const RayLanes& rays, FloatMask asked) {
        const std::array<FloatLanes, 3> o{rays.origin.x, rays.origin.y, rays.origin.z},
            d{rays.direction.x, rays.direction.y, rays.direction.z};
        ShearLanes& shear = shears_[row];
        shear.origin = {o[axes_[0]], o[axes_[1]], o[axes_[2]]};
        shear.direction = {d[axes_[0]], d[axes_[1]], d[axes_[2]]};
        shear.sx = shear.direction.x / shear.direction.z;
        shear.sy = shear.direction.y / shear.direction.z;
        const auto along = hn::Abs(shear.direction.z), inverse = all(1.0F) / along;
        shear.soonest = inverse * all(1 / kBeyond), shear.latest = inverse * all(kBeyond);
        aligned_ = aligned_ && hn::AllFalse(FloatTag(), hn::AndNot(longestAlong(rays.direction), asked));
        if constexpr (!kOneOrigin) {
            origins_[0].set(row, shear.origin.x, asked), origins_[1].set(row, shear.origin.y, asked);
            origins_[2].set(row, shear.origin.z, asked);
        }
        slopes_[0].set(row, shear.sx, asked), slopes_[1].set(row, shear.sy, asked);
        along_[row] = hn::GetLane(hn::MaxOfLanes(FloatTag(), hn::IfThenElseZero(asked, along))) * kBeyond;
        mostAlong_ = std::max(mostAlong_, along_[row]);
    }

    /// As RayShear chooses it.
    FloatMask longestAlong(const Vec3Lanes& direction) const {
        const Vec3Lanes size = abs(direction);
        const auto x = size.x > size.y;
        const auto ofXY = hn::Max(size.x, size.y) > size.z;
        if (axes_[2] == 2) return hn::Not(ofXY);
        return hn::And(ofXY, axes_[2] == 0 ? x : hn::Not(x));
    }

    using Lanes = hn::VFromD<Floats>;
    struct Ends {
        Lanes low, high;
    };
    static HWY_INLINE Ends fromOne(Lanes distance) { return {distance, distance}; }
    static HWY_INLINE Ends fromAny(Lanes at, Lanes low, Lanes high) {
        return {hn::Sub(at, high), hn::Sub(at, low)};
    }

    /// Where all corners of triangles lie on the same side of all rays along an axis of their shear, behind
    /// all origins, or beyond all limits. fromOrigin(corner, axis) and slope(axis) are of several rays, and
    /// so what test() computes lies between bounds that are computed alike, for rounding is monotonic.
    template <class FromOrigin, class Slope>
    HWY_INLINE hn::Mask<Floats> missed(const FromOrigin& fromOrigin, const Slope& slope, Lanes beyond) const {
        const auto zero = hn::Zero(Floats());
        const auto sheared = [&](std::size_t corner, std::size_t axis, const Ends& z) HWY_ATTR {
            const Ends at = fromOrigin(corner, axis), by = slope(axis);
            const auto p = hn::Mul(by.low, z.low), q = hn::Mul(by.high, z.low);
            auto low = hn::Min(p, q), high = hn::Max(p, q);
            if constexpr (!kOneOrigin) {
                const auto r = hn::Mul(by.low, z.high), s = hn::Mul(by.high, z.high);
                low = hn::Min(low, hn::Min(r, s)), high = hn::Max(high, hn::Max(r, s));
            }
            return Ends{hn::Sub(at.low, high), hn::Sub(at.high, low)};
        };
        const auto around = [](const Ends& a, const Ends& b, const Ends& c) HWY_ATTR {
            return Ends{hn::Min(a.low, hn::Min(b.low, c.low)), hn::Max(a.high, hn::Max(b.high, c.high))};
        };
        const Ends a = fromOrigin(0, 2), b = fromOrigin(1, 2), c = fromOrigin(2, 2);
        const Ends x = around(sheared(0, 0, a), sheared(1, 0, b), sheared(2, 0, c));
        const Ends y = around(sheared(0, 1, a), sheared(1, 1, b), sheared(2, 1, c));
        const Ends z = around(a, b, c);
        const auto aside = hn::Or(hn::Gt(hn::Max(x.low, y.low), zero), hn::Lt(hn::Min(x.high, y.high), zero));
        const auto outside = forward_ ? hn::Or(hn::Lt(z.high, zero), hn::Gt(z.low, beyond))
                                      : hn::Or(hn::Gt(z.low, zero), hn::Lt(z.high, hn::Neg(beyond)));
        return hn::Or(aside, outside);
    }

    std::array<ShearLanes, kMostRows> shears_;
    std::array<RowRanges, 3> origins_;
    std::array<RowRanges, 2> slopes_;
    alignas(32) OfRows along_{}; // the third axis, the most of each row, and of all
    Rows rows_;
    std::array<std::size_t, 3> axes_;
    std::array<float, 3> origin_; // of the first ray, turned
    float mostAlong_ = 0;
    bool forward_ = true, aligned_ = true;
};

}
HWY_AFTER_NAMESPACE();

#endif
