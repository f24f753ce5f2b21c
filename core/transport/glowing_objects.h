#pragma once
// Objects that glow, as lamps: for next-event estimation.

#include <optional>
#include <variant>
#include <vector>

#include "core/scene/world.h"
#include "core/transport/cylinder_side.h"
#include "core/transport/emitter_shapes.h"

namespace eyeray {

/// Flat part of a surface that glows on its front, or on both sides; sampled as `Side`, which glows on one.
template <class Side>
class GlowingFlat {
public:
    /// Its edges or axes are those of `Side`, placed by an affine map. Its front looks along `front`, as far
    /// as its normal does.
    GlowingFlat(const DMat4& place, const DVec3& center, const DVec3& x, const DVec3& y, const DVec3& front,
                bool bothSides);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    float pdfW(const Vec3& from, const Vec3& wi) const;
    double area() const { return front_.area(); }

private:
    GlowingFlat(const DVec3& center, const DVec3& x, const DVec3& y, const DVec3& front, bool bothSides);
    const Side& sideTowards(const Vec3& from) const;

    DVec3 center_, normal_;
    Side front_, back_;
    bool bothSides_;
};

using GlowingRectangle = GlowingFlat<SphericalRectangle>;
using GlowingDisc = GlowingFlat<SphericalDisc>;

/// The same of a triangle, which is sampled uniformly over its area: E. Heitz 2019, "A Low-Distortion Map
/// Between Triangle and Square".
class GlowingTriangle {
public:
    GlowingTriangle(const DVec3& corner, const DVec3& edgeA, const DVec3& edgeB, const DVec3& front,
                    bool bothSides);

    std::optional<ShapeSample> sample(const Vec3& from, const Vec2& u) const;
    float pdfW(const Vec3& from, const Vec3& wi) const;
    double area() const { return area_; }

private:
    float densityAt(double distance, double cosine) const;

    DVec3 corner_, edgeA_, edgeB_, normal_;
    double area_;
    bool bothSides_;
};

struct GlowSample : ShapeSample {
    Color radiance{0};
};

/// All objects of a World that glow and whose emission is the same all over: triangles of meshes, bounded
/// planes, boxes, spheres and cylinders, chosen by their power as luminance times area. Left out, and found
/// by chance alone, are infinite planes and what has textures or vertex colours. Shirley, Wang, Zimmerman
/// 1996, "Monte Carlo Techniques for Direct Lighting Calculations".
class GlowingObjects {
public:
    explicit GlowingObjects(const World&);

    bool empty() const { return parts_.empty(); }

    /// A direction to one of them, with u in [0, 1)², from a place on an instance of the World; nothing where
    /// it does not shine. What is round is no lamp to itself.
    std::optional<GlowSample> sample(const Vec3& from, std::uint32_t instance, const Vec2& u) const;

    /// Density with which sample() gives a direction that is known to hit this; 0 for what it leaves out.
    float pdfW(const Hit&, const Vec3& from, std::uint32_t instance, const Vec3& wi) const;

private:
    using Shape =
        std::variant<GlowingTriangle, GlowingRectangle, GlowingDisc, SphericalEllipsoid, CylinderSide>;
    struct Part {
        Shape shape;
        Color radiance;
        float probability;
        std::uint32_t instance;
        bool isRoundOf(std::uint32_t other) const {
            return instance == other && (std::holds_alternative<SphericalEllipsoid>(shape) ||
                                         std::holds_alternative<CylinderSide>(shape));
        }
    };
    void add(const World&, std::uint32_t instance);

    std::vector<Part> parts_;
    std::vector<float> below_;    // of each part: sum of the probabilities up to its end
    std::vector<int> ofInstance_; // first part; those of its primitives follow; −1: none
};

}
