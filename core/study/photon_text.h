#pragma once
// Photons in words.

#include <string>

#include "core/study/photon_film.h"

namespace eyeray {

/// A time for people: "0.42 s", "12 minutes", "41 days", "2 300 years", "5 million years".
std::string durationText(double seconds);

/// How rarely something happens: "1 in 83 000"; "none of 1 200" if it has not.
std::string rarityText(std::uint64_t times, std::uint64_t of);

/// How long a picture of so many pixels takes that gets one photon a pixel, if all goes on as in these
/// seconds: "at this rate a picture with one photon a pixel takes 41 days".
std::string forecastText(const PhotonTally&, std::uint64_t pixels, double seconds);

}
