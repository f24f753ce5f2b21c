#pragma once
// Flat drawings on the screen.

#include <imgui.h>

#include "app/rayview/sketch.h"

namespace eyeray {

/// Adds the drawing to the list, its top left corner at `corner`. Labels stand on `ground`; they are moved
/// where they would reach beyond `size` or lie on an earlier one, and left out where their point is outside
/// or nothing is free near it.
void drawSketch(ImDrawList&, const Sketch&, ImVec2 corner, ImVec2 size, const Ink& ground);

}
