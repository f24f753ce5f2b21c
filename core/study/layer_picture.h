#pragma once
// Layers as pictures on a screen and as channels of a file.

#include <string>

#include "core/image/encode.h"
#include "core/render/display.h"
#include "core/study/layer_film.h"

namespace eyeray {

/// Values that the colours of a layer stand for, from the first colour to the last.
struct LayerRange {
    double lowest = 0, highest = 1;
    bool cut = false; // a few pixels lie above it and have the last colour
};

/// True for layers that colours of numbers show: depth, rays, recursion, cost, error and samples.
bool hasRange(Quantity);

/// Of which equal steps of the colour are equal ratios: depth, for near the horizon it has no end, and
/// samples.
bool isLogarithmic(Quantity);

/// Range of a layer that hasRange: from 0, where it is logarithmic from the lowest, to what all pixels but
/// one in 200 stay below; of recursion and samples to the highest.
LayerRange rangeOf(const LayerImage&);

/// Where in the range a value stands, from 0 to 1 in it.
double placeIn(const LayerRange&, Quantity, double value);
/// The value at a place, the inverse.
double valueAt(const LayerRange&, Quantity, double place);

/// Colour of a value of a layer that hasRange.
Rgba8 rangeColor(Quantity, double value, const LayerRange&);

/// What a screen shows of a layer: radiance through the display transform, albedo as it is, a normal as
/// 0.5 + 0.5 n, objects in colours of their own, numbers in colours of their range; black where there is no
/// value.
ByteImage displayLayer(const LayerImage&, const LayerRange&, const DisplaySettings&);

/// What a layer shows, in a line.
std::string aboutLayer(const Layer&);

/// A value with the unit of its layer: "3.14 m".
std::string valueText(Quantity, double value);

/// In a line, what the colours of a layer in a picture stand for; empty where they need no word.
std::string rangeText(const LayerImage&, const LayerRange&);

/// The layer's channels by OpenEXR's convention: R G B of the picture itself, normal.X, depth.Z, rays.Y and
/// lamp.key.R of others. They refer to the image's pixels.
std::vector<ImageChannel> channelsOf(const LayerImage&);

}
