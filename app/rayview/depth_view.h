#pragma once
// What of a line is hidden behind the scene.

#include <vector>

#include "app/rayview/projection.h"
#include "core/image/pixels.h"

namespace eyeray {

/// A projection with the depths of what has been drawn by it. Refers to both.
struct DepthView {
    const Projection& projection;
    const Pixels<float>& depth; // of the depth buffer; empty: nothing hides anything
    float tolerance = 0;        // metres that a line may lie behind a surface and still be on it

    bool hidden(const ScreenPoint&) const;
};

/// A piece of a line in a picture, all visible or all hidden; from and to as shares of the line.
struct VisiblePart {
    float from = 0, to = 1;
    bool hidden = false;
};

/// The line cut where it goes behind something, in order, without gaps; looked at every few pixels.
std::vector<VisiblePart> visibleParts(const DepthView&, const ScreenLine&);

}
