#pragma once
// The boxes of the index over the scene, and what a ray tests of them, as a flat drawing.

#include "app/rayview/depth_view.h"
#include "app/rayview/ray_sketch.h"
#include "core/study/index_picture.h"

namespace eyeray {

/// Draws boxes as their edges, faint where the scene hides them, those missed dashed and thin, and triangles
/// filled.
void drawIndex(Sketch&, const DepthView&, const IndexPicture&, const RayStyle&);

/// How many of each there are, with its colour; `corner` is the lower right one.
void drawIndexLegend(Sketch&, const IndexPicture&, const RayStyle&, const Vec2& corner);

}
