#include "core/scene/camera.h"

#include <algorithm>

#include "core/base/errors.h"

namespace eyeray {

namespace {

constexpr double kMaxPitch = kPiD / 2 - 1e-3; // short of the poles, where yaw would lose its meaning

/// The direction from target to eye as angles: yaw from +z towards +x, pitch upwards.
struct Bearing {
    double yaw, pitch;

    DVec3 direction() const {
        return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
    }
    Bearing turned(double byYaw, double byPitch) const {
        return {yaw + byYaw, std::clamp(pitch + byPitch, -kMaxPitch, kMaxPitch)};
    }
};

/// The camera's up, or another where that is along the view.
DVec3 upFor(const Camera& camera, const DVec3& backward) {
    constexpr double kParallel = 1e-6; // sine of the angle between up and view below which up says nothing
    for (const DVec3& up : {safeNormalize(camera.up), DVec3(0, 1, 0)})
        if (glm::length(glm::cross(up, backward)) >= kParallel) return up;
    return {0, 0, backward.y > 0 ? -1 : 1};
}

Bearing bearingOf(const Camera& camera) {
    const CameraAxes axes = axesOf(camera);
    const double horizontal = std::hypot(axes.backward.x, axes.backward.z);
    const double pitch = std::atan2(axes.backward.y, horizontal);
    // Near the poles the picture's right edge still tells where it faces.
    if (horizontal < 1e-6) return {std::atan2(-axes.right.z, axes.right.x), pitch};
    return {std::atan2(axes.backward.x, axes.backward.z), pitch};
}

}

CameraAxes axesOf(const Camera& camera) {
    DVec3 backward = safeNormalize(camera.eye - camera.target);
    if (backward == DVec3(0)) backward = DVec3(0, 0, 1);
    const DVec3 right = safeNormalize(glm::cross(upFor(camera, backward), backward));
    return {right, glm::cross(backward, right), backward};
}

DVec2 imagePlaneHalfExtents(double verticalFov, double aspect) {
    const double y = std::tan(verticalFov / 2);
    return {aspect * y, y};
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
    Camera result = camera;
    result.eye = camera.target + camera.distance() * bearingOf(camera).turned(yaw, pitch).direction();
    result.up = DVec3(0, 1, 0);
    return result;
}

Camera moved(const Camera& camera, const DVec3& rightUpForward) {
    const CameraAxes axes = axesOf(camera);
    const DVec3 step =
        rightUpForward.x * axes.right + rightUpForward.y * axes.up - rightUpForward.z * axes.backward;
    Camera result = camera;
    result.eye += step;
    result.target += step;
    return result;
}

Camera dollied(const Camera& camera, double factor) {
    ENSURE(factor > 0 && std::isfinite(factor));
    Camera result = camera;
    result.eye = camera.target + factor * (camera.eye - camera.target);
    return result;
}

Camera turned(const Camera& camera, double yaw, double pitch) {
    // Looking up takes the way back down.
    Camera result = camera;
    result.target = camera.eye - camera.distance() * bearingOf(camera).turned(yaw, -pitch).direction();
    result.up = DVec3(0, 1, 0);
    return result;
}

}
