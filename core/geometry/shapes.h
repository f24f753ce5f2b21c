#pragma once
// Shapes with their own intersection, not meshes. All lie around the origin of their object space, y is the
// axis, as in the glTF extension KHR_implicit_shapes.

#include <optional>
#include <variant>

#include "core/base/math.h"
#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"

namespace eyeray {

struct Sphere {
    float radius = 0.5F;
};

/// Rectangle in the plane y = 0 facing +y; infinite along an axis whose size is infinite.
struct Plane {
    float sizeX = kInfinity, sizeZ = kInfinity; // full extents
    bool doubleSided = false;                   // else rays from below pass
    bool round = false; // only the ellipse within: a disc, where both sizes are the same
};

struct Box {
    Vec3 size{1}; // full extents
};

/// Closed cylinder, capped cone or, with one radius 0, cone.
struct Cylinder {
    float height = 0.5F;
    float radiusTop = 0.25F, radiusBottom = 0.25F;
};

using Shape = std::variant<Sphere, Plane, Box, Cylinder>;

/// Closest hit in (tMin, tMax), or nothing; `primitive` is the face: a box counts −x +x −y +y −z +z as 0 to
/// 5, a cylinder side, top and bottom as 0, 1, 2. `v` and `instance` stay 0. Never returns NaN.
/// Thread-safe. Roots of quadrics are found in double. Haines, Günther, Akenine-Möller 2019, "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.
std::optional<Hit> intersect(const Sphere&, const Ray&);
std::optional<Hit> intersect(const Plane&, const Ray&);
std::optional<Hit> intersect(const Box&, const Ray&);
std::optional<Hit> intersect(const Cylinder&, const Ray&);
std::optional<Hit> intersect(const Shape&, const Ray&);

/// The surface at a hit that `intersect` returned for this ray; all in object space.
SurfacePoint surfaceAt(const Sphere&, const Ray&, const Hit&);
SurfacePoint surfaceAt(const Plane&, const Ray&, const Hit&);
SurfacePoint surfaceAt(const Box&, const Ray&, const Hit&);
SurfacePoint surfaceAt(const Cylinder&, const Ray&, const Hit&);
SurfacePoint surfaceAt(const Shape&, const Ray&, const Hit&);

/// Texture coordinates at a surface point of the given face. Sphere: (longitude, latitude from the top) in
/// [0, 1]². Plane: (x, z) in object units from its centre. Box: [0, 1]² on each face. Cylinder: (angle,
/// height) in [0, 1]² on its side, [0, 1]² over each cap. Always finite, poles and seams included.
Vec2 textureCoordinates(const Sphere&, const SurfacePoint&, std::uint32_t face);
Vec2 textureCoordinates(const Plane&, const SurfacePoint&, std::uint32_t face);
Vec2 textureCoordinates(const Box&, const SurfacePoint&, std::uint32_t face);
Vec2 textureCoordinates(const Cylinder&, const SurfacePoint&, std::uint32_t face);
Vec2 textureCoordinates(const Shape&, const SurfacePoint&, std::uint32_t face);

/// Smallest box around the shape; infinite along the infinite axes of a plane.
Bounds boundsOf(const Shape&);

/// True if the shape has an inside (all but the plane).
bool isSolid(const Shape&);

}
