#pragma once
// How far two pictures differ. All throw InputError when their sizes do.

#include <cstddef>

#include "core/image/pixels.h"

namespace eyeray {

/// Root of the mean squared difference over all channels of all pixels; 0 for empty pictures, NaN if any
/// channel is.
double rmse(const ColorImage& a, const ColorImage& b);

/// Largest difference of any channel of any pixel, alpha included: 0 … 255.
int maxByteDifference(const ByteImage& a, const ByteImage& b);

/// Number of pixels that differ in any channel.
std::size_t countDifferingPixels(const ByteImage& a, const ByteImage& b);

}
