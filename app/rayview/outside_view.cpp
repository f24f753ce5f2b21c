#include "app/rayview/outside_view.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr double kFov = radians(36);
constexpr double kBeyond = 0.3; // seen behind the picture's target, in its distances from the eye
constexpr double kMargin = 0.76, kFrameMargin = 0.72; // radius of what is seen, likewise

/// Direction from what is looked at to the stand, in axes of the picture's camera.
DVec3 directionOf(OutsideStand stand) {
    switch (stand) {
    case OutsideStand::Top:
        return {0, 1, 0};
    case OutsideStand::Side:
        return {1, 0, 0};
    case OutsideStand::Front:
        return {0.12, 0.12, -1};
    case OutsideStand::Frame:
    case OutsideStand::Follow:
        break;
    }
    return {0.86, 0.42, 0.34};
}

}

void OutsideView::update(const Camera& picture, double aspect) {
    if (placed_ && stand_ != OutsideStand::Follow) return;
    placed_ = true;
    const CameraAxes axes = axesOf(picture);
    constexpr double kLeast = 1e-6; // metres: an eye may stand on its target
    const double distance = std::max(picture.distance(), kLeast);
    camera_ = {};
    camera_.verticalFov = kFov;
    if (stand_ == OutsideStand::Follow) {
        camera_.eye = picture.eye + distance * (0.7 * axes.backward + 0.45 * axes.right + 0.5 * axes.up);
        camera_.target = 0.5 * (picture.eye + picture.target);
        return;
    }
    // upright axes: people keep their heads up when the picture's camera tilts
    const DVec3 level = safeNormalize(DVec3(axes.backward.x, 0, axes.backward.z));
    const DVec3 backward = level == DVec3(0) ? safeNormalize(-axes.up) : level;
    const DVec3 right = glm::cross(DVec3(0, 1, 0), backward);
    const DVec3 direction = directionOf(stand_);
    const DVec3 towards =
        glm::normalize(direction.x * right + DVec3(0, direction.y, 0) + direction.z * backward);
    camera_.target = 0.5 * (picture.eye + picture.target) - 0.5 * kBeyond * distance * axes.backward;
    const double narrow = std::tan(kFov / 2) * std::min(1.0, aspect);
    const double radius = (stand_ == OutsideStand::Frame ? kFrameMargin : kMargin) * distance;
    camera_.eye = camera_.target + radius / narrow * towards;
    if (stand_ == OutsideStand::Top) camera_.up = -backward;
}

}
