#include <algorithm>
#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr double kFar = 1e9;   // metres
constexpr double kTurn = 3600; // degrees

void checked(const Document& document, const Command& command) {
    const Camera& camera = document.camera;
    if (!(camera.distance() > 0) || !isFinite(camera.eye) || !isFinite(camera.target) ||
        glm::length(camera.eye) > kFar || glm::length(camera.target) > kFar)
        throw InputError(command.text(), "the eye would stand in its target or too far away",
                         "move them apart, within 1e9 m");
}

void camera(Document& document, const Command& command) {
    command.allowOnly({"camera", "eye", "target", "up", "fov"});
    Camera& camera = document.camera;
    if (command.find("camera")) {
        const auto& cameras = document.scene->cameras;
        camera = cameras[static_cast<std::size_t>(itemIndex(command, "camera", cameras))];
        if (camera.aspect > 0) document.aspect = camera.aspect;
    }
    camera.eye = command.triple("eye").value_or(camera.eye);
    camera.target = command.triple("target").value_or(camera.target);
    camera.up = command.triple("up").value_or(camera.up);
    if (const auto fov = command.number("fov", 1, 170)) camera.verticalFov = radians(*fov);
    checked(document, command);
}

void orbit(Document& document, const Command& command) {
    command.allowOnly({"yaw", "pitch"});
    document.camera = orbited(document.camera, radians(command.number("yaw", -kTurn, kTurn).value_or(0)),
                              radians(command.number("pitch", -kTurn, kTurn).value_or(0)));
}

void pan(Document& document, const Command& command) {
    command.allowOnly({"right", "up", "forward"});
    document.camera = moved(document.camera, {command.number("right", -kFar, kFar).value_or(0),
                                              command.number("up", -kFar, kFar).value_or(0),
                                              command.number("forward", -kFar, kFar).value_or(0)});
    checked(document, command);
}

void dolly(Document& document, const Command& command) {
    command.allowOnly({"factor"});
    command.required("factor");
    const double factor = *command.number("factor", 0.001, 1000);
    const double shortest = 1e-4 * boundsOf(*document.scene).radius();
    if (document.camera.distance() * factor < shortest) return;
    document.camera = dollied(document.camera, factor);
    checked(document, command);
}

void turn(Document& document, const Command& command) {
    command.allowOnly({"yaw", "pitch"});
    document.camera = turned(document.camera, radians(command.number("yaw", -kTurn, kTurn).value_or(0)),
                             radians(command.number("pitch", -kTurn, kTurn).value_or(0)));
}

/// Keeps the direction of view and moves the eye until a ball around the scene or the selected object fills
/// the picture.
void frame(Document& document, const Command& command) {
    command.allowOnly({"object"});
    Scene framed = *document.scene;
    if (command.find("object")) {
        const int object = itemIndex(command, "object", framed.objects);
        framed.objects = {framed.objects[static_cast<std::size_t>(object)]};
    }
    const SceneBounds bounds = boundsOf(framed);
    if (bounds.empty()) return;
    Camera& camera = document.camera;
    const DVec3 backward = axesOf(camera).backward;
    camera.target = bounds.center();
    camera.eye =
        camera.target + backward * (std::max(bounds.radius(), 1e-6) / std::sin(camera.verticalFov / 2));
}

constexpr std::array kCommands = {
    DocumentCommand{"camera", "camera=NAME eye=x,y,z target=x,y,z up=x,y,z fov=DEG", "Places the camera.",
                    camera},
    DocumentCommand{"orbit", "yaw=DEG pitch=DEG", "Turns the eye about its target.", orbit},
    DocumentCommand{"pan", "right=M up=M forward=M", "Moves eye and target.", pan},
    DocumentCommand{"dolly", "factor=F", "Multiplies the distance from eye to target.", dolly},
    DocumentCommand{"turn", "yaw=DEG pitch=DEG", "Turns the view about the eye.", turn},
    DocumentCommand{"frame", "object=NAME", "Frames the scene, or one object.", frame},
};

}

std::span<const DocumentCommand> cameraCommands() { return kCommands; }

}
