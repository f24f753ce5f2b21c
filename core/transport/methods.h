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

/// Distributed ray tracing: each hit sends one shadow ray to a place on each lamp, one ray into the lobe of
/// its mirror image and one into that of its glass; no light goes from one diffuse surface to another. Cook,
/// Porter, Carpenter 1984, "Distributed Ray Tracing".
std::unique_ptr<Integrator> makeDistributed();

/// Path tracing: each hit sends shadow rays and one ray on, of a kind that is drawn. Lamps are sought both by
/// shadow rays and by the rays that go on, weighed by the power heuristic; after depth 3 Russian roulette
/// ends paths on average as they fade. Glass blocks shadow rays: a lamp with an extent shines through it by
/// rays that go on and find it, a point lamp, which no ray can find, does not. Kajiya 1986, "The Rendering
/// Equation"; Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", chapter 9; Arvo, Kirk
/// 1990, "Particle Transport and Image Synthesis".
std::unique_ptr<Integrator> makePath();

}
