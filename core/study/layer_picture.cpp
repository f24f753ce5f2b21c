#include "core/study/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/study/color_map.h"

namespace eyeray {
namespace {

constexpr std::size_t kAboveRange = 200; // one pixel in so many may lie above
constexpr float kLeast = 1e-6F;          // that a logarithm is taken of

Rgba8 normalColor(const Color& normal) {
    if (isBlack(normal)) return {};
    const auto byte = [](float x) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5F + 0.5F * x, 0.0F, 1.0F)));
    };
    return {byte(normal.x), byte(normal.y), byte(normal.z)};
}

template <class ToByte>
ByteImage mapped(const ColorImage& values, const ToByte& toByte) {
    ByteImage shown(values.width(), values.height());
    std::transform(values.values().begin(), values.values().end(), shown.values().begin(), toByte);
    return shown;
}

ByteImage objectColors(const ColorImage& ids) {
    std::vector<Rgba8> colors; // of each object, made when first seen
    return mapped(ids, [&](const Color& id) {
        if (id.x < 0) return id.x == static_cast<float>(kLampSurface) ? Rgba8{255, 255, 255} : Rgba8{};
        const auto i = static_cast<std::size_t>(id.x);
        while (colors.size() <= i) colors.push_back(objectColor(static_cast<int>(colors.size())));
        return colors[i];
    });
}

std::string_view channelNames(Quantity quantity) {
    if (quantity == Quantity::Normal) return "XYZ";
    if (quantity == Quantity::Depth) return "Z";
    return isVector(quantity) ? "RGB" : "Y";
}

std::string_view unitOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::Depth:
        return " m";
    case Quantity::Cost:
        return " µs";
    case Quantity::Rays:
        return " rays";
    case Quantity::Visits:
        return " nodes";
    case Quantity::Tests:
        return " tests";
    case Quantity::Samples:
        return " samples";
    default:
        return "";
    }
}

}

bool hasRange(Quantity quantity) { return !isVector(quantity) && quantity != Quantity::Object; }

bool isLogarithmic(Quantity quantity) { return quantity == Quantity::Depth || quantity == Quantity::Samples; }

LayerRange rangeOf(const LayerImage& image) {
    std::vector<float> values;
    for (const Color& value : image.values.values())
        if (std::isfinite(value.x)) values.push_back(value.x);
    if (values.empty()) return {};
    const Quantity quantity = image.layer.quantity;
    const bool toTheHighest = quantity == Quantity::Recursion || quantity == Quantity::Samples;
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    LayerRange range{isLogarithmic(quantity) ? std::max(*lowest, kLeast) : 0, *highest};
    if (!toTheHighest) {
        const auto most = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / kAboveRange);
        std::nth_element(values.begin(), most, values.end());
        range.cut = *most < range.highest;
        range.highest = *most;
    }
    if (!(range.highest > range.lowest)) range.highest = range.lowest + 1;
    return range;
}

double placeIn(const LayerRange& range, Quantity quantity, double value) {
    if (isLogarithmic(quantity))
        return std::log(value / range.lowest) / std::log(range.highest / range.lowest);
    return (value - range.lowest) / (range.highest - range.lowest);
}

double valueAt(const LayerRange& range, Quantity quantity, double place) {
    if (isLogarithmic(quantity)) return range.lowest * std::pow(range.highest / range.lowest, place);
    return range.lowest + (range.highest - range.lowest) * place;
}

Rgba8 rangeColor(Quantity quantity, double value, const LayerRange& range) {
    if (!std::isfinite(value)) return {};
    const double place = placeIn(range, quantity, value);
    return quantity == Quantity::Depth ? depthColor(place) : heatColor(place);
}

ByteImage displayLayer(const LayerImage& image, const LayerRange& range, const DisplaySettings& settings) {
    const Quantity quantity = image.layer.quantity;
    if (isRadiance(quantity)) return display(image.values, settings);
    if (quantity == Quantity::Albedo) return display(image.values, DisplaySettings{});
    if (quantity == Quantity::Normal) return mapped(image.values, normalColor);
    if (quantity == Quantity::Object) return objectColors(image.values);
    return mapped(image.values, [&](const Color& value) { return rangeColor(quantity, value.x, range); });
}

std::string aboutLayer(const Layer& layer) {
    switch (layer.quantity) {
    case Quantity::Picture:
        return "radiance: the picture itself";
    case Quantity::Normal:
        return "normal at the first hit: red, green and blue are x, y and z from -1 to 1";
    case Quantity::Depth:
        return "distance from the eye along the ray";
    case Quantity::Albedo:
        return "diffuse reflectance kd at the first hit";
    case Quantity::Object:
        return "object at the first hit";
    case Quantity::Kind:
        if (layer.index == static_cast<int>(RayKind::Shadow))
            return "light that shadow rays bring from the lamps, on any path";
        return fmt::format("light that {} rays find: ambient, emission, background", layer.name);
    case Quantity::Lamp:
        return fmt::format("light of {}, on any path", layer.name.substr(layer.name.find('.') + 1));
    case Quantity::Rest:
        return "light of no lamp: ambient, emission, background";
    case Quantity::Recursion:
        return "depth of the deepest ray";
    case Quantity::Rays:
        return "rays traced for a sample";
    case Quantity::Visits:
        return "nodes of the index gone into, by all rays of a sample, each traced alone";
    case Quantity::Tests:
        return "triangles and shapes tested, by all rays of a sample, each traced alone";
    case Quantity::Cost:
        return "time to trace a sample";
    case Quantity::Samples:
        return "samples of a pixel: adaptive sampling spends them where the noise is";
    case Quantity::Error:
        return "estimated error: standard error of the luminance";
    }
    throw InternalError("aboutLayer: no such layer");
}

std::string valueText(Quantity quantity, double value) {
    return fmt::format("{:.3g}{}", value, unitOf(quantity));
}

std::string rangeText(const LayerImage& image, const LayerRange& range) {
    const Quantity quantity = image.layer.quantity;
    if (!hasRange(quantity)) return {};
    const bool depth = quantity == Quantity::Depth;
    return fmt::format("{}: {} from {} ({}) to {} ({}){}{}", image.layer.name, aboutLayer(image.layer),
                       valueText(quantity, range.lowest), depth ? "white" : "dark blue",
                       valueText(quantity, range.highest), depth ? "dark grey" : "light yellow",
                       isLogarithmic(quantity) ? ", logarithmic" : "",
                       range.cut ? ", a few pixels beyond" : "");
}

std::vector<ImageChannel> channelsOf(const LayerImage& image) {
    const Quantity quantity = image.layer.quantity;
    const std::string_view names = channelNames(quantity);
    std::vector<ImageChannel> channels;
    channels.reserve(names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        channels.push_back({quantity == Quantity::Picture ? std::string(1, names[i])
                                                          : fmt::format("{}.{}", image.layer.name, names[i]),
                            &image.values, static_cast<int>(i)});
    return channels;
}

}
