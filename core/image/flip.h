#pragma once
// ꟻLIP: how far two displayed pictures look different when one is shown in place of the other. P. Andersson
// et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact.
// Tech. 3(2).

#include "core/image/pixels.h"

namespace eyeray {

/// Pixels per degree of a 0.7 m wide display of 3840 pixels seen from 0.7 m, as in the paper.
inline constexpr double kPixelsPerDegree = 67.02;

/// The difference at each pixel, 0 to 1, by colours as the eye filters them and by edges and points. Alpha is
/// left out of account. Throws InputError when the sizes differ.
Pixels<float> flip(const ByteImage& reference, const ByteImage& test,
                   double pixelsPerDegree = kPixelsPerDegree);

/// Mean of the same over all pixels; 0 for empty pictures.
double meanFlip(const Pixels<float>& differences);

}
