#include "core/study/photon_lamps.h"

#include <algorithm>

#include "core/transport/lights.h"

namespace eyeray {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

using Shape = PhotonLamps::Shape;

struct Place {
    DVec3 origin, direction;
};

DVec3 around(const DVec3& axis, double cosine, double turn) {
    const DVec3 other = std::fabs(axis.x) > 0.7 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
    const DVec3 tangent = glm::normalize(glm::cross(other, axis)), bitangent = glm::cross(axis, tangent);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), angle = 2 * kPiD * turn;
    return glm::normalize(sine * (std::cos(angle) * tangent + std::sin(angle) * bitangent) + cosine * axis);
}

DVec3 anywhere(double u, double v) { return around(DVec3(0, 0, 1), 1 - 2 * u, v); }
DVec3 byCosine(const DVec3& normal, double u, double v) { return around(normal, std::sqrt(1 - u), v); }

// Shares of a spot's power between its cones, where intensity rises by the square of the cosine, and within.
double betweenCones(const PhotonLamps::Spot& s) { return (s.cosInner - s.cosOuter) / 3; }
double ofSpot(const PhotonLamps::Spot& s) { return betweenCones(s) + 1 - s.cosInner; }

double spotCosine(const PhotonLamps::Spot& s, double u) {
    const double part = u * ofSpot(s), between = betweenCones(s);
    if (part < between) return s.cosOuter + (s.cosInner - s.cosOuter) * std::cbrt(part / between);
    return std::min(1.0, s.cosInner + part - between);
}

Place placeOn(const Shape& shape, const PhotonNumbers& numbers) {
    const double a = numbers(1), b = numbers(2), c = numbers(3), d = numbers(4);
    return std::visit(
        Overloaded{[&](const PhotonLamps::Point& p) { return Place{p.position, anywhere(a, b)}; },
                   [&](const PhotonLamps::Spot& s) {
                       return Place{s.position, around(s.axis, spotCosine(s, a), b)};
                   },
                   [&](const PhotonLamps::Sun& s) {
                       const DVec3 across = around(s.direction, 0, b);
                       return Place{s.radius * (std::sqrt(a) * across - s.direction), s.direction};
                   },
                   [&](const PhotonLamps::Rectangle& r) {
                       return Place{r.center + (a - 0.5) * r.edgeX + (b - 0.5) * r.edgeY,
                                    byCosine(r.normal, c, d)};
                   },
                   [&](const PhotonLamps::Disc& s) {
                       const double radius = std::sqrt(a), turn = 2 * kPiD * b;
                       return Place{s.center + radius * (std::cos(turn) * s.axisX + std::sin(turn) * s.axisY),
                                    byCosine(s.normal, c, d)};
                   },
                   [&](const PhotonLamps::Ball& s) {
                       const DVec3 outward = anywhere(a, b);
                       return Place{s.center + s.radius * outward, byCosine(outward, c, d)};
                   }},
        shape);
}

/// Watts of a lamp from its emission: radiant intensity, or irradiance of a sun.
double wattsOf(const Shape& shape) {
    return std::visit(Overloaded{[](const PhotonLamps::Point&) { return 4 * kPiD; },
                                 [](const PhotonLamps::Spot& s) { return 2 * kPiD * ofSpot(s); },
                                 [](const PhotonLamps::Sun& s) { return kPiD * s.radius * s.radius; },
                                 [](const PhotonLamps::Rectangle&) { return kPiD; },
                                 [](const PhotonLamps::Disc&) { return kPiD; },
                                 [](const PhotonLamps::Ball&) { return 4 * kPiD; }},
                      shape);
}

DMat3 axesOf(const Light& light, const Camera& camera) {
    const DMat3 own(light.transform);
    if (!light.followsCamera) return own;
    const CameraAxes axes = axesOf(camera);
    return DMat3(axes.right, axes.up, axes.backward) * own;
}

Shape shapeOf(const WorldLight& light, const Light& scenes, const DMat3& axes, double sunRadius) {
    const DVec3 position(light.position), direction(light.direction);
    if (light.kind == WorldLight::Kind::Directional) return PhotonLamps::Sun{direction, sunRadius};
    if (const auto* const rectangle = std::get_if<RectangleLamp>(&scenes.shape))
        return PhotonLamps::Rectangle{position, rectangle->width * axes[0], rectangle->height * axes[1],
                                      direction};
    if (const auto* const disc = std::get_if<DiscLamp>(&scenes.shape))
        return PhotonLamps::Disc{position, disc->radius * axes[0], disc->radius * axes[1], direction};
    if (const auto* const sphere = std::get_if<SphereLamp>(&scenes.shape))
        return PhotonLamps::Ball{position, sphere->radius * std::cbrt(std::fabs(glm::determinant(axes)))};
    if (light.kind == WorldLight::Kind::Spot) {
        constexpr double kSharpest = 1e-4; // as in sampleLight
        return PhotonLamps::Spot{position, direction,
                                 std::max(light.cosInner, light.cosOuter + static_cast<float>(kSharpest)),
                                 light.cosOuter};
    }
    return PhotonLamps::Point{position};
}

}

PhotonLamps::PhotonLamps(const World& world, const Camera& camera) {
    const double toEye = glm::length(camera.eye - world.origin);
    const double sunRadius = std::max(toEye, static_cast<double>(world.radius)) * 1.01;
    double luminances = 0;
    for (const WorldLight& light : lightsFor(world, camera)) {
        const Light& scenes = world.scene->lights[static_cast<std::size_t>(light.sceneLight)];
        Lamp lamp{.shape = shapeOf(light, scenes, axesOf(scenes, camera), sunRadius),
                  .light = light.sceneLight,
                  .power = light.emission,
                  .before = luminances,
                  .reach = light.range};
        const bool sun = light.kind == WorldLight::Kind::Directional;
        if (!sun && !light.falloff) {
            const float toMiddle = glm::length(light.position);
            lamp.power *= toMiddle > 0 ? toMiddle * toMiddle : world.radius * world.radius;
            replaced_ = true;
        }
        lamp.power *= static_cast<float>(wattsOf(lamp.shape));
        const double bright = luminance(lamp.power);
        if (!(bright > 0)) continue;
        luminances += bright;
        power_ += lamp.power;
        lamps_.push_back(lamp);
    }
    for (Lamp& lamp : lamps_) {
        lamp.power *= static_cast<float>(luminances / luminance(lamp.power));
        lamp.before /= luminances;
    }
}

EmittedPhoton PhotonLamps::emit(const PhotonNumbers& numbers) const {
    const auto next = std::partition_point(lamps_.begin() + 1, lamps_.end(),
                                           [u = numbers(0)](const Lamp& lamp) { return lamp.before <= u; });
    const Lamp& lamp = *(next - 1);
    const Place place = placeOn(lamp.shape, numbers);
    return {.light = lamp.light,
            .origin = Vec3(place.origin),
            .direction = Vec3(place.direction),
            .power = lamp.power,
            .reach = lamp.reach};
}

}
