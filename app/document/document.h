#pragma once
// What is being looked at: a scene, how it is seen and how it is rendered. A value: edits make a new one.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/document/command.h"
#include "core/render/render_settings.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/scene/world.h"
#include "core/study/lab.h"
#include "core/study/layer.h"

namespace eyeray {

struct PixelPosition {
    int x = 0, y = 0;
    friend bool operator==(const PixelPosition&, const PixelPosition&) = default;
};

/// What both sides of a comparison are given as much of.
enum class EqualShare : std::uint8_t { Samples, Seconds };
inline constexpr std::array<std::string_view, 2> kEqualShareNames = {"samples", "seconds"};

/// The picture beside the same one under other settings, or beside what OpenGL draws.
struct Comparison {
    static constexpr const char* kRasterised = "rasterised";

    bool on = false;
    std::string with = "max-depth=1"; // settings of the other side, as `set` takes them; or kRasterised
    EqualShare equal = EqualShare::Samples;
    double split = 0.5;      // share of the width, from the left, that shows the other side
    bool difference = false; // in place of both sides: gain · |this − other|
    double gain = 1;
    bool marks = false; // pixels of the other side that are wrong beside this one

    bool isRasterised() const { return with == kRasterised; }
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

struct Document {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    RenderSettings render; // its width and height are set where the picture is shown
    AccelKind accel = AccelKind::Auto;
    int threads = 0;             // that trace; 0: one per core
    double aspect = 0;           // width / height of the picture; 0: free, as large as its place
    std::string layer = "color"; // shown, by its name
    Comparison comparison;
    int selectedObject = -1;
    std::optional<PixelPosition> pixel; // picked
    const LabDemo* lab = nullptr;       // the demonstration that the scene is of, if of one
    double labValue = 0;                // of its slider
};

/// A document that shows the scene as it asks to be shown. Throws InputError if one of the scene's own
/// settings is wrong.
Document makeDocument(std::shared_ptr<const Scene>);

/// A demonstration of the failure lab: its scene, with the naive side on the left and wrong pixels marked.
Document labDocument(const LabDemo&, double value);

/// What a World for the document's picture is built with.
BuildSettings buildSettings(const Document&);

/// The document as its scene alone asks for it.
Document originalOf(const Document&);

/// The document after a command; see documentCommands(). Throws InputError for a command or argument it does
/// not know.
Document apply(const Document&, const Command&);

/// The layer that the document shows; the picture itself if the scene has lost the lamp it is of.
Layer shownLayer(const Document&);

/// The document under the settings that it is compared with; the same if that is kRasterised. Throws
/// InputError if they are none, or such as need another index or picture size.
Document otherSide(const Document&);

/// The commands that bring `from` to `to`, for the same scene file: apply(from, each) gives a document that
/// renders the same picture. Selection, picked pixel and comparison are left out.
std::vector<Command> commandsBetween(const Document& from, const Document& to);

}
