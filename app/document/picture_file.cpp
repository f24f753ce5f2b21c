#include "app/document/picture_file.h"

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneKey = "eyeray.scene";
constexpr const char* kHashKey = "eyeray.sha256";
constexpr const char* kCommandsKey = "eyeray.commands";
constexpr std::size_t kMostBytes = 512U << 20U;

}

Metadata toMetadata(const PictureState& state, const fs::path& folder) {
    std::string scene = state.scene;
    if (scene.find_first_of("/.") != std::string::npos) { // else the name of a built-in scene
        std::error_code error;
        const fs::path relative = fs::relative(scene, folder.empty() ? fs::path(".") : folder, error);
        scene = error || relative.empty() ? fs::path(scene).filename().string() : relative.string();
    }
    std::string commands;
    for (const std::string& command : state.commands) commands += command + "\n";
    return {{"Software", fmt::format("Eyeray {}", EYERAY_VERSION)},
            {kSceneKey, scene},
            {kHashKey, state.sha256},
            {kCommandsKey, commands}};
}

PictureState readPictureState(const fs::path& picture) {
    const auto text = readPngText(readFile(picture, kMostBytes), picture.string());
    if (text.count(kSceneKey) == 0 || text.count(kHashKey) == 0)
        throw InputError(picture.string(), "this picture does not say which scene it shows",
                         "open a PNG that Eyeray has written, or a .gltf or .glb scene");
    PictureState state{text.at(kSceneKey), text.at(kHashKey), {}};
    if (const auto commands = text.find(kCommandsKey); commands != text.end())
        for (const Command& command : parseCommands(commands->second, picture.string()))
            state.commands.push_back(command.text());
    return state;
}

void writePicture(const fs::path& path, const ColorImage& radiance, const DisplaySettings& settings,
                  const PictureState& state) {
    const ImageFormat format = formatOf(path);
    const Metadata metadata = toMetadata(state, path.parent_path());
    writeFileAtomically(path, holdsRadiance(format)
                                  ? encodeRadiance(radiance, format, metadata)
                                  : encodeDisplayed(display(radiance, settings), format, metadata));
}

fs::path freeName(const fs::path& folder, const std::string& stem) {
    std::error_code error;
    for (int number = 1;; ++number) {
        const fs::path name = folder / fmt::format("{}-{:03}.png", stem, number);
        if (!fs::exists(name, error)) return name;
    }
}

}
