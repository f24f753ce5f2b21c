#pragma once
// A sample as it is being traced: ray by ray, with the algorithm beside it.

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/transport/recorder.h"
#include "core/transport/settings.h"

namespace eyeray {

/// One ray back or on, on to the next ray that hits something or to the next lamp's ray, or to either end.
enum class PlayTo : std::uint8_t { Start, Back, Next, Hit, Light, End };
inline constexpr std::array<std::string_view, 6> kPlayToNames = {"start", "back",  "next",
                                                                 "hit",   "light", "end"};

/// How many rays have been traced after the step, from 1 (the eye ray) to all. `traced`: how many before.
int played(const SampleRecord&, int traced, PlayTo);

/// Whether a sample has a ray that such a step stops at.
bool stopsIn(const SampleRecord&, PlayTo);

/// What was on record when so many rays had been traced.
SampleRecord firstRays(const SampleRecord&, int traced);

/// The method as a few lines of pseudo-code: ray casting (Appel 1968), recursive (Whitted 1980) or
/// distributed ray tracing (Cook 1984), or path tracing (Kajiya 1986).
std::span<const std::string_view> pseudoCode(Method);

/// Which of its lines trace this ray and deal with what it meets, in order.
std::vector<std::size_t> linesOf(Method, const RayRecord&);

}
