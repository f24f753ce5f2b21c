#pragma once
// Where people stand who look at the scene from outside.

#include <array>
#include <string_view>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace eyeray {

/// From where the scene is seen: all of it, behind the eye wherever that goes, from above, from its right,
/// or towards the eye.
enum class OutsideStand : std::uint8_t { Frame, Follow, Top, Side, Front };
inline constexpr std::array<std::string_view, 5> kOutsideStandNames = {"frame", "follow", "top", "side",
                                                                       "front"};

/// A camera around the camera of the picture.
class OutsideView {
public:
    /// Goes to a stand; for Follow it stays there while the picture's camera moves.
    void go(OutsideStand stand) { stand_ = stand, placed_ = false; }

    /// Moves on from where it is, which ends a stand. Radians; metres; a factor of the distance to what is
    /// looked at.
    void orbit(double yaw, double pitch) { leave(orbited(camera_, yaw, pitch)); }
    void pan(double right, double up) { leave(moved(camera_, {right, up, 0})); }
    void dolly(double factor) { leave(dollied(camera_, factor)); }

    /// Takes its stand before the picture's camera, for a view of width / height = `aspect`.
    void update(const Camera& picture, double aspect);

    const Camera& camera() const { return camera_; }

private:
    void leave(const Camera& camera) { camera_ = camera, stand_ = OutsideStand::Frame, placed_ = true; }

    OutsideStand stand_ = OutsideStand::Frame;
    bool placed_ = false; // nothing is left to do but for Follow
    Camera camera_;
};

}
