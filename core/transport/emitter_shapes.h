#pragma once
// Directions to what has an extent, drawn uniformly over its solid angle where that can be had.

#include <optional>

#include "core/scene/scene.h"

namespace eyeray {

struct ShapeSample {
    Vec3 wi{0};         // unit
    float distance = 0; // to the surface
    float pdfW = 0;
    float emitterCosine = 1; // of the angle at the shape; of round ones 1
};

/// One-sided parallelogram. Rectangles are sampled uniformly over their solid angle: C. Ureña, M. Fajardo, A.
/// King 2013, "An Area-Preserving Parametrization for Spherical Rectangles"; those that look small, and other
/// parallelograms, uniformly over their area.
class SphericalRectangle {
public:
    /// The light leaves on the side of cross(edgeX, edgeY).
    SphericalRectangle(const DVec3& center, const DVec3& edgeX, const DVec3& edgeY);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    /// Of a direction that hits its front.
    float pdfW(const Vec3& from, const Vec3& wi) const;

    std::optional<ShapeSample> sampleByArea(const Vec3& from, const Vec2& u) const;
    /// Of a point of its plane, as sampleByArea gives one.
    ShapeSample towards(const Vec3& from, const DVec3& point) const;
    /// Steradians, as seen from its front; 0 where it is sampled by area.
    double solidAngle(const Vec3& from) const;
    double area() const { return area_; }

private:
    struct Seen;
    std::optional<Seen> seenFrom(const Vec3& from) const;

    DVec3 center_, edgeX_, edgeY_, normal_;
    double area_;
    bool rectangular_;
};

/// One-sided disc under an affine map. From afar it is sampled uniformly over its area: P. Shirley, K. Chiu
/// 1997, "A Low Distortion Map Between Disk and Square"; from nearby, where 1/r² would be noise without
/// bounds, uniformly over the solid angle of the rectangle around it, whose corners give nothing.
class SphericalDisc {
public:
    /// The light leaves on the side of cross(axisX, axisY), which reach to its rim. `byArea`: also from
    /// nearby.
    SphericalDisc(const DVec3& center, const DVec3& axisX, const DVec3& axisY, bool byArea = false);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    /// Of a direction that hits its front.
    float pdfW(const Vec3& from, const Vec3& wi) const;
    double area() const { return area_; }

private:
    bool near(const Vec3& from) const;
    float densityByArea(const ShapeSample&) const;
    bool contains(const DVec3& point) const;

    DVec3 center_, axisX_, axisY_;
    DMat3 toUnit_; // the disc to that of radius 1 in x and y
    SphericalRectangle around_;
    double area_;
    bool byArea_;
};

/// A sphere under an affine map; a true sphere is sampled uniformly over its cone of directions.
class SphericalEllipsoid {
public:
    /// The image of the unit sphere around the origin.
    explicit SphericalEllipsoid(const DMat4& map);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    /// Of a direction that hits it.
    float pdfW(const Vec3& from, const Vec3& wi) const;
    double area() const; // of the sphere of the same volume

private:
    DVec3 center_;
    DMat3 map_, inverse_;
};

/// The sky of an Environment, sampled in proportion to its luminance.
class SkyGradient {
public:
    explicit SkyGradient(const Environment&);

    Color radiance(const Vec3& wi) const { return sky_.radiance(wi); }
    ShapeSample sample(const Vec2& u) const;
    float pdfW(const Vec3& wi) const;

private:
    Environment sky_;
    float zenith_, horizon_, nadir_; // integrals of luminance over directions
};

}
