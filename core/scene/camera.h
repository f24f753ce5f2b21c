#pragma once
// Where the picture is seen from.

#include <array>
#include <string>

#include "core/base/math.h"

namespace eyeray {

/// Camera that looks from eye to target, through a pinhole or a thin lens. `up` need not be orthogonal to the
/// view.
struct Camera {
    std::string name;
    DVec3 eye{0, 0, 0}, target{0, 0, -1}, up{0, 1, 0}; // metres, scene coordinates
    double verticalFov = radians(45);                  // full angle, radians
    double aspect = 0;                                 // width / height that its file asks for; 0: any
    double lensRadius = 0;                             // metres; 0: a pinhole. Of distributed and path
    double focusDistance = 0; // metres along the view to what is sharp; 0: to the target

    double distance() const { return glm::length(target - eye); }
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Right-handed camera axes: right, up and backward (the camera looks along −backward); always orthonormal,
/// also when up is parallel to the view or zero.
struct CameraAxes {
    DVec3 right, up, backward;
};
CameraAxes axesOf(const Camera&);

/// Half extents (a·tan(fov/2), tan(fov/2)) of the image plane at distance 1: its corners are (±x, ±y, −1).
DVec2 imagePlaneHalfExtents(double verticalFov, double aspect);

/// Orbits the eye around the target: yaw about the world's y axis, pitch clamped short of the poles. Radians.
/// Only angles change, so a million calls do not drift.
Camera orbited(const Camera&, double yaw, double pitch);

/// Moves eye and target by right/up/forward, in metres.
Camera moved(const Camera&, const DVec3& rightUpForward);

/// Eye moved along the view so that its distance to the target is multiplied by `factor`.
Camera dollied(const Camera&, double factor);

/// Turns the view about the eye (fly mode). Radians.
Camera turned(const Camera&, double yaw, double pitch);

}
