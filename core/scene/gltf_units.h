#pragma once
// Units of glTF that are not ours.

namespace eyeray {

/// KHR_lights_punctual counts in candela and lux; radiometric units follow by the luminous efficacy of
/// monochromatic light of 540 THz, which defines the candela (BIPM 2019, "The International System of
/// Units").
inline constexpr double kLumensPerWatt = 683;

}
