#pragma once
// Whether an edit has left the geometry of a scene as it was.

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/accel.h"

namespace eyeray {

/// True if every ray hits the same of both, bit for bit: as many instances, each with the same placement,
/// mask, and shape or index of a mesh.
template <class Index>
bool sameInstances(std::span<const Instance<Index>>, std::span<const Instance<Index>>);

/// The world boxes, before and after, of the few objects that are not the same: rays that miss these hit the
/// same of both, bit for bit. Nothing if there are more or fewer instances, or many differ.
std::optional<std::vector<Bounds>> changedBounds(const Accel& before, const Accel& after);

}
