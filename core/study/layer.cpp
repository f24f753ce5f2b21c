#include "core/study/layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr std::string_view kLampPrefix = "lamp.";
constexpr std::size_t kLongestName = 100; // bytes; OpenEXR takes up to 255 for a channel

/// "lamp." and the lamp's name, or its number where it has none, a very long one, or shares it.
std::string lampLayerName(const Scene& scene, std::size_t lamp) {
    const std::string& name = scene.lights[lamp].name;
    const auto sharers = std::count_if(scene.lights.begin(), scene.lights.end(),
                                       [&](const Light& light) { return light.name == name; });
    const bool unfit = name.empty() || name.size() > kLongestName || sharers > 1;
    return fmt::format("{}{}", kLampPrefix, unfit ? fmt::format("{}", lamp) : name);
}

/// Radiance of a ray that finds it itself, as it reaches the pixel.
DVec3 ownRadiance(const RayRecord& ray) {
    const Color found = ray.end == RayEnd::Hit ? ray.hit.emission + ray.hit.ambient : ray.background;
    return DVec3(ray.weight) * DVec3(ray.transmitted) * DVec3(found);
}

DVec3 lampRadiance(const SampleRecord& record, const LampTerm& term) {
    const RayRecord& ray = record.rays[static_cast<std::size_t>(term.ray)];
    return DVec3(ray.weight) * DVec3(ray.transmitted) * DVec3(term.radiance);
}

template <class Wanted>
DVec3 ownSum(const SampleRecord& record, const Wanted& wanted) {
    DVec3 sum(0);
    for (const RayRecord& ray : record.rays)
        if (ray.kind != RayKind::Shadow && wanted(ray)) sum += ownRadiance(ray);
    return sum;
}

template <class Wanted>
DVec3 lampSum(const SampleRecord& record, const Wanted& wanted) {
    DVec3 sum(0);
    for (const LampTerm& term : record.lamps)
        if (wanted(term)) sum += lampRadiance(record, term);
    return sum;
}

/// A sample that is not finite counts as black in the picture, and so do its parts.
bool isLeftOut(const SampleRecord& record) {
    return record.rays.empty() || !isFinite(record.rays.front().radiance);
}

double deepest(const SampleRecord& record) {
    int depth = 0;
    for (const RayRecord& ray : record.rays) depth = std::max(depth, ray.depth);
    return depth;
}

std::optional<DVec3> atFirstHit(Quantity quantity, const RayRecord& eye) {
    if (eye.end != RayEnd::Hit) return std::nullopt;
    if (quantity == Quantity::Normal) return DVec3(eye.hit.normal);
    if (quantity == Quantity::Depth) return DVec3(eye.t);
    return DVec3(eye.hit.object >= 0 ? eye.hit.object : kLampSurface);
}

}

std::vector<Layer> layersOf(const Scene& scene) {
    std::vector<Layer> layers = {{Quantity::Picture, 0, "color"},       {Quantity::Normal, 0, "normal"},
                                 {Quantity::Depth, 0, "depth"},         {Quantity::Albedo, 0, "albedo"},
                                 {Quantity::Object, 0, "id"},           {Quantity::Rays, 0, "rays"},
                                 {Quantity::Recursion, 0, "recursion"}, {Quantity::Visits, 0, "visits"},
                                 {Quantity::Tests, 0, "tests"},         {Quantity::Cost, 0, "cost"},
                                 {Quantity::Error, 0, "error"},         {Quantity::Samples, 0, "samples"}};
    for (int kind = 0; kind < kRayKinds; ++kind)
        layers.push_back({Quantity::Kind, kind, std::string(name(static_cast<RayKind>(kind)))});
    for (std::size_t lamp = 0; lamp < scene.lights.size(); ++lamp)
        layers.push_back({Quantity::Lamp, static_cast<int>(lamp), lampLayerName(scene, lamp)});
    layers.push_back({Quantity::Rest, 0, "rest"});
    return layers;
}

Layer layerNamed(std::string_view name, const Scene& scene) {
    std::string known;
    for (const Layer& layer : layersOf(scene)) {
        const bool numbered =
            layer.quantity == Quantity::Lamp && name == fmt::format("{}{}", kLampPrefix, layer.index);
        if (layer.name == name || numbered) return layer;
        known += " " + layer.name;
    }
    throw InputError(fmt::format("layer {}", printable(name)), "there is no such layer",
                     "use one of" + printable(known, 2000));
}

bool isRadiance(Quantity quantity) {
    return quantity == Quantity::Picture || quantity == Quantity::Kind || quantity == Quantity::Lamp ||
           quantity == Quantity::Rest;
}

bool isVector(Quantity quantity) {
    return isRadiance(quantity) || quantity == Quantity::Normal || quantity == Quantity::Albedo;
}

bool isOfIndex(Quantity quantity) { return quantity == Quantity::Visits || quantity == Quantity::Tests; }

bool isOfFirstHit(Quantity quantity) {
    return quantity == Quantity::Normal || quantity == Quantity::Depth || quantity == Quantity::Albedo ||
           quantity == Quantity::Object;
}

std::optional<DVec3> layerValue(const Layer& layer, const SampleRecord& record, const Color& radiance) {
    if (layer.quantity == Quantity::Picture) return DVec3(radiance);
    ENSURE(!record.rays.empty());
    const bool leftOut = isLeftOut(record);
    switch (layer.quantity) {
    case Quantity::Normal:
    case Quantity::Depth:
    case Quantity::Object:
        return atFirstHit(layer.quantity, record.rays.front());
    case Quantity::Albedo:
        return DVec3(record.rays.front().hit.diffuseReflectance);
    case Quantity::Kind: {
        const auto kind = static_cast<RayKind>(layer.index);
        if (leftOut) return DVec3(0);
        if (kind == RayKind::Shadow) return lampSum(record, [](const LampTerm&) { return true; });
        return ownSum(record, [&](const RayRecord& ray) { return ray.kind == kind; });
    }
    case Quantity::Lamp:
        if (leftOut) return DVec3(0);
        return lampSum(record, [&](const LampTerm& term) { return term.light == layer.index; });
    case Quantity::Rest:
        if (leftOut) return DVec3(0);
        return ownSum(record, [](const RayRecord&) { return true; }) +
               lampSum(record, [](const LampTerm& term) { return term.light < 0; });
    case Quantity::Recursion:
        return DVec3(deepest(record));
    case Quantity::Rays:
        return DVec3(static_cast<double>(record.rays.size()));
    case Quantity::Samples:
        return DVec3(1);
    case Quantity::Error:
        return DVec3(luminance(DVec3(radiance)));
    case Quantity::Picture:
    case Quantity::Visits:
    case Quantity::Tests:
    case Quantity::Cost:
        break;
    }
    throw InternalError("layerValue: not of one sample's record");
}

}
