#pragma once
// Adaptive sampling: pixels have as many samples as their surroundings' noise asks for.
//
// After 4, 8, 16, … passes it is decided how many of the passes until the next decision each pixel is to take
// part in: so many that its standard error falls below what is asked. What a sample of it varies by is taken
// from the pixels around it and never from its own samples: a pixel that has by chance met no light yet does
// not end for that, and its mean stays right (D. Kirk, J. Arvo 1991, "Unbiased Sampling Techniques for Image
// Synthesis", who draw the number of samples from others than those of the mean). After the first decision
// that is no longer exact, as its neighbours' number of samples depends on its own; tests/adaptive_test.cpp
// measures what is left.

#include <span>
#include <vector>

#include "core/render/film.h"

namespace eyeray {

/// Passes before the first decision: the fewest samples that a pixel has.
inline constexpr int kAdaptivePilot = 4;
/// Passes before a picture whose pixels all end together first looks whether its error is small enough.
inline constexpr int kErrorPilot = 16;

/// Whether something is decided after so many passes: 4, 8, 16, …
bool isAdaptiveStage(int passes);

/// Variance of one sample of each pixel by the pixels around it, row by row, itself left out: mean over the
/// 5×5 pixels about it, held towards the mean over 33×33 as long as few samples speak: in the place of as
/// many pixels as stand about it after the pilot, half as many for twice the passes. So rare light that a few
/// neighbours have all missed is still expected where others nearby have met it.
std::vector<double> surroundingVariances(std::span<const double> variances, int width, int height,
                                         int passes);

/// How many samples each pixel is to have at the next decision, so that its standard error falls below
/// `error`: from `samples`, that it has had, if that is enough or it has ended already, to 2 · passes.
std::vector<int> nextLimits(std::span<const double> variances, std::span<const int> samples, int passes,
                            double error);

/// How many samples each pixel is likely to end with, by what is known after `passes`: no more than `most`,
/// in all of whose passes it would take part.
std::vector<int> likelySamples(const Film&, int passes, double error, const DisplaySettings&, int most);

/// Decides on the film after so many passes. To be called between passes.
void decideSamples(Film&, int passes, double error, const DisplaySettings&);

}
