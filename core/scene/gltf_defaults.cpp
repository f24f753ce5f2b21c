// What the file says of its scene as a whole, and what is added where it says nothing.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/errors.h"
#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

constexpr int kExtrasVersion = 1;
constexpr const char* kHeadlight = "headlight (added)";
constexpr const char* kAddedCamera = "camera (added)";

bool emits(const Material& material) {
    if (const auto* const taught = std::get_if<TaughtMaterial>(&material.model))
        return !isBlack(taught->emission);
    const auto& gltf = std::get<GltfMaterial>(material.model);
    return gltf.emissiveStrength > 0 && !isBlack(gltf.emissive);
}

bool hasEmission(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const Object& object) { return emits(scene.materials[object.material]); });
}

/// Shines from behind the camera's upper left shoulder; white paper facing it is about white.
Light headlight() {
    const DVec3 towardsLamp(-0.4, 0.5, 1);
    Light light;
    light.name = kHeadlight;
    light.shape = DirectionalLamp{};
    light.intensity = 0.8 * kPiD;
    light.followsCamera = true;
    light.transform = glm::inverse(glm::lookAt(towardsLamp, DVec3(0), DVec3(0, 1, 0)));
    light.transform[3] = DVec4(0, 0, 0, 1);
    return light;
}

/// A scene may bring up its state; what else commands can do, such as writing files, is not for it to ask.
bool isSetting(const std::string& line) {
    return line.starts_with("set ") &&
           std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < 0x20; });
}

constexpr Environment kPaleSky{{0.40F, 0.55F, 0.85F}, {0.80F, 0.85F, 0.90F}, {0.30F, 0.28F, 0.26F}};

}

bool importSceneExtras(GltfImport& context) {
    const tinygltf::Scene* const shown = shownScene(context.document);
    if (!shown) return false;
    Scene& scene = context.scene;
    GltfFields extras = eyerayExtras(shown->extras, context.document.where, context.notes);
    if (extras.whole("version", kExtrasVersion, 0, std::numeric_limits<int>::max()) > kExtrasVersion)
        throw InputError{context.document.where, "was written by a newer Eyeray", "update this one"};
    scene.whatToLookAt = printable(extras.text("lookAt", ""));
    scene.ambient = extras.color("ambient", scene.ambient);
    const bool litOnPurpose = extras.has("environment") || extras.has("ambient");
    GltfFields sky = extras.child("environment");
    scene.environment.zenith = sky.color("zenith", Color(0));
    scene.environment.horizon = sky.color("horizon", Color(0));
    scene.environment.nadir = sky.color("nadir", Color(0));
    for (const std::string& line : extras.texts("settings"))
        if (isSetting(line))
            scene.settings.push_back(line);
        else
            context.notes.ignored(extras.where() + ": only set commands may stand in settings");
    scene.statesExposure =
        std::any_of(scene.settings.begin(), scene.settings.end(),
                    [](const std::string& line) { return line.find("exposure=") != std::string::npos; });
    sky.reportUnread();
    extras.reportUnread();
    return litOnPurpose;
}

void completeScene(GltfImport& context, bool litOnPurpose) {
    Scene& scene = context.scene;
    if (scene.materials.empty()) context.defaultMaterial();
    if (!litOnPurpose && scene.lights.empty() && !hasEmission(scene)) {
        scene.lights.push_back(headlight());
        scene.environment = kPaleSky;
        context.notes.added(
            fmt::format("lamp \"{}\": the file has no light; it follows the camera", kHeadlight));
        context.notes.added("a pale sky as environment: the file has no light; set it to black to remove it");
    }
    if (scene.cameras.empty()) {
        scene.cameras.push_back(framingCamera(scene, kAddedCamera));
        context.notes.added(
            fmt::format("camera \"{}\" with a field of view of 45°: the file has none", kAddedCamera));
    }
}

}
