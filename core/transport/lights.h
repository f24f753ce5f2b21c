#pragma once
// Lamps as the taught methods see them: one point or one direction each.

#include <optional>
#include <vector>

#include "core/base/math.h"
#include "core/scene/camera.h"
#include "core/scene/world.h"

namespace eyeray {

struct LightSample {
    Vec3 wi{0};          // unit, from the surface to the lamp
    float distance = 0;  // infinite for a directional lamp
    Color irradiance{0}; // at normal incidence, unoccluded
};

/// How `position` sees the lamp, or nothing where the lamp does not shine.
/// Spot cone: smooth step squared between the cosines, as in KHR_lights_punctual.
std::optional<LightSample> sampleLight(const WorldLight&, const Vec3& position);

/// The World's lamps, with those that follow the camera where this camera puts them.
std::vector<WorldLight> lightsFor(const World&, const Camera&);

}
