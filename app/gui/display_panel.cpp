#include <array>

#include "app/gui/panels.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kToneMapLabels = {"none (linear)"sv, "clamp"sv, "Reinhard 2002"sv,
                                       "ACES (Narkowicz 2015)"sv};
constexpr std::array kAccelLabels = {"auto"sv, "brute force"sv, "BVH"sv};

}

void displayPanel(const Widgets& ui) {
    ui.number("Exposure", "exposure", -8, 8, "%+.1f EV");
    ui.choice("Tone mapping", "tonemap", kToneMapNames, kToneMapLabels);
    ui.integer("Samples", "samples", 1, 4096, true);
    ui.choice("Accelerator", "accel", kAccelNames, kAccelLabels);
}

}
