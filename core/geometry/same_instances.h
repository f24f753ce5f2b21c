#pragma once
// Whether an edit has left the geometry of a scene as it was.

#include <span>

#include "core/geometry/accel.h"

namespace eyeray {

/// True if every ray hits the same of both, bit for bit: as many instances, each with the same placement,
/// mask, and shape or index of a mesh.
template <class Index>
bool sameInstances(std::span<const Instance<Index>>, std::span<const Instance<Index>>);

}
