#include "core/geometry/shapes.h"
#include "core/geometry/solid.h"

namespace eyeray {
namespace {

constexpr std::uint32_t kSide = 0, kTop = 1, kBottom = 2;
constexpr double kInfinityD = std::numeric_limits<double>::infinity();

// The radius at height y is middle + slope·y.
struct Profile {
    explicit Profile(const Cylinder& c)
        : half(0.5 * c.height), middle(0.5 * (static_cast<double>(c.radiusTop) + c.radiusBottom)),
          slope((static_cast<double>(c.radiusTop) - c.radiusBottom) / c.height) {}
    double radius(double y) const { return std::fmax(0.0, middle + slope * y); }

    double half, middle, slope;
};

struct Interval {
    double begin = -kInfinityD, end = kInfinityD;
};

constexpr Interval kNone{kInfinityD, -kInfinityD};

// The part of the line inside the endless cone x² + z² ≤ w², w = middle + slope·y. Beyond its apex lies its
// mirror image, where w < 0: whatever of that is in the answer is not between the caps.
Interval insideCone(const Profile& profile, const DVec3& o, const DVec3& d) {
    const double w = profile.middle + profile.slope * o.y, dw = profile.slope * d.y;
    const double a = d.x * d.x + d.z * d.z - dw * dw;
    const double b = o.x * d.x + o.z * d.z - w * dw;
    const double c = o.x * o.x + o.z * o.z - w * w;
    // Equal to b² − ac (Lagrange's identity), without its cancellation.
    const double xw = o.x * dw - w * d.x, zw = o.z * dw - w * d.z, xz = o.x * d.z - o.z * d.x;
    const double discriminant = xw * xw + zw * zw - xz * xz;
    if (a > 0) {
        if (!(discriminant >= 0)) return kNone;
        const Roots roots = quadraticRoots(a, b, c, discriminant);
        return {roots.lower, roots.upper};
    }
    // Steeper than the side: inside on one side of one crossing; the other one is on the mirror image.
    if (a < 0) {
        const Roots roots = quadraticRoots(a, b, c, std::fmax(0.0, discriminant));
        return dw > 0 ? Interval{roots.upper, kInfinityD} : Interval{-kInfinityD, roots.lower};
    }
    // Along the side: one crossing, or none in a cylinder.
    if (b < 0) return {-c / (2 * b), kInfinityD};
    if (b > 0) return {-kInfinityD, -c / (2 * b)};
    return c <= 0 ? Interval{} : kNone;
}

Interval betweenCaps(const Profile& profile, const DVec3& o, const DVec3& d) {
    const double up = (profile.half - o.y) / d.y, down = (-profile.half - o.y) / d.y;
    if (d.y > 0) return {down, up};
    if (d.y < 0) return {up, down};
    return std::fabs(o.y) <= profile.half ? Interval{} : kNone;
}

// Where both pieces overlap: no ray slips through at the rim.
Passage passThrough(const Cylinder& cylinder, const Ray& ray) {
    const Profile profile(cylinder);
    const DVec3 o(ray.origin), d(ray.direction);
    const Interval caps = betweenCaps(profile, o, d), side = insideCone(profile, o, d);
    const std::uint32_t firstCap = d.y > 0 ? kBottom : kTop, lastCap = d.y > 0 ? kTop : kBottom;
    return {caps.begin > side.begin ? Crossing{caps.begin, firstCap} : Crossing{side.begin, kSide},
            caps.end < side.end ? Crossing{caps.end, lastCap} : Crossing{side.end, kSide}};
}

DVec3 sideNormal(const Profile& profile, const DVec3& p) {
    const double distance = std::hypot(p.x, p.z);
    if (!(distance > 0)) return {0, profile.slope > 0 ? -1.0 : 1.0, 0}; // the apex
    return safeNormalize(DVec3(p.x / distance, -profile.slope, p.z / distance));
}

}

std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray) {
    return firstEnd(passThrough(cylinder, ray), ray);
}

SurfacePoint surfaceAt(const Cylinder& cylinder, const Ray& ray, const Hit& hit) {
    const Profile profile(cylinder);
    DVec3 p = pointAtHit(ray, hit);
    p.y = std::clamp(p.y, -profile.half, profile.half);
    if (hit.primitive == kTop || hit.primitive == kBottom) {
        const double up = hit.primitive == kTop ? 1.0 : -1.0;
        p.y = up * profile.half;
        return surfacePoint(p, DVec3(0, up, 0));
    }
    const double distance = std::hypot(p.x, p.z);
    const double scale = distance > 0 ? profile.radius(p.y) / distance : 0.0;
    return surfacePoint(DVec3(scale * p.x, p.y, scale * p.z), sideNormal(profile, p));
}

Vec2 textureCoordinates(const Cylinder& cylinder, const SurfacePoint& point, std::uint32_t face) {
    const Vec3 p = point.position;
    const auto share = [](float value, float size) {
        return size > 0 ? std::clamp(0.5F + value / size, 0.0F, 1.0F) : 0.5F;
    };
    if (face == kSide) return {turn(p.x, p.z), share(-p.y, cylinder.height)};
    const float radius = face == kTop ? cylinder.radiusTop : cylinder.radiusBottom;
    return {share(p.x, 2 * radius), share(face == kTop ? p.z : -p.z, 2 * radius)};
}

}
