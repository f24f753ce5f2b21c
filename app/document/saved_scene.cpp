#include "app/document/saved_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace eyeray {

Scene savedScene(const Document& now) {
    Scene scene = *now.scene;
    const auto original = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                       [&](const Camera& camera) { return camera.name == now.camera.name; });
    if (original != scene.cameras.end()) scene.cameras.erase(original);
    scene.cameras.insert(scene.cameras.begin(), now.camera);
    Document bare;
    bare.scene = now.scene;
    bare.camera = now.camera;
    bare.aspect = now.camera.aspect;
    bare.render.stop = now.render.stop;
    bare.threads = now.threads;
    scene.settings.clear();
    for (const Command& command : commandsBetween(bare, now)) scene.settings.push_back(command.text());
    // unless its file states an exposure, a scene is metered anew
    if (now.render.display.exposure == bare.render.display.exposure)
        scene.settings.push_back(fmt::format("set exposure={}", toText(now.render.display.exposure)));
    scene.statesExposure = true;
    return scene;
}

}
