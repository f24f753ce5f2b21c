#pragma once
// Which place in the picture a pixel stands for.

namespace eyeray::textbook {

/// From −1 at the first of `width` pixels to 1 at the last. F63: half a pixel off at the edges, so that a
/// picture shows 1/(width − 1) more than its field of view.
template <class T>
T pixelPosition(int x, int width) {
    return T(2) * static_cast<T>(x) / static_cast<T>(width - 1) - 1;
}

}
