// Eye rays of several pixels at once: the same bits as EyeRays::through. Compiled once for each instruction
// set, as core/base/lanes.h.
#if defined(EYERAY_EYE_RAY_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_EYE_RAY_LANES_H
#undef EYERAY_EYE_RAY_LANES_H
#else
#define EYERAY_EYE_RAY_LANES_H
#endif

#include "core/base/bit_lanes.h"
#include "core/transport/trace_context.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

HWY_INLINE Vec3Lanes eyeDirections(const EyeRays::Frame& frame, BitLanes x, BitLanes y,
                                   const PlaceLanes& inPixel) {
    const auto width = all(frame.width), height = all(frame.height), two = all(2.0F);
    const auto right = (two * (toFloat(x) + inPixel.x) - width) / width;
    const auto up = (height - two * (toFloat(y) + inPixel.y)) / height;
    return normalize(all(frame.forward) + all(frame.halfRight) * right + all(frame.halfUp) * up);
}

}
HWY_AFTER_NAMESPACE();

#endif
