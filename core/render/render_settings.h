#pragma once
// What a picture is rendered with.

#include <cstdint>

#include "core/render/display.h"
#include "core/transport/settings.h"

namespace eyeray {

/// Rendering ends at whichever comes first.
struct StopSettings {
    int samples = 256;    // per pixel, ≥ 1
    double seconds = 0;   // 0: no limit. At least one pass is kept
    double error = 0;     // standard error of the displayed values below this; 0: not looked at
    bool adaptive = true; // pixels end one by one, as core/render/adaptive.h says; else all together

    friend bool operator==(const StopSettings&, const StopSettings&) = default;
};

/// An error that no 8-bit display can show.
inline constexpr double kInvisibleError = 0.5 / 255;

struct RenderSettings {
    int width = 1280, height = 720; // pixels
    TraceSettings trace;
    DisplaySettings display; // only weighs the estimated error
    StopSettings stop;
    std::uint32_t seed = 0;
    int firstPass = 0;  // sample numbers start here
    bool coarse = true; // a coarse picture first

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// How the picture is shown: `display`, without the sRGB curve under Fault::NoGamma.
inline DisplaySettings shownDisplay(const RenderSettings& settings) {
    DisplaySettings display = settings.display;
    if (settings.trace.faults.has(Fault::NoGamma)) display.toneMap = ToneMap::None;
    return display;
}

}
