// Rays, hits and surfaces of several rays at once, through the same steps as shapes.h and placement.h take
// one: the results are the same bits. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_RAY_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_RAY_LANES_H
#undef EYERAY_RAY_LANES_H
#else
#define EYERAY_RAY_LANES_H
#endif

#include "core/base/double_lanes.h"
#include "core/geometry/placement.h"
#include "core/geometry/ray.h"
#include "core/geometry/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

struct RayLanes {
    Vec3Lanes origin, direction;
    FloatLanes tMin, tMax;
};

struct RaySpread {
    Spread3 origin, direction;
    Spread tMin, tMax;

    explicit RaySpread(const RayLanes& rays)
        : origin(spread(rays.origin)), direction(spread(rays.direction)), tMin(spread(rays.tMin)),
          tMax(spread(rays.tMax)) {}
    Ray at(std::size_t lane) const {
        return {origin.at(lane), direction.at(lane), tMin.lane[lane], tMax.lane[lane]};
    }
};

/// Hits of one shape: t is infinite in lanes without one.
struct ShapeHitLanes {
    FloatLanes t, u; // as in Hit
    IntLanes face;
};

/// As SurfacePoint.
struct SurfaceLanes {
    Vec3Lanes position, error, geometricNormal, shadingNormal, lift;
};

struct SurfaceSpread {
    Spread3 position, error, geometricNormal, shadingNormal, lift;

    explicit SurfaceSpread(const SurfaceLanes& s)
        : position(spread(s.position)), error(spread(s.error)), geometricNormal(spread(s.geometricNormal)),
          shadingNormal(spread(s.shadingNormal)), lift(spread(s.lift)) {}
    void set(std::size_t lane, const SurfacePoint& p) {
        position.set(lane, p.position), error.set(lane, p.error);
        geometricNormal.set(lane, p.geometricNormal), shadingNormal.set(lane, p.shadingNormal);
        lift.set(lane, p.lift);
    }
    SurfaceLanes gathered() const {
        namespace here = eyeray::HWY_NAMESPACE;
        return {here::gathered(position), here::gathered(error), here::gathered(geometricNormal),
                here::gathered(shadingNormal), here::gathered(lift)};
    }
};

HWY_INLINE Vec3Lanes times(const Mat3& m, const Vec3Lanes& v) {
    const auto row = [&](int i) { return all(m[0][i]) * v.x + all(m[1][i]) * v.y + all(m[2][i]) * v.z; };
    return {row(0), row(1), row(2)};
}

HWY_INLINE DVec3Lanes times(const DMat3& m, const DVec3Lanes& v) {
    const auto row = [&](int i) { return all(m[0][i]) * v.x + all(m[1][i]) * v.y + all(m[2][i]) * v.z; };
    return {row(0), row(1), row(2)};
}

/// The next float above, as nextAbove.
HWY_INLINE FloatLanes nextAbove(FloatLanes v) {
    const IntTag i;
    return hn::BitCast(FloatTag(), hn::BitCast(i, v) + hn::Set(i, 1));
}

/// As nextTowards; up where `up` is not negative.
HWY_INLINE FloatLanes nextTowards(FloatLanes v, FloatMask up) {
    const IntTag i;
    const FloatTag f;
    const auto away = hn::Or(hn::And(v > hn::Zero(f), up), hn::And(v <= hn::Zero(f), hn::Not(up)));
    const auto step = hn::IfThenElse(hn::RebindMask(i, away), hn::Set(i, 1), hn::Set(i, -1));
    const auto next = hn::BitCast(f, hn::BitCast(i, v) + step);
    const auto fromZero = hn::IfThenElse(up, all(0x1p-126F), all(-0x1p-126F));
    return hn::IfThenElse(v == hn::Zero(f), fromZero, next);
}

