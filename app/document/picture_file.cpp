#include "app/document/picture_file.h"

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "core/study/layer_picture.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneKey = "eyeray.scene";
constexpr const char* kHashKey = "eyeray.sha256";
constexpr const char* kCommandsKey = "eyeray.commands";
constexpr const char* kRangeKey = "eyeray.range";
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

void checkLayerFile(const fs::path& path, const Layer& layer) {
    const bool signedValues = layer.quantity == Quantity::Normal || layer.quantity == Quantity::Object;
    if (signedValues && formatOf(path) == ImageFormat::Hdr)
        throw InputError(
            path.string(),
            fmt::format("an .hdr file cannot hold the negative values of the layer {}", layer.name),
            "end the name in .exr, .pfm or .png");
}

void writeLayer(const fs::path& path, const LayerImage& layer, const DisplaySettings& settings,
                const PictureState& state) {
    checkLayerFile(path, layer.layer);
    const ImageFormat format = formatOf(path);
    const LayerRange range = hasRange(layer.layer.quantity) ? rangeOf(layer) : LayerRange{};
    Metadata metadata = toMetadata(state, path.parent_path());
    if (hasRange(layer.layer.quantity)) metadata.emplace_back(kRangeKey, rangeText(layer, range));
    writeFileAtomically(path, holdsRadiance(format)
                                  ? encodeRadiance(layer.values, format, metadata)
                                  : encodeDisplayed(displayLayer(layer, range, settings), format, metadata));
}

void writeLayers(const fs::path& path, const std::vector<LayerImage>& layers, const PictureState& state) {
    if (formatOf(path) != ImageFormat::Exr)
        throw InputError(path.string(), "only an .exr file can hold all layers",
                         "end the name in .exr, or ask for one layer");
    std::vector<ImageChannel> channels;
    for (const LayerImage& layer : layers)
        for (ImageChannel& channel : channelsOf(layer)) channels.push_back(std::move(channel));
    writeFileAtomically(path, encodeChannels(channels, toMetadata(state, path.parent_path())));
}

fs::path freeName(const fs::path& folder, const std::string& stem, const std::string& ending) {
    std::error_code error;
    for (int number = 1;; ++number) {
        const fs::path name = folder / fmt::format("{}-{:03}{}", stem, number, ending);
        if (!fs::exists(name, error)) return name;
    }
}

}
