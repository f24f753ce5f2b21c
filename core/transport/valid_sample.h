#pragma once
// Samples that are no numbers.

#include "core/base/math.h"
#include "core/transport/ray_counts.h"

namespace eyeray {

/// The radiance of a sample; black, and counted, if it is not finite: one such sample would spoil its pixel
/// for ever.
inline Color validSample(const Color& radiance, RayCounts& counts) {
    if (isFinite(radiance)) return radiance;
    ++counts.invalidSamples;
    return Color(0);
}

}
