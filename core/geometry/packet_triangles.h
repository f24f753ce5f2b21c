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

/// As RayShear, of the rays of a row, whose axes are the same, but for their origins.
struct ShearLanes {
    Vec3Lanes direction; // turned
    FloatLanes sx, sy;
    FloatLanes along; // how far a unit of t goes along the third axis
};

/// The same for one ray after the other.
struct ShearSpread {
    Spread3 origin, direction;
    Spread sx, sy;

    ShearSpread(const Vec3Lanes& origins, const ShearLanes& shear)
        : origin(spread(origins)), direction(spread(shear.direction)), sx(spread(shear.sx)),
          sy(spread(shear.sy)) {}
    RayShear at(std::size_t lane, const std::array<std::size_t, 3>& axes) const {
        return {axes, toArray(origin.at(lane)), toArray(direction.at(lane)), sx.lane[lane], sy.lane[lane]};
    }
};

/// What is known of a triangle before its areas in double: their signs in float are right or zero whatever
/// the rounding.
struct TriangleLanes {
    FloatMask open;               // the ray may meet it
    FloatMask certain;            // the areas' signs are right
    FloatLanes nearest, farthest; // of the corners, ahead along the third axis: the hit lies between them
};

/// The triangles of a leaf as a packet sees them: along the axes of its shear, and from the origin if all
/// rays begin at one.
template <bool kOneOrigin>
class TurnedTriangles {
public:
    TurnedTriangles(const TriangleBlock& block, const std::array<std::size_t, 3>& axes,
                    const std::array<float, 3>& origin)
        : block_(block), axes_(axes) {
        const Floats d;
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
                    const auto at = hn::Load(d, &block.corners[corner][axes[i]][lane]);
                    hn::Store(kOneOrigin ? hn::Sub(at, hn::Set(d, origin[i])) : at, d, &at_[corner][i][lane]);
                }
    }

    /// One coordinate of a corner of all triangles, or of one.
    const Bvh8::Node::Lanes& at(std::size_t corner, std::size_t axis) const { return at_[corner][axis]; }
    float at(std::size_t triangle, std::size_t corner, std::size_t axis) const {
        return at_[corner][axis][triangle];
    }

    TriangleCorners corners(std::size_t triangle) const { return block_.turned(triangle, axes_); }

    /// As in detail::finishTriangle.
    struct Plane {
        DVec3 first, normal;
    };
    const Plane& plane(std::size_t triangle) {
        if ((known_ >> triangle & 1U) == 0) {
            const TriangleCorners turned = corners(triangle);
            const DVec3 first = detail::toDouble(turned[0]);
            planes_[triangle] = {
                first, glm::cross(detail::toDouble(turned[1]) - first, detail::toDouble(turned[2]) - first)};
            known_ |= 1U << triangle;
        }
        return planes_[triangle];
    }

private:
    alignas(32) std::array<std::array<Bvh8::Node::Lanes, 3>, 3> at_; // by corner, axis, triangle
    const TriangleBlock& block_;
    const std::array<std::size_t, 3>& axes_;
    std::uint32_t known_ = 0; // planes, a bit each
    std::array<Plane, Bvh8::kWidth> planes_;
};

/// Rays of a packet whose directions are longest along the same axis, prepared for tests against triangles.
/// Whether they begin at one point, is known.
template <bool kOneOrigin>
class PacketShear {
public:
    /// `asked`: which rays, a bit each; some in one of the rows at least.
    PacketShear(const LocalRays& rays, const Asked& asked, Rows rows) {
        std::size_t first = rows.first;
        while (asked[first] == 0) ++first;
        const auto lane = static_cast<std::size_t>(std::countr_zero(asked[first]));
        const RayShear shear(RaySpread(rays.row(first)).at(lane));
        axes_ = shear.axes;
        origin_ = shear.origin;
        forward_ = shear.direction[2] > 0;
        for (std::size_t row = first; row < rows.end; ++row)
            if (asked[row] != 0) set(row, rays.row(row), maskOf(asked[row]));
    }

