#pragma once
// The failure lab: scenes made by rule in which a textbook formula fails, each with a slider that says how
// badly.

#include <span>
#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace eyeray {

struct LabSlider {
    std::string_view label;
    double lowest, highest, start;
    bool logarithmic = false, whole = false;
};

/// One demonstration. The scene's own settings are the robust side.
struct LabDemo {
    std::string_view name;  // also of its scene
    std::string_view title; // what fails
    std::string_view why;   // one line
    std::string_view fix;   // one line that cites it
    LabSlider slider;
    Scene (*scene)(double value);
    std::string (*naive)(double value); // settings of the naive side, as `set` takes them
};

/// In the order of a lecture.
std::span<const LabDemo> labDemos();

/// The demonstration of this name, or nullptr.
const LabDemo* labDemoNamed(std::string_view name);

/// Its scene for a value of the slider, which is put into the slider's range.
Scene labScene(const LabDemo&, double value);

/// The value so many twentieths of the slider's way on; a whole one moves by 1 at least.
double labStep(const LabDemo&, double value, int steps);

/// The value put into the slider's range, and rounded where only whole ones make sense.
double labValue(const LabDemo&, double value);

}
