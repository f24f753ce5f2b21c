#pragma once
// Pictures that remember how they were made.

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/image/encode.h"
#include "core/image/pixels.h"
#include "core/study/layer_film.h"

namespace eyeray {

/// What a picture says about its making: enough to return to exactly that state.
struct PictureState {
    std::string scene; // a built-in scene's name, or a path; in a picture's text relative to its folder
    std::string sha256;
    std::vector<std::string> commands; // from the scene's defaults
};

/// As text for a picture's metadata. The scene's path is made relative to `folder`, where the picture stands.
Metadata toMetadata(const PictureState&, const std::filesystem::path& folder);

/// Throws InputError if the file is no picture of Eyeray.
PictureState readPictureState(const std::filesystem::path& picture);

/// Writes a picture by the ending of its name, with its state where the format can hold it (PNG, EXR):
/// radiance to EXR, HDR and PFM, displayed bytes to PNG and PPM. Whole or not at all. Throws InputError for
/// another ending, Failure.
void writePicture(const std::filesystem::path&, const ColorImage& radiance, const DisplaySettings&,
                  const PictureState&);

/// Says before the work what would go wrong after it: throws InputError if a file of this name cannot hold
/// the layer's values.
void checkLayerFile(const std::filesystem::path&, const Layer&);

/// Writes one layer by the ending of its name: its values to EXR and PFM (and HDR, where none is negative) as
/// red, green and blue, what a screen shows of it to PNG and PPM. A PNG and an EXR say what range its colours
/// stand for. Throws as writePicture does.
void writeLayer(const std::filesystem::path&, const LayerImage&, const DisplaySettings&, const PictureState&);

/// Writes layers of one picture into one EXR, each in channels of its name. Throws InputError for another
/// ending.
void writeLayers(const std::filesystem::path&, const std::vector<LayerImage>&, const PictureState&);

/// First name of the form `folder/stem-NNN.png` that is free; or with another ending.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& ending = ".png");

}