    const std::array<std::size_t, 3>& axes() const { return axes_; }
    const ShearLanes& row(std::size_t i) const { return shears_[i]; }
    const std::array<float, 3>& origin() const { return origin_; }
    HWY_INLINE Vec3Lanes originOf(std::size_t row) const {
        if constexpr (kOneOrigin)
            return {all(origin_[0]), all(origin_[1]), all(origin_[2])};
        else
            return turnedOrigins_[row];
    }
    ShearSpread single(std::size_t row) const { return {originOf(row), shears_[row]}; }

    /// Which rows have rays that may meet a triangle in a box before their own limit, a bit each.
    std::uint32_t rowsThatMayMeet(const Bounds& box, const OfRows& limits) const {
        const Floats d;
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < kMostRows; lane += hn::Lanes(d)) {
            const auto fromOrigin = [&](std::size_t i) HWY_ATTR {
                const auto axis = static_cast<int>(axes_[i]);
                const float low = box.lo[axis], high = box.hi[axis];
                if constexpr (kOneOrigin)
                    return Ends{hn::Set(d, low - origin_[i]), hn::Set(d, high - origin_[i])};
                else
                    return Ends{hn::Sub(hn::Set(d, low), hn::Load(d, &origins_[i].high[lane])),
                                hn::Sub(hn::Set(d, high), hn::Load(d, &origins_[i].low[lane]))};
            };
            const Ends z = fromOrigin(2);
            const auto sheared = [&](std::size_t i) HWY_ATTR {
                const Ends slope{hn::Load(d, &slopes_[i].low[lane]), hn::Load(d, &slopes_[i].high[lane])};
                return shearedBetween(fromOrigin(i), slope, z);
            };
            const auto beyond = hn::Mul(hn::Load(d, &limits[lane]), hn::Load(d, &along_[lane]));
            met |= bitsFrom(hn::Not(missed(sheared(0), sheared(1), z, beyond))) << lane;
        }
        return met & rows_;
    }

    /// Which of the `asked` rays of a row may meet a triangle in a box before their limits.
    FloatMask raysThatMayMeet(const Bounds& box, std::size_t row, FloatMask asked, FloatLanes limits) const {
        const ShearLanes& shear = shears_[row];
        const auto from = [&](std::size_t i, FloatLanes origin) HWY_ATTR {
            const auto axis = static_cast<int>(axes_[i]);
            return std::pair(all(box.lo[axis]) - origin, all(box.hi[axis]) - origin);
        };
        const Vec3Lanes origin = originOf(row);
        const auto [zLow, zHigh] = from(2, origin.z);
        const auto zero = hn::Zero(FloatTag());
        const auto beside = [&](const auto& at, FloatLanes slope) HWY_ATTR {
            const auto p = slope * zLow, q = slope * zHigh;
            return hn::Or(at.first - hn::Max(p, q) > zero, at.second - hn::Min(p, q) < zero);
        };
        const auto missed = hn::Or(beside(from(0, origin.x), shear.sx), beside(from(1, origin.y), shear.sy));
        const auto nearest = forward_ ? zLow : hn::Neg(zHigh), farthest = forward_ ? zHigh : hn::Neg(zLow);
        const auto within = hn::And(farthest >= zero, nearest < limits * shear.along * all(kBeyond));
        return hn::And(hn::AndNot(missed, within), asked);
    }

    /// Which triangles any ray of a row may meet before `limit`, a bit each.
    std::uint32_t mayMeet(std::size_t row, const TurnedTriangles<kOneOrigin>& triangles, float limit) const {
        const Floats d;
        const auto beyond = hn::Set(d, limit * along_[row]);
        const auto slopeOf = [&](std::size_t i) HWY_ATTR {
            return Ends{hn::Set(d, slopes_[i].low[row]), hn::Set(d, slopes_[i].high[row])};
        };
        const Ends slopes[2] = {slopeOf(0), slopeOf(1)};
        std::uint32_t met = 0;
        for (std::size_t lane = 0; lane < Bvh8::kWidth; lane += hn::Lanes(d)) {
            const auto fromOrigin = [&](std::size_t corner, std::size_t i) HWY_ATTR {
                const auto at = hn::Load(d, &triangles.at(corner, i)[lane]);
                if constexpr (kOneOrigin)
                    return Ends{at, at};
                else
                    return Ends{hn::Sub(at, hn::Set(d, origins_[i].high[row])),
                                hn::Sub(at, hn::Set(d, origins_[i].low[row]))};
            };
            const Ends z[3] = {fromOrigin(0, 2), fromOrigin(1, 2), fromOrigin(2, 2)};
            const auto sheared = [&](std::size_t i) HWY_ATTR {
                const auto of = [&](std::size_t corner) HWY_ATTR {
                    const Ends at = fromOrigin(corner, i);
                    if constexpr (kOneOrigin)
                        return shearedAt(at.low, slopes[i], z[corner].low);
                    else
                        return shearedBetween(at, slopes[i], z[corner]);
                };
                return around(of(0), of(1), of(2));
            };
            met |= bitsFrom(hn::Not(missed(sheared(0), sheared(1), around(z[0], z[1], z[2]), beyond)))
                   << lane;
        }
        return met;
    }

    /// The rays of a row against a triangle: as intersectCorners, but for its areas in double.
    HWY_INLINE TriangleLanes test(std::size_t row, const TurnedTriangles<kOneOrigin>& triangles,
                                  std::size_t triangle, bool doubleSided) const {
        const ShearLanes& shear = shears_[row];
        const auto zero = hn::Zero(FloatTag());
        const Vec3Lanes origin = originOf(row);
        const auto from = [&](std::size_t corner, std::size_t axis, FloatLanes o) HWY_ATTR {
            const auto at = all(triangles.at(triangle, corner, axis));
            if constexpr (kOneOrigin)
                return at;
            else
                return at - o;
        };
        const auto x = [&](std::size_t corner, FloatLanes z)
                           HWY_ATTR { return from(corner, 0, origin.x) - shear.sx * z; };
        const auto y = [&](std::size_t corner, FloatLanes z)
                           HWY_ATTR { return from(corner, 1, origin.y) - shear.sy * z; };
        const auto az = from(0, 2, origin.z), bz = from(1, 2, origin.z), cz = from(2, 2, origin.z);
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
        return {hn::AndNot(beside, farthest >= zero), certain, nearest, farthest};
    }

    /// t where rays of a row meet the plane of a triangle, as detail::finishTriangle; infinite behind the
    /// origin.
    HWY_INLINE FloatLanes meetPlane(std::size_t row, TurnedTriangles<kOneOrigin>& triangles,
                                    std::size_t triangle, const TriangleLanes& at) const {
        const ShearLanes& shear = shears_[row];
        const auto& [first, normalOfPlane] = triangles.plane(triangle);
        const DVec3Lanes direction = widen(shear.direction), normal = all(normalOfPlane);
        const DVec3Lanes origin = kOneOrigin ? all(detail::toDouble(origin_)) : widen(originOf(row));
        DoubleLanes distance;
        if constexpr (kOneOrigin)
            distance = all(glm::dot(normalOfPlane, first - detail::toDouble(origin_)));
        else
            distance = dot(normal, all(first) - origin);
        const auto approach = dot(normal, direction);
        const auto plane = distance / approach; // not a number for a triangle that is seen edge-on
        const FloatLanes rounded = narrow(plane);
        const auto there = rounded * shear.along;
        const auto inside = hn::And(there > at.nearest * all(kBeyond), there * all(kBeyond) < at.farthest);
        const auto ahead = at.nearest > hn::Zero(FloatTag());
        if (hn::AllTrue(FloatTag(), hn::Or(hn::And(inside, ahead), hn::Not(at.certain)))) return rounded;
        const auto along = abs(direction.z), sign = copySign(all(1.0), direction.z);
        const TriangleCorners corners = triangles.corners(triangle);
        const auto z = [&](std::size_t corner) HWY_ATTR {
            return sign * (all(static_cast<double>(corners[corner][2])) - origin.z);
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
        shear.direction = {d[axes_[0]], d[axes_[1]], d[axes_[2]]};
        shear.sx = shear.direction.x / shear.direction.z;
        shear.sy = shear.direction.y / shear.direction.z;
        shear.along = hn::Abs(shear.direction.z);
        if constexpr (!kOneOrigin) {
            turnedOrigins_[row] = {o[axes_[0]], o[axes_[1]], o[axes_[2]]};
            for (std::size_t i = 0; i < 3; ++i) origins_[i].set(row, o[axes_[i]], asked);
        }
        slopes_[0].set(row, shear.sx, asked), slopes_[1].set(row, shear.sy, asked);
        along_[row] =
            hn::GetLane(hn::MaxOfLanes(FloatTag(), hn::IfThenElseZero(asked, shear.along))) * kBeyond;
        rows_ |= 1U << row;
    }

    using Lanes = hn::VFromD<Floats>;
    struct Ends {
        Lanes low, high;
    };
    static HWY_INLINE Ends around(const Ends& a, const Ends& b, const Ends& c) {
        return {hn::Min(a.low, hn::Min(b.low, c.low)), hn::Max(a.high, hn::Max(b.high, c.high))};
    }

    /// What test() computes for several rays, from places and slopes between these ends, lies between the
    /// ends that are computed here in the same way, for rounding is monotonic.
    static HWY_INLINE Ends shearedAt(Lanes at, const Ends& slope, Lanes z) {
        const auto p = hn::Mul(slope.low, z), q = hn::Mul(slope.high, z);
        return {hn::Sub(at, hn::Max(p, q)), hn::Sub(at, hn::Min(p, q))};
    }
    static HWY_INLINE Ends shearedBetween(const Ends& at, const Ends& slope, const Ends& z) {
        const auto p = hn::Mul(slope.low, z.low), q = hn::Mul(slope.high, z.low);
        const auto r = hn::Mul(slope.low, z.high), s = hn::Mul(slope.high, z.high);
        return {hn::Sub(at.low, hn::Max(hn::Max(p, q), hn::Max(r, s))),
                hn::Sub(at.high, hn::Min(hn::Min(p, q), hn::Min(r, s)))};
    }

    /// Whether what lies between sheared ends lies on one side of all rays along an axis, behind all origins,
    /// or beyond all limits.
    HWY_INLINE hn::Mask<Floats> missed(const Ends& x, const Ends& y, const Ends& z, Lanes beyond) const {
        const auto zero = hn::Zero(Floats());
        const auto aside = hn::Or(hn::Gt(hn::Max(x.low, y.low), zero), hn::Lt(hn::Min(x.high, y.high), zero));
        const auto outside = forward_ ? hn::Or(hn::Lt(z.high, zero), hn::Gt(z.low, beyond))
                                      : hn::Or(hn::Gt(z.low, zero), hn::Lt(z.high, hn::Neg(beyond)));
        return hn::Or(aside, outside);
    }

    alignas(32) OfRows along_{}; // the third axis, the most of each row
    std::array<RowRanges, 2> slopes_;
    std::array<RowRanges, 3> origins_;
    std::array<std::size_t, 3> axes_;
    std::uint32_t rows_ = 0;                                          // that have rays, a bit each
    std::array<float, 3> origin_;                                     // of the first ray, turned
    std::array<Vec3Lanes, kOneOrigin ? 1 : kMostRows> turnedOrigins_; // where they differ
    std::array<ShearLanes, kMostRows> shears_;
    bool forward_ = true;
};

}
HWY_AFTER_NAMESPACE();

#endif
