#pragma once
// What is being looked at: a scene, how it is seen and how it is rendered. A value: edits make a new one.

#include <memory>
#include <optional>

#include "app/document/command.h"
#include "core/render/render_settings.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/scene/world.h"

namespace eyeray {

struct PixelPosition {
    int x = 0, y = 0;
    friend bool operator==(const PixelPosition&, const PixelPosition&) = default;
};

struct Document {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    RenderSettings render; // its width and height are set where the picture is shown
    BuildSettings build;
    int threads = 0;   // that trace; 0: one per core
    double aspect = 0; // width / height of the picture; 0: free, as large as its place
    int selectedObject = -1;
    std::optional<PixelPosition> pixel; // picked
};

/// A document that shows the scene as it asks to be shown. Throws InputError if one of the scene's own
/// settings is wrong.
Document makeDocument(std::shared_ptr<const Scene>);

/// The document after a command; see documentCommands(). Throws InputError for a command or argument it does
/// not know.
Document apply(const Document&, const Command&);

/// The commands that bring `from` to `to`, for the same scene file: apply(from, each) gives a document that
/// renders the same picture. Selection and picked pixel are left out.
std::vector<Command> commandsBetween(const Document& from, const Document& to);

}
