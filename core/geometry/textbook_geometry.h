#pragma once
// The objects of a World met by the formulas of textbooks, as far as faults ask for them.

#include <memory>

#include "core/base/fault.h"
#include "core/geometry/accel.h"

namespace eyeray {

/// Names the index that carries faults: a binary BVH.
struct Textbook;

template <>
struct IndexedGeometry<Textbook> {
    FaultSet faults;
    float epsilon = 0; // least t of any ray under Fault::GlobalEpsilon
    bool inDouble = false;
    Vec3 moved{0}; // from the World's origin to the one that floats are relative to
    IndexedGeometry<Bvh2> placed;
};

using TextbookGeometry = IndexedGeometry<Textbook>;

/// The same objects under the same numbers. `origin` is the World's; Fault::FloatWorld takes the scene's own
/// in its place.
std::shared_ptr<const TextbookGeometry> textbookGeometry(const Accel&, const DVec3& origin, FaultSet,
                                                         float epsilon, bool inDouble);

template <>
std::optional<Hit> closestHit(const TextbookGeometry&, const Ray&, RayMask);
template <>
bool anyHit(const TextbookGeometry&, const Ray&, RayMask);
template <>
SurfacePoint surfaceAt(const TextbookGeometry&, const Ray&, const Hit&);
template <>
Vec2 textureCoordinates(const TextbookGeometry&, const SurfacePoint&, const Hit&, int set);
template <>
Vec4 vertexColor(const TextbookGeometry&, const Hit&);

}
