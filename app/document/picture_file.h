#pragma once
// Pictures that remember how they were made.

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/image/encode.h"
#include "core/image/pixels.h"

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

/// First name of the form `folder/stem-NNN.png` that is free.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem);

}
