#pragma once
// From the world to a picture that OpenGL draws, and back to distances.

#include <optional>

#include "core/scene/camera.h"

namespace eyeray {

/// Where a point stands in a picture.
struct ScreenPoint {
    Vec2 at{0};      // pixels from the top left corner
    float depth = 0; // metres from the eye along the view
};

/// A line from one point of a picture to another.
struct ScreenLine {
    ScreenPoint from, to;

    /// The point at a share of the line's length in the picture, with the depth of the line in space there:
    /// 1/depth is linear in a picture.
    ScreenPoint at(float share) const;
};

/// The map of a pinhole camera from points relative to `origin` to a picture of width × height pixels, whose
/// vertical field of view is the camera's. What is nearer than `nearest` metres along the view, or farther
/// than `farthest`, is cut off.
class Projection {
public:
    Projection(const Camera&, const DVec3& origin, int width, int height, double nearest, double farthest);

    /// From points to OpenGL's clip space.
    const DMat4& clip() const { return clip_; }

    /// Where a point stands; nothing for one before the near plane.
    std::optional<ScreenPoint> point(const DVec3&) const;

    /// The part of a line behind the near plane; nothing if there is none.
    std::optional<ScreenLine> line(const DVec3& from, const DVec3& to) const;

    /// Metres along the view of a value of the depth buffer, 0 to 1.
    float distance(float depth) const;

    const DVec3& eye() const { return eye_; } // relative to the origin
    const CameraAxes& axes() const { return axes_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Metres that one pixel stands for at this depth.
    double metresPerPixel(double depth) const { return 2 * depth * halfHeight_ / height_; }

private:
    DVec3 inEye(const DVec3&) const;
    ScreenPoint onScreen(const DVec3& inEye) const;

    CameraAxes axes_;
    DVec3 eye_;
    int width_, height_;
    double halfHeight_, nearest_, farthest_;
    DMat4 clip_;
};

}
