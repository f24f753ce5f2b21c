#pragma once
// The curved side of a cylinder or cone that glows, outside and inside.

#include <optional>

#include "core/geometry/shapes.h"
#include "core/transport/emitter_shapes.h"

namespace eyeray {

/// Under an affine map. Only what a place sees of it is sampled: around the axis uniformly over the
/// generators that face the place, along the axis by the angle under which the place sees a line as far away
/// as they are: C. Kulla, M. Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating
/// Media", section 4.1. So a long tube nearby is no noisier than a short one.
class CylinderSide {
public:
    CylinderSide(const Cylinder&, const DMat4& map);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    /// Of a direction that hits it after `distance`.
    float pdfW(const Vec3& from, const Vec3& wi, float distance) const;
    double area() const { return area_; }

private:
    struct Seen;
    std::optional<Seen> seenFrom(const Vec3& from) const;
    double radiusAt(double y) const { return middle_ + slope_ * y; }
    float density(const Seen&, double turn, double y, const DVec3& to) const;

    DVec3 center_;
    DMat3 map_, inverse_;
    double half_, middle_, slope_; // the radius at height y is middle + slope·y
    double area_;
};

}
