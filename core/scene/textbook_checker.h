#pragma once
// A checkerboard in space.

#include <cmath>

namespace eyeray::textbook {

/// Cells of one metre, dark and light in turn along all axes. F54: on a plane that lies between two layers of
/// cells rounding chooses the layer, point by point.
template <class T>
bool isDarkCell(T x, T y, T z) {
    return (static_cast<long long>(std::floor(x) + std::floor(y) + std::floor(z)) & 1) != 0;
}

}
