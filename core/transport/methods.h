#pragma once
// One Integrator for each method; each is made in the file of its name.

#include <memory>

#include "core/transport/integrator.h"

namespace eyeray {

/// Local illumination: what a rasteriser knows. No shadow, mirror or glass.
std::unique_ptr<Integrator> makeLocal();

/// Ray casting: eye rays, and shadow rays from what they hit.
/// Appel 1968, "Some Techniques for Shading Machine Renderings of Solids".
std::unique_ptr<Integrator> makeCast();

/// Recursive ray tracing with mirror reflection and refraction.
/// Whitted 1980, "An Improved Illumination Model for Shaded Display".
std::unique_ptr<Integrator> makeWhitted();

}
