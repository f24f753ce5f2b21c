#pragma once
// Rows of pixels, top row first.

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/errors.h"
#include "core/base/large_pages.h"
#include "core/base/math.h"

namespace eyeray {

inline constexpr int kMaxPictureSide =
    16384; // pixels, of pictures read or rendered; also what OpenGL 4 hardware takes as a texture

/// width × height values, row by row from the top left.
template <class T>
class Pixels {
public:
    Pixels() = default;
    /// Throws InternalError for a negative size.
    Pixels(int width, int height, T value = T{}) : width_(width), height_(height) {
        ENSURE(width >= 0 && height >= 0);
        values_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value);
    }
    /// Of these values, as many as there are pixels.
    Pixels(int width, int height, LargeArray<T> values)
        : width_(width), height_(height), values_(std::move(values)) {
        ENSURE(width >= 0 && height >= 0);
        ENSURE(values_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return values_.empty(); }

    T& at(int x, int y) { return values_[index(x, y)]; }
    const T& at(int x, int y) const { return values_[index(x, y)]; }
    LargeArray<T>& values() { return values_; }
    const LargeArray<T>& values() const { return values_; }

    friend bool operator==(const Pixels&, const Pixels&) = default;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    LargeArray<T> values_;
};

/// What a display takes: sRGB-coded, alpha not premultiplied.
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

using ColorImage = Pixels<Color>; // linear Rec. 709
using ByteImage = Pixels<Rgba8>;

}