HWY_INLINE Vec3Lanes spawnOrigin(const SurfaceLanes& point, const Vec3Lanes& direction) {
    const Vec3Lanes& normal = point.geometricNormal;
    const auto distance = dot(abs(normal), point.error) * all(kSpawnSlack);
    const Vec3Lanes offset = normal * hn::CopySign(distance, dot(normal, direction));
    const Vec3Lanes origin = point.position + offset;
    const auto outward = [](FloatLanes from, FloatLanes by) HWY_ATTR {
        const auto zero = hn::Zero(FloatTag());
        return hn::IfThenElse(by == zero, from, nextTowards(from, by > zero));
    };
    return {outward(origin.x, offset.x), outward(origin.y, offset.y), outward(origin.z, offset.z)};
}

HWY_INLINE RayLanes toObject(const Placement& placement, const RayLanes& ray) {
    const Affine& map = placement.worldToObject();
    const Vec3Lanes moved = all(map.translation);
    if (placement.translates()) return {ray.origin + moved, ray.direction, ray.tMin, ray.tMax};
    return {times(map.linear, ray.origin) + moved, times(map.linear, ray.direction), ray.tMin, ray.tMax};
}

HWY_INLINE Vec3Lanes normalToWorld(const Placement& placement, const Vec3Lanes& normal) {
    if (placement.mirrors() != Vec3(0)) return all(placement.mirrors()) * normal;
    const DVec3Lanes mapped = widen(times(placement.normals(), normal));
    return narrow(mapped / sqrt(dot(mapped, mapped)));
}

/// `point` has one normal for both uses, and no lift.
HWY_INLINE SurfaceLanes toWorld(const Placement& placement, const SurfaceLanes& point) {
    const Affine& map = placement.objectToWorld();
    SurfaceLanes world;
    world.error = times(placement.errorGrowth(), abs(point.position)) + all(placement.errorBase());
    if (placement.translates()) {
        world.position = point.position + all(map.translation);
        world.error = world.error + point.error;
    } else {
        world.position =
            narrow(times(DMat3(map.linear), widen(point.position)) + all(DVec3(map.translation)));
        world.error = world.error + all(glm::abs(map.linear[0])) * point.error.x;
        world.error = world.error + all(glm::abs(map.linear[1])) * point.error.y;
        world.error = world.error + all(glm::abs(map.linear[2])) * point.error.z;
    }
    world.geometricNormal = normalToWorld(placement, point.geometricNormal);
    world.shadingNormal = world.geometricNormal;
    world.lift = all(Vec3(0));
    return world;
}

/// As firstEnd in solid.h; ends that are NaN or infinite are none.
HWY_INLINE ShapeHitLanes firstEnd(DoubleLanes in, DoubleLanes out, IntLanes inFace, IntLanes outFace,
                                  const RayLanes& ray) {
    const auto t0 = narrow(in), t1 = narrow(out);
    const auto within = [&](FloatLanes t) HWY_ATTR { return hn::And(t > ray.tMin, t < ray.tMax); };
    const auto atFirst = within(t0), atSecond = hn::AndNot(atFirst, within(t1));
    const auto t = hn::IfThenElse(atFirst, t0, hn::IfThenElse(atSecond, t1, all(kInfinity)));
    auto u = narrow(in - widen(t0));
    if (!hn::AllFalse(FloatTag(), atSecond)) u = hn::IfThenElse(atSecond, narrow(out - widen(t1)), u);
    return {t, u, hn::IfThenElse(hn::RebindMask(IntTag(), atFirst), inFace, outFace)};
}

