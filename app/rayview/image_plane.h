#pragma once
// The lectures' image plane in space: corners (±a·tan(fov/2), ±tan(fov/2), −1) before the eye.

#include <array>
#include <string>

#include "app/gl/program.h"
#include "app/gl/texture.h"
#include "app/rayview/projection.h"

namespace eyeray {

/// Where the plane is drawn. Its distance is 1 m, or `scale` times that where 1 m would be too near to the
/// eye or behind the scene.
struct ImagePlane {
    DVec3 eye{0};                 // relative to the World's origin, as the corners
    std::array<DVec3, 4> corners; // top left, top right, bottom right, bottom left
    DVec2 half{1};                // (a·tan(fov/2), tan(fov/2))
    double scale = 1;

    /// A point of the picture, in pixels of width × height from its top left corner.
    DVec3 point(const DVec2& pixel, int width, int height) const;

    /// "(−0.77, 0.58, −1)" for a corner.
    std::string cornerText(int corner) const;
};

/// The plane of a camera whose picture is width / height = `aspect`; `nearest` is the distance of the nearest
/// thing that is to lie behind it.
ImagePlane imagePlaneOf(const Camera&, const DVec3& origin, double aspect, double nearest);

/// Every how many pixels the grid has a line: 1, or a power of 2 that keeps lines this many pixels of the
/// screen apart.
int gridStep(int pixels, double lengthOnScreen, double leastApart);

/// Draws pictures on quadrilaterals in space.
class PictureQuad {
public:
    explicit PictureQuad(const Gl&);

    /// Draws the picture between the corners into the bound target, hidden by what is nearer, with a grid of
    /// `cells` in x and y.
    void draw(const GlTexture&, const ImagePlane&, const Projection&, const DVec2& cells) const;

private:
    const Gl& gl_;
    Program program_;
    Handle noVertices_;
};

}
