#pragma once
// From radiance to what a display shows: one function for screen, screenshot and files.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/image/pixels.h"

namespace eyeray {

/// Reinhard: L/(1 + L) on luminance (Reinhard et al. 2002, "Photographic Tone Reproduction for Digital
/// Images", eq. 3). Aces: fitted filmic curve (Narkowicz 2015, "ACES Filmic Tone Mapping Curve"). Clamp:
/// values above 1 are cut. None: clamp without the sRGB curve.
enum class ToneMap : std::uint8_t { None, Clamp, Reinhard, Aces };
inline constexpr std::array<std::string_view, 4> kToneMapNames = {"none", "clamp", "reinhard", "aces"};

struct DisplaySettings {
    double exposure = 0; // EV: radiance is multiplied by 2^exposure
    ToneMap toneMap = ToneMap::Clamp;

    friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// The bytes to show for each radiance; `shown` has the size of `radiance`.
void display(std::span<const Color> radiance, const DisplaySettings&, std::span<Rgba8> shown);
/// The same of a whole picture; all cores share a large one.
ByteImage display(const ColorImage& radiance, const DisplaySettings&);

/// Slope of the displayed value (0 to 1) against radiance luminance: how visible an error of the radiance is.
float displaySlope(float luminance, const DisplaySettings&);

/// Exposure (EV) that brings the log average luminance to 0.18; 0 for a black picture. Black pixels are left
/// out: a black background says nothing of the light on the things before it. Reinhard et al. 2002, eq. 1.
double meteredExposure(const ColorImage& radiance);

}
