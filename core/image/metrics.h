#pragma once
// How far two pictures differ. All throw InputError when their sizes do.

#include <cstddef>

#include "core/image/pixels.h"

namespace eyeray {

/// Root of the mean squared difference over all channels of all pixels; 0 for empty pictures, NaN if any
/// channel is.
double rmse(const ColorImage& a, const ColorImage& b);

/// Mean over all channels of (test − reference)² / (reference² + 0.01): errors as shares of what is there. F.
/// Rousselle, C. Knaus, M. Zwicker 2011, "Adaptive Sampling and Reconstruction using Greedy Error
/// Minimization".
double relativeMse(const ColorImage& reference, const ColorImage& test);

/// Largest difference of any channel of any pixel; NaN if any channel is.
double maxDifference(const ColorImage& a, const ColorImage& b);

/// Difference that 95 of 100 channels stay below; NaN if any channel is.
double percentile95(const ColorImage& a, const ColorImage& b);

/// Largest difference of any channel of any pixel, alpha included: 0 … 255.
int maxByteDifference(const ByteImage& a, const ByteImage& b);

/// True if two displayed colours differ by more than two ways to the same colour may, 2 of 255 in a channel.
bool clearlyDiffers(const Rgba8&, const Rgba8&);

/// Number of pixels that differ in any channel.
std::size_t countDifferingPixels(const ByteImage& a, const ByteImage& b);

}
