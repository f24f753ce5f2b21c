#pragma once
// What switching a kind of rays on or off has changed, in a line.

#include <optional>
#include <string>

#include "app/viewer/comparison_rendering.h"

namespace eyeray {

/// The setting that takes back a switch of one kind of rays, such as "reflections=on"; nothing if anything
/// else has changed, too.
std::optional<std::string> switchedKind(const RenderSettings& before, const RenderSettings& now);

/// "reflection rays off: 1 234 567 rays fewer, 23.4 % of pixels changed", from the setting that takes it back
/// and the picture before as the other side.
std::string switchText(const std::string& takesBack, const PictureChange&);

}
