#pragma once
// Where the labels of a drawing stand, so that each can be read.

#include <vector>

#include "app/rayview/sketch.h"

namespace eyeray {

/// A label on its plate; pixels from the drawing's top left corner.
struct PlacedLabel {
    const SketchLabel* label; // of the sketch
    Vec2 corner, extent;      // of the plate
    Vec2 text;                // top left of the letters
    float height;             // of a line
};

/// The labels of a drawing of this size, whose letters are `letter` pixels high, measured with ImGui's font.
/// They are moved where they would reach beyond the drawing or lie on an earlier one, and left out where
/// their point is outside or nothing is free near it.
std::vector<PlacedLabel> placeLabels(const Sketch&, const Vec2& size, float letter);

}
