#pragma once
// Colours for numbers.

#include "core/image/pixels.h"

namespace eyeray {

/// Colours for t from 0 to 1, clamped: dark blue, violet, red, orange, light yellow. Lighter always means
/// more, and equal steps of t are equal steps of colour, measured in OKLab: B. Ottosson 2020, "A perceptual
/// color space for image processing".
Rgba8 heatColor(double t);

/// Greys of equal steps of OKLab's lightness, from white at 0 to dark grey at 1, clamped.
Rgba8 depthColor(double t);

/// A colour for each number from 0 on; those of small numbers are far apart.
Rgba8 objectColor(int number);

}
