#include "core/study/photon_text.h"

#include <array>

#include <fmt/format.h>

#include "core/study/wording.h"

namespace eyeray {
namespace {

struct Unit {
    double seconds;
    const char* name;
};
constexpr double kYear = 365.25 * 86400;
constexpr std::array kUnits = {Unit{1e9 * kYear, "billion years"},
                               Unit{1e6 * kYear, "million years"},
                               Unit{kYear, "years"},
                               Unit{86400, "days"},
                               Unit{3600, "hours"},
                               Unit{60, "minutes"}};
constexpr double kLeast = 2; // of a unit: less is told in the next smaller one

/// With two digits that count, without an exponent.
std::string roundText(double value) {
    if (value < 10) return fmt::format("{:.2g}", value);
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return countText(static_cast<std::uint64_t>(std::round(value / step) * step));
}

}

std::string durationText(double seconds) {
    for (const Unit& unit : kUnits)
        if (seconds >= kLeast * unit.seconds)
            return fmt::format("{} {}", roundText(std::min(seconds / unit.seconds, 1e15)), unit.name);
    return fmt::format("{:.2g} s", seconds);
}

std::string rarityText(std::uint64_t times, std::uint64_t of) {
    if (times == 0) return fmt::format("none of {}", countText(of));
    return fmt::format("1 in {}", roundText(static_cast<double>(of) / static_cast<double>(times)));
}

std::string forecastText(const PhotonTally& tally, std::uint64_t pixels, double seconds) {
    if (tally.emitted == 0) return "no photon has left yet";
    const double photons = static_cast<double>(pixels);
    if (tally.onPicture == 0)
        return fmt::format("not one has come into the picture yet: one photon a pixel takes more than {}",
                           durationText(photons * seconds));
    return fmt::format("at this rate a picture with one photon a pixel takes {}",
                       durationText(photons / static_cast<double>(tally.onPicture) * seconds));
}

}