/// For rays whose tMin is not negative: a line that meets the sphere behind the ray alone, which most rays
/// that leave it do, needs no roots. Those of a line that misses it are NaN. Of the two, only the one that
/// such a ray can meet first is divided for: the lower from outside, the upper from within.
HWY_INLINE ShapeHitLanes intersect(const Sphere& sphere, const RayLanes& ray) {
    const double radius = sphere.radius;
    const auto zero = all(0.0);
    const auto face = hn::Zero(IntTag());
    const DVec3Lanes o = widen(ray.origin), d = widen(ray.direction);
    const auto a = dot(d, d), b = dot(o, d), c = dot(o, o) - all(radius * radius);
    const DVec3Lanes aside = cross(o, d);
    const auto discriminant = a * all(radius * radius) - dot(aside, aside);
    const auto behind = both(b >= zero, c >= zero);
    if (!(radius > 0) || none(butNot(behind, discriminant >= zero)))
        return {all(kInfinity), hn::Zero(FloatTag()), face};
    const auto q = -(b + copySign(sqrt(discriminant), b));
    const auto ahead = q > zero, outside = c > zero;
    const auto fromWithin = butNot(outside, ahead);
    auto root = select(fromWithin, q, c) / select(fromWithin, a, q);
    auto t = narrow(root);
    const auto tooNear = butNot(widen(t) > widen(ray.tMin), both(ahead, outside));
    if (!none(tooNear)) {
        root = select(tooNear, max(root, q / a), root);
        t = narrow(root);
    }
    const auto met = hn::And(t > ray.tMin, t < ray.tMax);
    return {hn::IfThenElse(met, t, all(kInfinity)), narrow(root - widen(t)), face};
}

HWY_INLINE DoubleLanes meetsPlane(const RayLanes& ray) {
    return -widen(ray.origin.y) / widen(ray.direction.y);
}

HWY_INLINE ShapeHitLanes intersect(const Plane& plane, const RayLanes& ray) {
    const auto none = all(kInfinity), zero = hn::Zero(FloatTag());
    const auto face = hn::Zero(IntTag());
    const auto descends = ray.direction.y < zero;
    if (!plane.doubleSided && hn::AllFalse(FloatTag(), descends)) return {none, zero, face};
    const auto t = meetsPlane(ray);
    const auto twice = [&](FloatLanes origin, FloatLanes direction)
                           HWY_ATTR { return abs(widen(origin) + t * widen(direction)) * all(2.0); };
    const auto x = twice(ray.origin.x, ray.direction.x), z = twice(ray.origin.z, ray.direction.z);
    const auto sizeX = all(static_cast<double>(plane.sizeX)), sizeZ = all(static_cast<double>(plane.sizeZ));
    auto inside = both(x <= sizeX, z <= sizeZ);
    if (plane.round) {
        const auto a = x / sizeX, b = z / sizeZ;
        inside = a * a + b * b <= all(1.0);
    }
    const auto rounded = narrow(select(inside, t, all(std::numeric_limits<double>::infinity())));
    auto met = hn::And(rounded > ray.tMin, rounded < ray.tMax);
    if (!plane.doubleSided) met = hn::And(met, descends);
    return {hn::IfThenElse(met, rounded, none), zero, face};
}

HWY_INLINE ShapeHitLanes intersect(const Box& box, const RayLanes& ray) {
    const auto zero = all(0.0);
    auto in = all(-std::numeric_limits<double>::infinity()), out = -in;
    auto inFace = zero, outFace = zero;
    auto met = in < out;
    const auto cut = [&](FloatLanes origin, FloatLanes direction, double half, double lowerFace) HWY_ATTR {
        const auto o = widen(origin), along = widen(direction);
        const auto lower = (all(-half) - o) / along, upper = (all(half) - o) / along;
        const auto positive = along > zero, still = along == zero;
        const auto begin = select(positive, lower, upper), end = select(positive, upper, lower);
        const auto between = both(still, abs(o) <= all(half));
        met = both(met, either(between, butNot(still, begin <= end)));
        const auto later = butNot(still, begin > in), sooner = butNot(still, end < out);
        in = select(later, begin, in), out = select(sooner, end, out);
        const auto below = all(lowerFace), above = all(lowerFace + 1);
        inFace = select(later, select(positive, below, above), inFace);
        outFace = select(sooner, select(positive, above, below), outFace);
    };
    cut(ray.origin.x, ray.direction.x, 0.5 * box.size.x, 0);
    cut(ray.origin.y, ray.direction.y, 0.5 * box.size.y, 2);
    cut(ray.origin.z, ray.direction.z, 0.5 * box.size.z, 4);
    if (none(met)) return {all(kInfinity), hn::Zero(FloatTag()), hn::Zero(IntTag())};
    const auto never = all(std::numeric_limits<double>::infinity());
    const auto there = both(met, in <= out);
    return firstEnd(select(there, in, never), select(there, out, never), toInts(inFace), toInts(outFace),
                    ray);
}

