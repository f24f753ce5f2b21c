#pragma once
// Axis-aligned boxes.

#include <algorithm>

#include "core/base/math.h"

namespace eyeray {

/// Smallest box around what was added; empty when nothing was.
struct Bounds {
    Vec3 lo{kInfinity}, hi{-kInfinity};

    /// Coordinates that are NaN are left out.
    void add(const Vec3& p) { add(Bounds{p, p}); }
    void add(const Bounds& b) {
        lo = Vec3(std::min(lo.x, b.lo.x), std::min(lo.y, b.lo.y), std::min(lo.z, b.lo.z));
        hi = Vec3(std::max(hi.x, b.hi.x), std::max(hi.y, b.hi.y), std::max(hi.z, b.hi.z));
    }
    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    bool finite() const { return isFinite(lo) && isFinite(hi); }
    Vec3 center() const { return 0.5F * lo + 0.5F * hi; }
    Vec3 extent() const { return hi - lo; }
    float halfArea() const {
        if (empty()) return 0;
        const Vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

}
