#pragma once
// A tree of boxes as one first thinks of it.

#include <algorithm>
#include <span>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// Depth of the tree that halves the extent of all boxes' middles along its longest axis, and so on until one
/// is left; it puts them into another order. F26: of boxes that grow by powers of two each halving takes off
/// only one. Middles in one place are parted by none: here they are a leaf, where a program would not end.
template <class T>
int midpointDepth(std::span<Vector<T>> middles) {
    if (middles.size() < 2) return 0;
    Vector<T> lo = middles.front(), hi = lo;
    for (const Vector<T>& p : middles) lo = glm::min(lo, p), hi = glm::max(hi, p);
    const Vector<T> extent = hi - lo;
    int axis = extent.x >= extent.y ? 0 : 1;
    if (extent.z > extent[axis]) axis = 2;
    const T half = lo[axis] / 2 + hi[axis] / 2;
    const auto upper =
        std::partition(middles.begin(), middles.end(), [&](const Vector<T>& p) { return p[axis] < half; });
    const auto lower = static_cast<std::size_t>(upper - middles.begin());
    if (lower == 0 || lower == middles.size()) return 0;
    return 1 + std::max(midpointDepth(middles.first(lower)), midpointDepth(middles.subspan(lower)));
}

}
