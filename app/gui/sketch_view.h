#pragma once
// Flat drawings on the screen and in files.

#include <imgui.h>

#include "app/gl/texture.h"
#include "app/rayview/sketch.h"

namespace eyeray {

/// A drawing over a picture of OpenGL's, whose first row is the lowest.
struct SketchedPicture {
    const Sketch& sketch;
    Vec2 size;    // pixels
    float letter; // height of the text, pixels
    Ink ground;   // under the labels
};

/// Adds both to the list, their top left corner at `corner`.
void draw(ImDrawList&, const SketchedPicture&, const GlTexture& picture, ImVec2 corner);

/// Both as one image. Throws Failure for a size that the graphics card refuses.
ByteImage imageOf(const Gl&, const SketchedPicture&, const GlTexture& picture);

/// The text of an SVG file: the picture, and over it the drawing as vectors.
std::string svgOf(const SketchedPicture&, const ByteImage& picture);

}
