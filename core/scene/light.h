#pragma once
// Lamps.

#include <string>
#include <variant>

#include "core/base/math.h"

namespace eyeray {

struct PointLamp {};
struct DirectionalLamp {};
struct SpotLamp {
    double innerCone = 0, outerCone = kPiD / 4; // half angles, radians
};
struct RectangleLamp {
    double width = 1, height = 1; // metres, along local x and y; shines to local −z
};
struct DiscLamp {
    double radius = 0.5; // metres, in local x and y; shines to local −z
};
struct SphereLamp {
    double radius = 0.1; // metres
};
using LampShape = std::variant<PointLamp, DirectionalLamp, SpotLamp, RectangleLamp, DiscLamp, SphereLamp>;

/// Whether it has a surface: a rectangle, a disc or a sphere.
inline bool hasSurface(const LampShape& shape) {
    return std::holds_alternative<RectangleLamp>(shape) || std::holds_alternative<DiscLamp>(shape) ||
           std::holds_alternative<SphereLamp>(shape);
}

/// A lamp shines along its local −z. color·intensity is radiant intensity (W/sr) for point and spot,
/// irradiance at normal incidence (W/m²) for directional, radiance (W·sr⁻¹·m⁻²) for those with a surface.
/// Without falloff it is a taught lamp, whatever its shape: normal irradiance π·color·intensity at any
/// distance.
struct Light {
    std::string name;
    LampShape shape;
    Color color{1};
    double intensity = 1;
    bool falloff = true;
    bool enabled = true;
    bool followsCamera = false;                             // its transform is then relative to the camera
    double range = std::numeric_limits<double>::infinity(); // metres; no light beyond
    DMat4 transform{1};
};

}
