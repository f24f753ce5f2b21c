#pragma once
// Layers of a picture: what its samples have on record, one quantity at a time.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"
#include "core/base/ray_kind.h"
#include "core/scene/scene.h"
#include "core/transport/recorder.h"

namespace eyeray {

/// What a layer shows of a pixel, as mean over its samples unless it says otherwise.
enum class Quantity : std::uint8_t {
    Picture,   // radiance: the colour itself
    Normal,    // unit, towards the eye, along the scene's axes; over the samples that hit something
    Depth,     // metres from the eye along the eye ray; over the samples that hit something
    Albedo,    // kd where the eye ray ends; black where it hits nothing
    Object,    // id in Scene::objects that the first sample hits, kLampSurface or kNoObject
    Kind,      // radiance that rays of one kind bring; index: RayKind
    Lamp,      // radiance that comes straight from one lamp; index: id in Scene::lights
    Rest,      // radiance that no lamp term brings: ambient light, emission, background
    Recursion, // depth of the deepest ray
    Rays,      // rays traced
    Visits,    // nodes of the index that its rays go into
    Tests,     // triangles and shapes that its rays are tested against
    Cost,      // microseconds that the tracer takes, nothing on record
    Samples,   // how many there are
    Error      // standard error of the luminance; 0 for a single sample
};

inline constexpr double kNoObject = -1, kLampSurface = -2;

struct Layer {
    Quantity quantity = Quantity::Picture;
    int index = 0;    // of a Kind or a Lamp
    std::string name; // as in `layer name=…` and --layer; of a lamp "lamp." and its name

    friend bool operator==(const Layer&, const Layer&) = default;
};

/// Every layer that a picture of this scene has, the picture itself first. No two have the same name.
std::vector<Layer> layersOf(const Scene&);

/// The layer of this name; a lamp may also be named by its number, as in lamp.0. Throws InputError that lists
/// the names.
Layer layerNamed(std::string_view name, const Scene&);

/// True for layers of radiance, which the display transform makes visible.
bool isRadiance(Quantity);
/// True for layers of three numbers a pixel, false for those of one.
bool isVector(Quantity);
/// True for layers of the work that rays make for the index.
bool isOfIndex(Quantity);
/// True for layers that eye rays alone decide.
bool isOfFirstHit(Quantity);

/// What one sample adds to a layer: three numbers, or one number three times. Nothing where it has none: a
/// normal, depth or object where the eye ray hits nothing. `radiance` is the sample's value in the picture.
///
/// A ray brings weight · transmitted · (emission + ambient + background) under its own kind, and its lamp
/// terms count as brought by shadow rays, also with shadow rays switched off. So the layers of the kinds add
/// up to the colour, and so do those of the lamps and the rest. To the Error a sample adds its luminance, to
/// the Samples 1. The Cost and the work for the index, Visits and Tests, are not on record.
std::optional<DVec3> layerValue(const Layer&, const SampleRecord&, const Color& radiance);

}
