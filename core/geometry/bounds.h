#pragma once
// Axis-aligned boxes.

#include "core/base/math.h"

namespace eyeray {

/// Smallest box around what was added; empty when nothing was.
struct Bounds {
    Vec3 lo{kInfinity}, hi{-kInfinity};

    void add(const Vec3& p) {
        lo = Vec3(std::fmin(lo.x, p.x), std::fmin(lo.y, p.y), std::fmin(lo.z, p.z));
        hi = Vec3(std::fmax(hi.x, p.x), std::fmax(hi.y, p.y), std::fmax(hi.z, p.z));
    }
    void add(const Bounds& b) {
        add(b.lo);
        add(b.hi);
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
