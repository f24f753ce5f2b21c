#include "core/study/playback.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr std::array<std::string_view, 6> kCasting = {
    "for each pixel: make the eye ray through it",
    "    find the closest hit of the ray",
    "    if there is none: the pixel is the background",
    "    colour = emission + ambient",
    "    for each lamp: cast a shadow ray towards it",
    "        if nothing blocks it: add the lamp's kd and ks terms"};

constexpr std::array<std::string_view, 10> kRecursive = {
    "for each pixel: colour = trace(eye ray through it, depth 0)",
    "trace(ray, depth):",
    "    find the closest hit of the ray",
    "    if there is none: return the background",
    "    colour = emission + ambient",
    "    for each lamp: cast a shadow ray towards it",
    "        if nothing blocks it: add the lamp's kd and ks terms",
    "    if it mirrors and depth < max: add kr · trace(reflected ray, depth + 1)",
    "    if it transmits and depth < max: add kt · trace(refracted ray, depth + 1)",
    "    return what the medium on the way leaves of colour"};

constexpr std::array<std::string_view, 10> kDistributed = {
    "for each pixel: colour = trace(ray from the lens through it, depth 0)",
    "trace(ray, depth):",
    "    find the closest hit of the ray",
    "    if there is none: return w · sky",
    "    colour = w · emission",
    "    for each lamp and the sky: cast a shadow ray to a random place on it",
    "        if nothing blocks it: add w · f cos · its light / p",
    "    if it mirrors: add f cos / p · trace(random ray about the mirrored one, depth + 1)",
    "    if it transmits: add f cos / p · trace(random ray about the refracted one, depth + 1)",
    "    return what the medium on the way leaves of colour"};

constexpr std::array<std::string_view, 10> kPath = {
    "for each pixel: colour = trace(ray from the lens through it, depth 0)",
    "trace(ray, depth):",
    "    find the closest hit of the ray",
    "    if there is none: return w · sky",
    "    colour = w · emission",
    "    for each lamp and the sky: cast a shadow ray to a random place on it",
    "        if nothing blocks it: add w · f cos · its light / p",
    "    draw one of mirror image, glass and diffuse; from depth 3 on, perhaps stop",
    "    add f cos / p · trace(random ray of that kind, depth + 1)",
    "    return what the medium on the way leaves of colour"};

/// Line numbers in one of the listings.
struct Lines {
    std::size_t eye, closest, background, shadow, lit, reflection, refraction, diffuse;
};

struct Listing {
    std::span<const std::string_view> code;
    Lines lines;
};

Listing listingOf(Method method) {
    switch (method) {
    case Method::Whitted:
        return {kRecursive, {0, 2, 3, 5, 6, 7, 8, 0}};
    case Method::Distributed:
        return {kDistributed, {0, 2, 3, 5, 6, 7, 8, 0}};
    case Method::Path:
        return {kPath, {0, 2, 3, 5, 6, 8, 8, 8}};
    case Method::Local:
    case Method::Cast:
        break;
    }
    return {kCasting, {0, 1, 2, 4, 5, 0, 0, 0}};
}

std::size_t callerOf(RayKind kind, const Lines& lines) {
    if (kind == RayKind::Reflection) return lines.reflection;
    if (kind == RayKind::Refraction) return lines.refraction;
    return kind == RayKind::Diffuse ? lines.diffuse : lines.eye;
}

bool stopsAt(const RayRecord& ray, PlayTo to) {
    if (to == PlayTo::Hit) return ray.end == RayEnd::Hit;
    if (to == PlayTo::Light) return ray.kind == RayKind::Shadow;
    return true;
}

}

int played(const SampleRecord& record, int traced, PlayTo to) {
    const int all = static_cast<int>(record.rays.size());
    const int first = std::min(1, all);
    if (to == PlayTo::Start) return first;
    if (to == PlayTo::Back) return std::max(first, traced - 1);
    if (to == PlayTo::End) return all;
    for (int ray = traced; ray < all; ++ray)
        if (stopsAt(record.rays[static_cast<std::size_t>(ray)], to)) return ray + 1;
    return all;
}

bool stopsIn(const SampleRecord& record, PlayTo to) {
    return std::ranges::any_of(record.rays, [&](const RayRecord& ray) { return stopsAt(ray, to); });
}

SampleRecord firstRays(const SampleRecord& record, int traced) {
    SampleRecord result;
    const auto count = std::min(record.rays.size(), static_cast<std::size_t>(std::max(0, traced)));
    result.rays.assign(record.rays.begin(), record.rays.begin() + static_cast<std::ptrdiff_t>(count));
    const int last = static_cast<int>(count);
    std::ranges::copy_if(record.lamps, std::back_inserter(result.lamps),
                         [&](const LampTerm& lamp) { return lamp.ray < last && lamp.shadowRay < last; });
    std::ranges::copy_if(record.untraced, std::back_inserter(result.untraced),
                         [&](const UntracedRay& ray) { return ray.parent < last; });
    result.physical = record.physical;
    return result;
}

std::span<const std::string_view> pseudoCode(Method method) { return listingOf(method).code; }

std::vector<std::size_t> linesOf(Method method, const RayRecord& ray) {
    const Lines lines = listingOf(method).lines;
    if (ray.kind == RayKind::Shadow)
        return ray.end == RayEnd::Unblocked ? std::vector{lines.shadow, lines.lit}
                                            : std::vector{lines.shadow};
    return {callerOf(ray.kind, lines), ray.end == RayEnd::Hit ? lines.closest : lines.background};
}

}
