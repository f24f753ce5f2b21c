#pragma once
// What is struck out of one pixel's sum, struck out of the whole picture.

#include <vector>

#include "app/document/command.h"
#include "app/viewer/pixel_study.h"

namespace eyeray {

/// The commands that take what is struck out away everywhere: a lamp is switched off, a kind of ray, shadow
/// rays for one that is unblocked, a weight of the material, the ambient light, the sky. Throws InputError
/// for a term that nothing takes away by itself.
std::vector<Command> strikesEverywhere(const PixelStudy&, const SampleRecord&, const Scene&);

}
