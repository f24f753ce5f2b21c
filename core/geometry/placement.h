#pragma once
// Where an object stands: the map of its points to the world and back, prepared for rays and hits.

#include "core/base/math.h"
#include "core/geometry/affine.h"
#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"

namespace eyeray {

class Placement {
public:
    Placement() : Placement(DMat4(1)) {}
    /// From object space to the world's, by any affine map that has an inverse.
    explicit Placement(const DMat4& objectToWorld);

    /// The direction is not renormalised, so t means the same in both spaces.
    Ray toObject(const Ray& ray) const {
        if (!translates_) return worldToObject_.ray(ray);
        return {ray.origin + worldToObject_.translation, ray.direction, ray.tMin, ray.tMax};
    }
    Vec3 toObject(const Vec3& point) const { return worldToObject_.point(point); }
    Vec3 toWorld(const Vec3& point) const { return objectToWorld_.point(point); }

    /// A surface point of object space in world space. Normals by the inverse transpose (Turkowski 1990,
    /// "Properties of Surface-Normal Transformations", Graphics Gems): what is in front of the surface in
    /// object space stays in front of it, also under a map that mirrors, as glTF says of the winding of
    /// triangles. The error bound grows by errorAt (Pharr, Jakob, Humphreys 2023, "Physically Based
    /// Rendering" 4th ed., section 6.8.4).
    SurfacePoint toWorld(const SurfacePoint& point) const {
        SurfacePoint world;
        world.error = errorAt(point.position);
        if (translates_) {
            world.position = point.position + objectToWorld_.translation;
            world.error += point.error;
        } else {
            world.position = Vec3(DMat3(objectToWorld_.linear) * DVec3(point.position) +
                                  DVec3(objectToWorld_.translation));
            for (int axis = 0; axis < 3; ++axis)
                world.error += glm::abs(objectToWorld_.linear[axis]) * point.error[axis];
        }
        world.geometricNormal = normal(point.geometricNormal);
        world.shadingNormal = point.shadingNormal == point.geometricNormal ? world.geometricNormal
                                                                           : normal(point.shadingNormal);
        world.lift = objectToWorld_.linear * point.lift;
        return world;
    }

    /// How far the world position of an object-space point, mapped back as a ray's origin, may lie from the
    /// point through rounding: of both maps' entries, of both results. In world space, per axis.
    Vec3 errorAt(const Vec3& objectPoint) const { return errorGrowth_ * glm::abs(objectPoint) + errorBase_; }

    /// Holds every world point whose way back to object space, with its rounding, leads into the box.
    Bounds worldBounds(const Bounds& object) const;

    // The parts of these maps, for code that takes many rays at once.
    const Affine& objectToWorld() const { return objectToWorld_; }
    const Affine& worldToObject() const { return worldToObject_; }
    const Mat3& normals() const { return normals_; }
    const Mat3& errorGrowth() const { return errorGrowth_; }
    const Vec3& errorBase() const { return errorBase_; }
    bool translates() const { return translates_; }
    const Vec3& mirrors() const { return mirrors_; }

private:
    Vec3 normal(const Vec3& n) const {
        if (mirrors_ != Vec3(0)) return mirrors_ * n;
        const DVec3 mapped(normals_ * n);
        return Vec3(mapped / std::sqrt(glm::dot(mapped, mapped)));
    }

    Affine objectToWorld_, worldToObject_;
    Mat3 normals_;     // the inverse transpose, scaled to entries up to 1
    Mat3 errorGrowth_; // of errorAt: per metre of the point's distance from the origin
    Vec3 errorBase_;   // of errorAt: at the origin
    Vec3 mirrors_;     // of a map that scales evenly: the signs of its axes; else zero
    bool translates_;  // moves only
};

}
