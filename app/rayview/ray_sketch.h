#pragma once
// Rays, lamps, eye, image plane and angles as a flat drawing over the scene seen from outside.

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "app/rayview/arrows.h"
#include "app/rayview/depth_view.h"
#include "app/rayview/image_plane.h"
#include "app/rayview/sketch.h"
#include "core/study/photon_walk.h"

namespace eyeray {

/// Colours and measures of the drawing.
struct RayStyle {
    std::array<Ink, kRayKinds> kinds;
    std::array<Ink, 5> boxes; // by SpaceBox::Role
    Ink blocked{1};           // of a light ray up to its blocker
    Ink unlit{0};             // the same behind it
    Ink highlight{1};         // around the selected ray
    Ink text{1}, ground{0};
    float scale = 1;   // pixels for a length of 1
    float letter = 17; // height of the text, pixels
};

/// Draws the arrows: coloured and dashed by kind, as thick as their weight, faint where the scene hides
/// them, fading where they are endless, dark behind a blocker. Arrow i has the tag i. `selected` is an
/// index of `arrows`, −1 for none; `thickness` multiplies all widths.
void drawArrows(Sketch&, const DepthView&, const std::vector<Arrow>&, const RayStyle&, int selected,
                float thickness);

/// The arrow nearest to a point of the picture, of those of sample 0; −1 if none is within this many pixels.
int arrowAt(const Projection&, const std::vector<Arrow>&, const Vec2& point, float within);

/// Eye, image plane with its corners' coordinates, the picked pixel, and the lamps.
void drawEye(Sketch&, const DepthView&, const ImagePlane&, const RayStyle&, bool labels);
void drawPixel(Sketch&, const DepthView&, const ImagePlane&, const DVec2& pixel, int width, int height,
               const RayStyle&);
void drawLamps(Sketch&, const DepthView&, const World&, const RayStyle&, bool labels);

/// The rim of the lens at the eye.
void drawLens(Sketch&, const DepthView&, const Lens&, const RayStyle&);

/// How many rays of each kind are shown, each with its line; `corner` is the lower left one.
void drawLegend(Sketch&, const std::vector<Arrow>&, const RayStyle&, const Vec2& corner,
                std::span<const std::string_view> names = kRayKindNames);

/// The directions at a hit, unit, away from the surface but t.
struct HitVectors {
    Vec3 at{0}, n{0}, v{0};
    std::optional<Vec3> l, r, t; // to a lamp; mirrored l, or v where there is no l; of the refracted ray
};

/// The vectors where the selected ray ends, or where the selected shadow ray starts; nothing if it hits
/// nothing.
std::optional<HitVectors> vectorsAt(const SampleRecord&, int selectedRay);

/// The vectors with their angles to the normal in degrees.
void drawVectors(Sketch&, const Projection&, const HitVectors&, const RayStyle&);

}