/// Ray by ray: quadrics with caps have too many cases to be taken at once.
inline ShapeHitLanes intersect(const Cylinder& cylinder, const RayLanes& rays) {
    const RaySpread single(rays);
    Spread t, u;
    SpreadInt face;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const Hit hit = eyeray::intersect(cylinder, single.at(lane)).value_or(Hit{});
        t.lane[lane] = hit.t, u.lane[lane] = hit.u, face.set(lane, hit.primitive);
    }
    return {gathered(t), gathered(u), gathered(face)};
}

/// The surface at hits of this shape; all in object space.
HWY_INLINE SurfaceLanes surfaceAt(const DVec3Lanes& position, const Vec3Lanes& normal) {
    const Vec3Lanes p = narrow(position);
    return {p, abs(p) * all(gammaBound(1)), normal, normal, all(Vec3(0))};
}

/// As pointAtHit in solid.h.
HWY_INLINE DVec3Lanes pointAtHit(const RayLanes& ray, const ShapeHitLanes& hit) {
    return widen(ray.origin) + widen(ray.direction) * (widen(hit.t) + widen(hit.u));
}

HWY_INLINE SurfaceLanes surfaceAt(const Sphere& sphere, const RayLanes& ray, const ShapeHitLanes& hit) {
    const DVec3Lanes p = pointAtHit(ray, hit);
    const auto square = dot(p, p);
    const auto zero = all(0.0);
    const DVec3Lanes normal = p * select(square > zero, all(1.0) / sqrt(square), zero);
    return surfaceAt(normal * all(static_cast<double>(sphere.radius)), narrow(normal));
}

HWY_INLINE SurfaceLanes surfaceAt(const Plane&, const RayLanes& ray, const ShapeHitLanes&) {
    const auto t = meetsPlane(ray);
    const DVec3Lanes p{widen(ray.origin.x) + t * widen(ray.direction.x), all(0.0),
                       widen(ray.origin.z) + t * widen(ray.direction.z)};
    return surfaceAt(p, all(Vec3(0, 1, 0)));
}

HWY_INLINE SurfaceLanes surfaceAt(const Box& box, const RayLanes& ray, const ShapeHitLanes& hit) {
    const IntTag n;
    const FloatTag f;
    DVec3Lanes p = pointAtHit(ray, hit);
    Vec3Lanes normal;
    const auto bit = hn::And(hit.face, hn::Set(n, 1)), axis = hit.face - bit; // 0, 2, 4
    const auto upper = hn::RebindMask(f, bit == hn::Set(n, 1));
    const auto side = hn::IfThenElse(upper, all(1.0F), all(-1.0F));
    const auto settle = [&](DoubleLanes& position, FloatLanes& component, double half,
                            int twiceAxis) HWY_ATTR {
        component = hn::IfThenElseZero(hn::RebindMask(f, axis == hn::Set(n, twiceAxis)), side);
        const auto clamped = min(max(position, all(-half)), all(half));
        const auto wide = widen(component);
        position = select(wide == all(0.0), clamped, wide * all(half));
    };
    settle(p.x, normal.x, 0.5 * box.size.x, 0);
    settle(p.y, normal.y, 0.5 * box.size.y, 2);
    settle(p.z, normal.z, 0.5 * box.size.z, 4);
    return surfaceAt(p, normal);
}

}
HWY_AFTER_NAMESPACE();

#endif
