#pragma once
// What `eyeray render` of a picture and of its layers share.

#include <memory>
#include <optional>
#include <vector>

#include "app/cli/options.h"
#include "app/document/picture_file.h"
#include "app/document/scene_files.h"
#include "core/render/render_session.h"

namespace eyeray {

/// What is to be rendered, and with what.
struct RenderJob {
    OpenedScene opened;
    Document document;
    RenderSettings settings;
    std::shared_ptr<const World> world;
};

// The progress line; endProgress clears it.
bool showsProgress(const RenderOptions&);
void showProgress(const RenderStatus&, const StopSettings&);
void endProgress();

/// What the job's pictures say of their making.
PictureState stateOf(const RenderJob&);

/// Takes the exposure from the picture if nothing has stated one.
void meterExposure(RenderJob&, const ColorImage& picture);

/// The layers that the options ask for; none if it is the picture itself. Throws InputError for what layers
/// cannot do.
std::vector<Layer> layersFor(const RenderJob&, const RenderOptions&);

/// Whether it is the samples of the picture itself that are asked for, to be counted as it is rendered.
bool isSampleMap(const std::vector<Layer>&);

/// Writes a layer, and says what the colours of a picture of numbers stand for.
void writeOneLayer(const RenderJob&, const RenderOptions&, const LayerImage&);

/// Renders layers and writes them. Nothing, and no file, if it is interrupted before the first sample is
/// whole.
std::optional<RenderStatus> renderLayers(RenderJob&, const RenderOptions&, const std::vector<Layer>&);

}
